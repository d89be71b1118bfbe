#pragma once
// Values on the command line: what they must be, said in one way by all options.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace aomd::cli {

/// The whole text as a number, or nothing.
[[nodiscard]] std::optional<double> parse_number(const std::string& text);

/// The whole text as a whole number, also as "1e3"; nothing for anything else and above 2^53.
[[nodiscard]] std::optional<std::uint64_t> parse_whole_number(const std::string& text);

/// Validators. They say "must be WHAT IS RIGHT, not TEXT" and leave nothing in the help, which has
/// names of values of its own.
[[nodiscard]] CLI::Validator number(const std::string& wanted, std::function<bool(double)> fits);
[[nodiscard]] CLI::Validator positive_number();
[[nodiscard]] CLI::Validator at_least(double low);
[[nodiscard]] CLI::Validator between(double low, double high);
/// More than 0 and less than 180 degrees.
[[nodiscard]] CLI::Validator angle();
/// To transform: "5%" stands for 5 where percent are meant in any case.
[[nodiscard]] CLI::Validator percent();
/// To be used as a transformation: a text like "1e3" becomes "1000", which types of whole numbers
/// can be read from.
[[nodiscard]] CLI::Validator whole_number(std::uint64_t low, std::uint64_t high);
/// Any text but none.
[[nodiscard]] CLI::Validator not_empty();
/// To transform: one of these words, in any case.
[[nodiscard]] CLI::Validator one_of(const std::vector<std::string>& words);

}  // namespace aomd::cli
