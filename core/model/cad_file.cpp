#include "core/model/cad_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

#include "core/base/text.h"
#include "core/model/gmsh_model.h"

namespace aomd {
namespace {

std::string extension_of(const std::string& path) {
  return lower(std::filesystem::path(path).extension().string());
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// A script's words that reach beyond the model. Comments and strings are searched too: refusing one
// that is harmless costs little.
std::string_view forbidden_word(std::string_view text) {
  constexpr std::array<std::string_view, 12> forbidden{"SystemCall", "NonBlockingSystemCall",
                                                       "OnelabRun",  "Include",
                                                       "Merge",      "Save",
                                                       "Print",      "Exit",
                                                       "Abort",      "Plugin",
                                                       "Parse",      "ShapeFromFile"};
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && is_word(text[end])) ++end;
    const std::string_view word = text.substr(i, end - i);
    if (std::find(forbidden.begin(), forbidden.end(), word) != forbidden.end()) return word;
    i = std::max(end, i + 1);
  }
  return {};
}

}  // namespace

bool is_cad_file(const std::string& path) {
  constexpr std::array<std::string_view, 6> known{".step", ".stp", ".brep",
                                                  ".iges", ".igs", ".geo"};
  return std::find(known.begin(), known.end(), extension_of(path)) != known.end();
}

void check_cad_file(const std::string& path) {
  if (!is_cad_file(path))
    throw ModelError(path + ": no CAD file by its name (.step, .stp, .brep, .iges, .igs or .geo)");
  std::error_code unknown;
  if (std::filesystem::is_directory(path, unknown)) throw ModelError(path + ": is a folder");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw ModelError(path + ": " + std::strerror(errno));
  if (extension_of(path) != ".geo") return;
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (const std::string_view word = forbidden_word(text); !word.empty())
    throw ModelError(path + ":" + std::to_string(1 + std::count(text.data(), word.data(), '\n')) +
                     ": uses " + std::string(word) +
                     ", which is not run; let Gmsh write the model as .brep or .step");
}

std::string in_file(const std::string& path, std::string what) {
  const std::string marker = "', line ";
  if (const auto at = what.find(marker); at != std::string::npos)
    return path + ":" + what.substr(at + marker.size());
  what.erase(0, what.find_first_not_of(' '));
  return path + ": " + what;
}

}  // namespace aomd
