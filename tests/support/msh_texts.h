#pragma once
// MSH files as text, piece by piece.

#include <string>
#include <string_view>

#include "tests/support/io_helpers.h"

namespace aomd::test::msh {

inline io::ReadResult read(std::string_view bytes) { return io::read_bytes("a.msh", bytes); }
inline MeshData mesh_of(std::string_view bytes) { return read(bytes).mesh; }

inline bool noted(const io::ReadResult& result, const std::string& part) {
  for (const std::string& note : result.notes)
    if (note.find(part) != std::string::npos) return true;
  return false;
}

inline std::string section(const std::string& name, const std::string& content) {
  return "$" + name + "\n" + content + "$End" + name + "\n";
}

inline const std::string format4 = section("MeshFormat", "4.1 0 8\n");
inline const std::string format2 = section("MeshFormat", "2.2 0 8\n");
inline const std::string entities4 =
    section("Entities",
            "1 1 1 1\n7 0.5 0 0 1 5\n3 0 0 0 1 0 0 0 2 7 -8\n4 0 0 0 1 1 0 2 1 -2 0\n"
            "9 0 0 0 1 1 1 0 1 -4\n");
/// A tetrahedron 1 2 3 4 whose vertices lie on a model vertex, edge, face and region.
inline const std::string nodes4 =
    section("Nodes",
            "4 4 1 4\n0 7 0 1\n1\n0 0 0\n1 3 0 1\n2\n1 0 0\n2 4 0 1\n3\n0 1 0\n"
            "3 9 0 1\n4\n0 0 1\n");
inline const std::string elements4 =
    section("Elements",
            "4 4 1 4\n0 7 15 1\n1 1\n1 3 1 1\n2 1 2\n2 4 2 1\n3 1 2 3\n3 9 4 1\n"
            "4 1 2 3 4\n");
inline const std::string nodes2 = section("Nodes", "4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n");

}  // namespace aomd::test::msh
