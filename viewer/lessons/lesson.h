#pragma once
// Lessons: pages of text, with commands that set the scene, tasks, and what tells that a task is
// done. Their files are described in docs/LESSONS.md.

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/mesh_data.h"

namespace aomd::scene {

/// A piece of a paragraph that is written in one way.
struct TextSpan {
  enum class Kind { Plain, Emphasis, Code, Key, Link };
  Kind kind = Kind::Plain;
  std::string text;
  std::string line;  ///< of a link: the command that it emits
};
using Paragraph = std::vector<TextSpan>;

/// Whether a line begins with the name of a command; where there is none, every line does.
using IsCommand = std::function<bool(std::string_view)>;

/// From `*emphasis*`, `` `code` ``, `{Key}` and `[a link](command)`. Throws std::invalid_argument
/// saying what is not closed, or which link has no such command.
[[nodiscard]] Paragraph parse_paragraph(std::string_view text, const IsCommand& is_command = {});
/// Without marks.
[[nodiscard]] std::string plain_text(const Paragraph& paragraph);

/// A command and where it stands in its file, from 1.
struct LessonLine {
  std::string text;
  std::size_t number = 0;
};

/// One point of a task: it is met while all of its expectations hold.
struct LessonCheck {
  Paragraph label;
  std::vector<LessonLine> expectations;
};

struct LessonPage {
  std::string title;
  std::vector<Paragraph> text;
  std::vector<LessonLine> commands;  ///< carried out on entering it
  std::vector<Paragraph> task;       ///< empty: there is nothing to do
  Paragraph hint;
  std::vector<LessonCheck> checks;
  std::vector<LessonLine> solution;  ///< after them every check is met
};

struct Lesson {
  std::string file;   ///< "01-stored.lesson"
  std::string name;   ///< "stored": what the command `lesson` takes
  std::string title;  ///< "What a mesh database stores"
  std::string about;  ///< one line
  int minutes = 0;
  std::map<std::string, std::shared_ptr<const MeshData>> meshes;  ///< by name: "fan.ply"
  std::vector<LessonPage> pages;
};

/// Throws io::ReadError that names file and line.
[[nodiscard]] Lesson parse_lesson(const std::string& file, std::string_view text,
                                  const IsCommand& is_command = {});

/// Those of the program, in their order; read once.
[[nodiscard]] std::span<const Lesson> lessons();
/// Null where there is none of that name.
[[nodiscard]] const Lesson* find_lesson(std::string_view name);

}  // namespace aomd::scene
