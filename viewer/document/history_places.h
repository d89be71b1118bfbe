#pragma once
// Places of a history that one jumps to: where commands and phases begin.

#include <cstddef>
#include <string>

#include "viewer/document/document.h"

namespace aomd::scene {

/// Where the command after the present place begins, or the end of the history; where the one
/// before it begins, or 0.
[[nodiscard]] std::size_t next_command(const Document& document);
[[nodiscard]] std::size_t previous_command(const Document& document);
/// Where the phase after the present place begins, or the one before it: operations of one kind in
/// a row, of one command. O(operations in between).
[[nodiscard]] std::size_t next_phase(const Document& document);
[[nodiscard]] std::size_t previous_phase(const Document& document);

/// The present place in words: "operation 12 of 4,000".
[[nodiscard]] std::string place_words(const Journal& journal);

}  // namespace aomd::scene
