#include "viewer/lessons/lesson.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "core/io/io.h"
#include "viewer/lessons/lesson_texts.h"

namespace aomd::scene {
namespace {

constexpr int most_minutes = 60;

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

/// What a page lacks, as the end of a sentence; "" where nothing is missing.
std::string defect_of(const LessonPage& page) {
  if (page.text.empty()) return "no text";
  if (page.task.empty() != page.checks.empty())
    return "a task without checks, or checks without a task";
  if (page.checks.empty() != page.solution.empty())
    return "checks without a solution, or a solution without checks";
  for (const LessonCheck& check : page.checks)
    if (check.expectations.empty()) return "a check that expects nothing";
  return "";
}

std::string defect_of(const Lesson& lesson) {
  if (lesson.title.empty()) return "there is no @lesson";
  if (lesson.about.empty()) return "there is no @about";
  if (lesson.minutes == 0) return "there are no @minutes";
  if (lesson.pages.empty()) return "there is no @page";
  for (const LessonPage& page : lesson.pages)
    if (const std::string what = defect_of(page); !what.empty())
      return "the page '" + page.title + "' has " + what;
  return "";
}

/// Reads a file from top to bottom: a line that begins with @ says what the lines below it are.
class LessonReader {
 public:
  LessonReader(const std::string& file, std::string_view text, const IsCommand& is_command)
      : text_(text), is_command_(is_command) {
    lesson_.file = file;
    const std::size_t dash = file.find('-');
    const std::size_t begin = dash == std::string::npos ? 0 : dash + 1;
    lesson_.name = file.substr(begin, file.rfind('.') - begin);
  }

  Lesson read() {
    while (!text_.empty()) {
      const std::size_t end = std::min(text_.find('\n'), text_.size());
      const std::string_view line = text_.substr(0, end);
      text_.remove_prefix(std::min(end + 1, text_.size()));
      ++number_;
      !line.empty() && line.front() == '@' ? directive(line.substr(1)) : content(line);
    }
    close_section();
    ++number_;
    if (const std::string what = defect_of(lesson_); !what.empty()) fail(what);
    return std::move(lesson_);
  }

 private:
  enum class Section { Head, Mesh, Text, Do, Task, Hint, Check, Solution };

  [[noreturn]] void fail(const std::string& what, std::size_t line) const {
    throw io::ReadError(lesson_.file, {line, {}}, what);
  }
  [[noreturn]] void fail(const std::string& what) const { fail(what, number_); }

  LessonPage& page(std::string_view for_what) {
    if (lesson_.pages.empty()) fail("@" + std::string(for_what) + " stands before the first @page");
    return lesson_.pages.back();
  }

  void directive(std::string_view line) {
    close_section();
    const std::size_t end = std::min(line.find_first_of(" \t\r"), line.size());
    const std::string_view word = line.substr(0, end);
    const std::string rest(trimmed(line.substr(end)));
    if (word == "lesson" || word == "about" || word == "minutes") return head(word, rest);
    if (word == "mesh") return begin_mesh(rest);
    if (word == "page") return begin_page(rest);
    if (word == "check") return begin_check(rest);
    constexpr std::pair<std::string_view, Section> plain[] = {{"do", Section::Do},
                                                              {"task", Section::Task},
                                                              {"hint", Section::Hint},
                                                              {"solution", Section::Solution}};
    for (const auto& [name, section] : plain) {
      if (word != name) continue;
      if (!rest.empty()) fail("nothing may follow @" + std::string(word));
      static_cast<void>(page(word));
      section_ = section;
      return;
    }
    fail("'@" + std::string(word) +
         "' is none of @lesson, @about, @minutes, @mesh, @page, @do, @task, @hint, "
         "@check, @solution");
  }

  void head(std::string_view word, const std::string& rest) {
    if (!lesson_.pages.empty()) fail("@" + std::string(word) + " stands above the first @page");
    if (rest.empty()) fail("@" + std::string(word) + " says nothing");
    section_ = Section::Head;
    if (word == "lesson") lesson_.title = rest;
    if (word == "about") lesson_.about = rest;
    if (word != "minutes") return;
    const auto [end, error] =
        std::from_chars(rest.data(), rest.data() + rest.size(), lesson_.minutes);
    if (error != std::errc{} || end != rest.data() + rest.size() || lesson_.minutes < 1 ||
        lesson_.minutes > most_minutes)
      fail("'" + rest + "' is not a number of minutes from 1 to 60");
  }

  void begin_mesh(const std::string& name) {
    if (name.empty()) fail("@mesh has no name");
    if (lesson_.meshes.contains(name)) fail("there is a mesh " + name + " already");
    section_ = Section::Mesh;
    mesh_name_ = name;
    mesh_line_ = number_;
    mesh_text_.clear();
  }

  void begin_page(const std::string& title) {
    if (title.empty()) fail("@page has no title");
    lesson_.pages.emplace_back().title = title;
    section_ = Section::Text;
  }

  void begin_check(const std::string& label) {
    if (label.empty()) fail("@check has no label");
    page("check").checks.push_back({paragraph(label, number_), {}});
    section_ = Section::Check;
  }

  void content(std::string_view raw) {
    if (section_ == Section::Mesh) {
      mesh_text_.append(raw).append("\n");
      return;
    }
    const std::string line(trimmed(raw));
    if (section_ == Section::Text || section_ == Section::Task || section_ == Section::Hint)
      return text_line(line);
    if (line.empty() || line.front() == '#') return;
    if (section_ == Section::Head) fail("this line belongs to no page");
    if (is_command_ && !is_command_(line)) fail("there is no command '" + line + "'");
    if (section_ == Section::Check && line.rfind("expect ", 0) != 0)
      fail("a check consists of expect lines");
    lines().push_back({line, number_});
  }

  std::vector<LessonLine>& lines() {
    LessonPage& present = lesson_.pages.back();
    if (section_ == Section::Check) return present.checks.back().expectations;
    return section_ == Section::Do ? present.commands : present.solution;
  }

  /// Lines make a paragraph until an empty one ends it.
  void text_line(const std::string& line) {
    if (line.empty()) return close_paragraph();
    if (collected_.empty()) paragraph_line_ = number_;
    collected_ += (collected_.empty() ? "" : " ") + line;
  }

  Paragraph paragraph(const std::string& text, std::size_t line) const {
    try {
      return parse_paragraph(text, is_command_);
    } catch (const std::invalid_argument& error) {
      fail(error.what(), line);
    }
  }

  void close_paragraph() {
    if (collected_.empty()) return;
    Paragraph result = paragraph(collected_, paragraph_line_);
    collected_.clear();
    LessonPage& present = lesson_.pages.back();
    if (section_ == Section::Hint) {
      if (!present.hint.empty()) fail("a hint is one paragraph", paragraph_line_);
      present.hint = std::move(result);
    } else if (section_ == Section::Text) {
      present.text.push_back(std::move(result));
    } else if (section_ == Section::Task) {
      present.task.push_back(std::move(result));
    }
  }

  void close_section() {
    close_paragraph();
    if (section_ == Section::Mesh) close_mesh();
  }

  void close_mesh() {
    try {
      auto mesh = io::read_bytes(mesh_name_, mesh_text_).mesh;
      if (mesh.faces.empty() && mesh.regions.empty())
        fail("the mesh " + mesh_name_ + " has no faces or regions", mesh_line_);
      lesson_.meshes.emplace(mesh_name_, std::make_shared<const MeshData>(std::move(mesh)));
    } catch (const io::FileError& error) {
      if (std::string_view(error.what()).rfind(lesson_.file + ":", 0) == 0) throw;
      fail(error.what(), mesh_line_);
    }
    section_ = Section::Head;
  }

  std::string_view text_;
  const IsCommand& is_command_;
  Lesson lesson_;
  Section section_ = Section::Head;
  std::size_t number_ = 0;
  std::string mesh_name_, mesh_text_;
  std::size_t mesh_line_ = 0;
  std::string collected_;  ///< the paragraph that is being read
  std::size_t paragraph_line_ = 0;
};

}  // namespace

Lesson parse_lesson(const std::string& file, std::string_view text, const IsCommand& is_command) {
  return LessonReader(file, text, is_command).read();
}

std::span<const Lesson> lessons() {
  static const std::vector<Lesson> all = [] {
    std::vector<Lesson> list;
    for (const EmbeddedText& each : embedded_texts())
      list.push_back(parse_lesson(std::string(each.name), each.text));
    return list;
  }();
  return all;
}

const Lesson* find_lesson(std::string_view name) {
  const auto all = lessons();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Lesson& l) { return l.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace aomd::scene
