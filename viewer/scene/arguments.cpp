#include "viewer/scene/arguments.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/mesh/handle.h"
#include "viewer/scene/commands.h"
#include "viewer/scene/text.h"

namespace aomd::scene {
namespace {

template <typename T>
std::optional<T> parse(std::string_view word) {
  T value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return {};
  return value;
}

}  // namespace

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
  while (!text_.empty() && (text_.front() == ' ' || text_.front() == '\t')) text_.remove_prefix(1);
}

bool Arguments::done() {
  skip_blanks();
  return text_.empty();
}

std::string Arguments::word(std::string_view what) {
  if (done()) fail("give " + std::string(what));
  const bool quoted = text_.front() == '"';
  if (quoted) text_.remove_prefix(1);
  const std::size_t end = quoted ? text_.find('"') : text_.find_first_of(" \t");
  if (quoted && end == std::string_view::npos) fail("a quote is not closed");
  const std::string result(text_.substr(0, end));
  text_.remove_prefix(
      std::min(text_.size(), end == std::string_view::npos ? end : end + (quoted ? 1 : 0)));
  return result;
}

std::string Arguments::rest(std::string_view what) {
  if (done()) fail("give " + std::string(what));
  std::string_view all = text_;
  text_ = {};
  if (all.size() > 1 && all.front() == '"' && all.back() == '"')
    all = all.substr(1, all.size() - 2);
  return std::string(all);
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

std::optional<int> level_named(std::string_view word) {
  for (int level = 0; level < 4; ++level)
    if (word == entity_name(level)) return level;
  return {};
}

std::string model_entity_text(ModelRef ref) {
  if (!ref.valid()) return {};
  return std::string(entity_name(ref.dimension())) + ":" + std::to_string(ref.tag());
}

}  // namespace aomd::scene
