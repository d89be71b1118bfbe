#include "viewer/commands/arguments.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/mesh/handle.h"
#include "viewer/base/text.h"
#include "viewer/commands/command_error.h"

namespace aomd::scene {
namespace {

template <typename T>
std::optional<T> parse(std::string_view word) {
  T value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return {};
  return value;
}

bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// Where the quote that a text begins with is closed; npos where it is not.
std::size_t closing_quote(std::string_view text) {
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (text[i] == '"') return i;
    if (text[i] == '\\') ++i;
  }
  return std::string_view::npos;
}

/// A backslash that stands before nothing special is one.
std::string unquoted(std::string_view inside) {
  std::string text;
  for (std::size_t i = 0; i < inside.size(); ++i) {
    const char next = inside[i] == '\\' && i + 1 < inside.size() ? inside[i + 1] : '\0';
    const bool escape = next == '"' || next == '\\' || next == 'n';
    text += !escape ? inside[i] : next == 'n' ? '\n' : next;
    i += escape ? 1 : 0;
  }
  return text;
}

}  // namespace

std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c == '\n' ? std::string("\\n") : std::string(1, c);
  }
  return result + '"';
}

std::string as_rest(const std::string& text) {
  const bool plain = text.find_first_of("\"#\n\r") == std::string::npos && !text.empty() &&
                     !is_blank(text.front()) && !is_blank(text.back());
  return plain ? text : in_quotes(text);
}

std::string_view without_comment(std::string_view line) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0 && !is_blank(line[i - 1])) continue;
    if (line[i] == '#') return line.substr(0, i);
    if (line[i] != '"') continue;
    const std::size_t length = closing_quote(line.substr(i));
    if (length == std::string_view::npos) return line;
    i += length;
  }
  return line;
}

Arguments::Arguments(std::string_view command, std::string_view usage, std::string_view text)
    : command_(command), usage_(usage), text_(text) {
  while (!text_.empty() && (text_.back() == ' ' || text_.back() == '\t' || text_.back() == '\r'))
    text_.remove_suffix(1);
}

void Arguments::fail(const std::string& why) const {
  const std::string gap = usage_.empty() ? "" : " ";
  throw CommandError(command_ + ": " + why + " (usage: " + command_ + gap + usage_ + ")");
}

void Arguments::skip_blanks() {
  while (!text_.empty() && is_blank(text_.front())) text_.remove_prefix(1);
}

bool Arguments::done() {
  skip_blanks();
  return text_.empty();
}

std::string Arguments::word(std::string_view what) {
  if (done()) fail("give " + std::string(what));
  const bool has_quotes = text_.front() == '"';
  const std::size_t end = has_quotes ? closing_quote(text_) : text_.find_first_of(" \t");
  if (has_quotes && end == std::string_view::npos) fail("a quote is not closed");
  const std::string_view whole = text_.substr(0, has_quotes ? end + 1 : end);
  text_.remove_prefix(whole.size());
  return has_quotes ? unquoted(whole.substr(1, end - 1)) : std::string(whole);
}

std::string Arguments::rest(std::string_view what) {
  if (done()) fail("give " + std::string(what));
  const std::string_view all = std::exchange(text_, {});
  if (all.front() != '"') return std::string(all);
  if (closing_quote(all) + 1 == all.size()) return unquoted(all.substr(1, all.size() - 2));
  const bool ends_in_one = all.size() > 1 && all.back() == '"';
  return std::string(ends_in_one ? all.substr(1, all.size() - 2) : all);
}

double Arguments::number(std::string_view what) {
  const std::string text = word(what);
  const auto value = parse<double>(text);
  if (!value || !std::isfinite(*value)) fail("'" + text + "' is not " + std::string(what));
  return *value;
}

double Arguments::number(std::string_view what, double low, double high) {
  const double value = number(what);
  if (value < low || value > high)
    fail(std::string(what) + " lies between " + short_number(low) + " and " + short_number(high));
  return value;
}

long long Arguments::integer(std::string_view what) {
  const std::string text = word(what);
  const auto value = parse<long long>(text);
  if (!value) fail("'" + text + "' is not " + std::string(what));
  return *value;
}

long long Arguments::integer(std::string_view what, long long low, long long high) {
  const double value = number(what, static_cast<double>(low), static_cast<double>(high));
  if (value != std::trunc(value))
    fail(std::string(what) + " is whole: " + significant(value) + " is not");
  return static_cast<long long>(value);
}

std::string Arguments::one_of(const std::vector<std::string_view>& words) {
  std::string result = word(joined(words, " or "));
  if (std::find(words.begin(), words.end(), result) == words.end())
    fail("'" + result +
         (words.size() == 2 ? "' is neither " + joined(words, " nor ")
                            : "' is none of " + joined(words, ", ")));
  return result;
}

int Arguments::level(int lowest) {
  std::vector<std::string_view> names;
  for (int level = lowest; level < 4; ++level) names.emplace_back(entity_name(level));
  return level_named(one_of(names)).value();
}

bool Arguments::flag(bool present) {
  if (done()) return !present;
  const std::string text = word("on, off or toggle");
  if (text == "on") return true;
  if (text == "off") return false;
  if (text == "toggle") return !present;
  fail("'" + text + "' is neither on, off nor toggle");
}

glm::ivec2 Arguments::size() {
  const std::string text = word("a size");
  const std::size_t x = text.find('x');
  const auto width = parse<int>(std::string_view(text).substr(0, x));
  const auto height =
      x == std::string::npos ? std::nullopt : parse<int>(std::string_view(text).substr(x + 1));
  if (!width || !height || *width < 1 || *height < 1 || *width > 16384 || *height > 16384)
    fail("'" + text + "' is not a size like 1280x800");
  return {*width, *height};
}

ModelRef Arguments::model_entity() {
  const std::string text = word("a model entity like face:3");
  const std::size_t colon = text.find(':');
  const auto dim = level_named(std::string_view(text).substr(0, colon));
  const auto tag = colon == std::string::npos
                       ? std::nullopt
                       : parse<std::int32_t>(std::string_view(text).substr(colon + 1));
  if (!dim || !tag || *tag < ModelRef::min_tag || *tag > ModelRef::max_tag)
    fail("'" + text + "' is not a model entity like face:3");
  return ModelRef(*dim, *tag);
}

void Arguments::end() {
  if (!done()) fail("'" + std::string(text_) + "' is too much");
}

}  // namespace aomd::scene
