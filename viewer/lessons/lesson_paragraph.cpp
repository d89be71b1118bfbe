// The few marks of a lesson's text.

#include <algorithm>
#include <stdexcept>

#include "viewer/lessons/lesson.h"

namespace aomd::scene {
namespace {

struct Mark {
  char open, close;
  TextSpan::Kind kind;
  const char* name;
};
constexpr Mark marks[] = {{'*', '*', TextSpan::Kind::Emphasis, "an emphasis"},
                          {'`', '`', TextSpan::Kind::Code, "code"},
                          {'{', '}', TextSpan::Kind::Key, "a key"},
                          {'[', ']', TextSpan::Kind::Link, "a link"}};

const Mark* mark_at(char c) {
  const auto found =
      std::find_if(std::begin(marks), std::end(marks), [c](const Mark& m) { return m.open == c; });
  return found == std::end(marks) ? nullptr : found;
}

/// Up to `close`, which is taken too.
std::string until(std::string_view& text, char close, const char* what) {
  const std::size_t end = text.find(close);
  if (end == std::string_view::npos)
    throw std::invalid_argument(std::string(what) + " is not closed");
  if (end == 0) throw std::invalid_argument(std::string(what) + " is empty");
  std::string inside(text.substr(0, end));
  text.remove_prefix(end + 1);
  return inside;
}

TextSpan marked(std::string_view& text, const Mark& mark, const IsCommand& is_command) {
  text.remove_prefix(1);
  TextSpan span{mark.kind, until(text, mark.close, mark.name), {}};
  if (mark.kind != TextSpan::Kind::Link) return span;
  if (text.empty() || text.front() != '(')
    throw std::invalid_argument("the link '" + span.text + "' has no (command)");
  text.remove_prefix(1);
  span.line = until(text, ')', "a link's command");
  if (is_command && !is_command(span.line))
    throw std::invalid_argument("there is no command '" + span.line + "'");
  return span;
}

}  // namespace

Paragraph parse_paragraph(std::string_view text, const IsCommand& is_command) {
  Paragraph spans;
  while (!text.empty()) {
    if (const Mark* mark = mark_at(text.front())) {
      spans.push_back(marked(text, *mark, is_command));
      continue;
    }
    const std::size_t end = std::min(text.find_first_of("*`{["), text.size());
    spans.push_back({TextSpan::Kind::Plain, std::string(text.substr(0, end)), {}});
    text.remove_prefix(end);
  }
  return spans;
}

std::string plain_text(const Paragraph& paragraph) {
  std::string text;
  for (const TextSpan& span : paragraph) text += span.text;
  return text;
}

}  // namespace aomd::scene
