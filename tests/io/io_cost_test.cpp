// Files of thousands of small things: what reading, holding and writing them costs grows with them.

#include <functional>

#include "core/io/left_out.h"
#include "core/mesh/mesh.h"
#include "tests/io/cost/counted_compare.h"
#include "tests/io/fuzz/counted_new.h"
#include "tests/support/volume_helpers.h"
#include "tests/support/vtu_texts.h"

namespace aomd::io_cost_test {
namespace {

/// One line for each of n things.
std::string lines(int n, const std::function<std::string(const std::string&)>& line) {
  std::string text;
  for (int i = 0; i < n; ++i) text += line(std::to_string(100000 + i));
  return text;
}

std::string vtk(int n, const std::string& data, const std::string& each) {
  return "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 float\n0 0 0 1 "
         "0 "
         "0 0 1 0\nCELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n" +
         data + '\n' + lines(n, [&](const std::string& i) {
           std::string line = each;
           if (const std::size_t at = line.find('#'); at != std::string::npos)
             line.replace(at, 1, i);
           return line + '\n';
         });
}

std::string vtu_arrays(int n) {
  return test::vtu_file(test::vtu_piece(test::vtu_text, "format=\"ascii\"",
                                        "<CellData>" + lines(n, [](const std::string& i) {
                                          return test::vtu_array("Int32", i, "format=\"ascii\"",
                                                                 "1");
                                        }) + "</CellData>"));
}

std::string vtu_pieces(int n) {
  return test::vtu_file(lines(
      n, [](const std::string&) { return test::vtu_piece(test::vtu_text, "format=\"ascii\""); }));
}

std::string msh(const std::string& sections) {
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n"
         "$Elements\n1\n1 2 2 0 1 1 2 3\n$EndElements\n" +
         sections;
}

std::string views(int n) {
  return msh(lines(n, [](const std::string& i) {
    return "$NodeData\n1\n\"" + i + "\"\n1\n0\n3\n0\n1\n3\n1 5\n2 6\n3 7\n$EndNodeData\n";
  }));
}

std::string sections(int n) {
  return msh(lines(n, [](const std::string& i) { return "$S" + i + "\n$EndS" + i + "\n"; }));
}

std::string su2(int n, const std::string& mark, const std::string& rest) {
  return "NDIME= 2\nNELEM= 1\n5 0 1 2\nNPOIN= 3\n0 0\n1 0\n0 1\n" +
         lines(n, [&](const std::string& i) { return mark + i + rest; });
}

std::string medit(int n) {
  return "MeshVersionFormatted 2\nDimension 3\nVertices 3\n0 0 0 0\n1 0 0 0\n0 1 0 0\nTriangles "
         "1\n1 2 "
         "3 0\n" +
         lines(n, [](const std::string& i) { return "Key" + i + " 0\n"; });
}

struct Kind {
  const char* name;
  std::function<std::string(int)> file;
};

const Kind kinds[] = {
    {"a.vtk", [](int n) { return vtk(n, "POINT_DATA 3", "SCALARS a# int\n1 2 3"); }},
    {"b.vtk", [](int n) { return vtk(n, "POINT_DATA 3", "SCALARS a int\n1 2 3"); }},
    {"c.vtk",
     [](int n) { return vtk(n, "CELL_DATA 1\nFIELD f " + std::to_string(n), "a# 1 1 int\n1"); }},
    {"a.vtu", vtu_arrays},
    {"b.vtu", vtu_pieces},
    {"a.msh", views},
    {"b.msh", sections},
    {"a.su2", [](int n) { return su2(n, "KEY", "= 1\n"); }},
    {"b.su2", [](int n) { return su2(n, "MARKER_TAG= m", "\nMARKER_ELEMS= 1\n3 0 1\n"); }},
    {"a.mesh", medit}};

/// Steps of comparing names from the file to a Mesh and to files again.
std::size_t steps(const Kind& kind, int n) {
  const std::string text = kind.file(n);
  const test::TemporaryFolder folder;
  test::compare_steps = 0;
  const io::ReadResult read = io::read_bytes(kind.name, text);
  MeshData result = to_data(Mesh(read.mesh));
  (void)io::carry_along(read.mesh, result);
  for (const char* out : {"a.vtu", "a.msh", "a.mesh"}) io::write(folder / out, result);
  if (result.regions.empty()) io::write(folder / "a.su2", result);
  return test::compare_steps;
}

/// Trees of names add a logarithm: 1.6 from 1,000 to 64,000.
TEST(Cost, NamesAreLookedUpInProportion) {
  for (const Kind& kind : kinds) {
    const std::size_t few = steps(kind, 1'000), many = steps(kind, 64'000);
    EXPECT_LT(many, 64 * 2 * few + 64'000) << kind.name << ": " << few << " steps for 1000";
  }
}

TEST(Cost, MemoryIsBoundedByTheFile) {
  for (const Kind& kind : kinds) {
    for (const int n : {1'000, 8'000, 64'000}) {
      const std::string text = kind.file(n);
      const std::size_t before = test::live_bytes;
      test::peak_bytes = before;
      (void)io::read_bytes(kind.name, text);
      EXPECT_LT(test::peak_bytes - before, 40 * text.size()) << kind.name << ' ' << n;
    }
  }
}

}  // namespace
}  // namespace aomd::io_cost_test
