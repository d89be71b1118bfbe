#pragma once
// The keys of a case: one row each, for reading them and for saying which there are.

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include <toml++/toml.h>

#include "viewer/suite/suite.h"

namespace aomd::suite {

/// What is wrong in a suite, and on which line.
class WrongEntry : public std::runtime_error {
 public:
  WrongEntry(const toml::node& at, const std::string& what)
      : std::runtime_error(what), line(static_cast<int>(at.source().begin.line)) {}
  int line;
};

/// Throws WrongEntry for a key that is none of `known`.
void refuse_unknown(const toml::table& table, std::span<const std::string_view> known);

/// Sets what a table says of a case, and leaves the rest. Throws WrongEntry.
void apply_keys(const toml::table& table, Case& into);

/// Throws WrongEntry for what is wrong with no key by itself; `at` is where the case stands.
void check_case(const toml::node& at, const Case& each);

/// The text of a node; throws WrongEntry where it is none.
[[nodiscard]] std::string text_of(std::string_view key, const toml::node& node);

}  // namespace aomd::suite
