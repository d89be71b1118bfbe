#pragma once
// What is known of a CAD file before Gmsh sees it.

#include <string>

namespace aomd {

/// Throws ModelError where a CAD file has an unknown extension, cannot be read, or is a .geo script
/// that does more than describe a model: starts programs, reads or writes files, or ends the
/// process.
void check_cad_file(const std::string& path);

/// What Gmsh says is wrong with a file, as one line "FILE:LINE: what" or "FILE: what".
[[nodiscard]] std::string in_file(const std::string& path, std::string what);

}  // namespace aomd
