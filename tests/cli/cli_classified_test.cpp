// aomd decimate on surfaces whose files classify triangles and not their borders, as mesh
// generators write them: what lies on model faces keeps its area, whatever format it came in and
// goes to.

#include <array>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>

#include "core/io/io.h"
#include "tests/support/cli_helpers.h"

namespace aomd::test::cli_classified_test {
namespace {

constexpr int cells = 20;  // a plate of 20 by 20 squares, two triangles each

// The material of a triangle: 1, or 2 in the right half where there are two.
int material(int i, int materials) { return materials == 2 && 2 * i >= cells ? 2 : 1; }

std::string msh2(int materials) {
  std::string nodes, elements;
  int count = 0;
  for (int j = 0, n = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i)
      nodes += std::to_string(++n) + ' ' + std::to_string(i) + ' ' + std::to_string(j) + " 0\n";
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      const int v = j * (cells + 1) + i + 1, up = v + cells + 1;
      for (const auto& t : {std::array{v, v + 1, up + 1}, std::array{v, up + 1, up}}) {
        const std::string tag = std::to_string(material(i, materials));
        elements += std::to_string(++count) + " 2 2 " + tag + ' ' + tag;
        for (const int corner : t) elements += ' ' + std::to_string(corner);
        elements += '\n';
      }
    }
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" +
         std::to_string((cells + 1) * (cells + 1)) + '\n' + nodes + "$EndNodes\n$Elements\n" +
         std::to_string(count) + '\n' + elements + "$EndElements\n";
}

std::string medit(int materials) {
  std::string vertices, triangles;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i)
      vertices += std::to_string(i) + ' ' + std::to_string(j) + " 0 7\n";
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      const int v = j * (cells + 1) + i + 1, up = v + cells + 1;
      for (const auto& t : {std::array{v, v + 1, up + 1}, std::array{v, up + 1, up}}) {
        for (const int corner : t) triangles += std::to_string(corner) + ' ';
        triangles += std::to_string(material(i, materials)) + '\n';
      }
    }
  return "MeshVersionFormatted 2\nDimension 3\nVertices\n" +
         std::to_string((cells + 1) * (cells + 1)) + '\n' + vertices + "Triangles\n" +
         std::to_string(2 * cells * cells) + '\n' + triangles + "End\n";
}

std::string ply(int materials) {
  std::string vertices, faces;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i)
      vertices += std::to_string(i) + ' ' + std::to_string(j) + " 0 2 1\n";
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      const int v = j * (cells + 1) + i, up = v + cells + 1;
      for (const auto& t : {std::array{v, v + 1, up + 1}, std::array{v, up + 1, up}}) {
        faces += '3';
        for (const int corner : t) faces += ' ' + std::to_string(corner);
        faces += " 2 " + std::to_string(material(i, materials)) + '\n';
      }
    }
  const std::string classes = "property int model_dimension\nproperty int model_tag\n";
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string((cells + 1) * (cells + 1)) +
         "\nproperty double x\nproperty double y\nproperty double z\n" + classes + "element face " +
         std::to_string(2 * cells * cells) + "\nproperty list uchar int vertex_indices\n" +
         classes + "end_header\n" + vertices + faces;
}

// Area by tag of the model face.
std::map<std::int32_t, double> areas(const std::filesystem::path& file) {
  const MeshData mesh = io::read(file).mesh;
  std::map<std::int32_t, double> sum;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const std::uint32_t* v = &mesh.faces.vertices[3 * f];
    const glm::dvec3 a = mesh.positions[v[0]],
                     n = glm::cross(mesh.positions[v[1]] - a, mesh.positions[v[2]] - a);
    sum[mesh.faces.classes.empty() ? 0 : mesh.faces.classes[f].tag()] += glm::length(n) / 2;
  }
  return sum;
}

class ClassifiedCommand : public CommandLine {
 protected:
  void expect_kept(const std::string& input, const std::string& output,
                   const std::string& options) const {
    SCOPED_TRACE(input + " to " + output + ' ' + options);
    const Outcome run = aomd("decimate " + input + ' ' + output + " --report r.json " + options);
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(json("r.json")["output"]["euler"], 1);
    EXPECT_EQ(aomd("check " + output).code, 0);
    const auto before = areas(at(input)), after = areas(at(output));
    ASSERT_EQ(before.size(), after.size());
    for (const auto& [tag, area] : before) EXPECT_NEAR(after.at(tag), area, 1e-9) << "tag " << tag;
  }
};

TEST_F(ClassifiedCommand, PlatesKeepTheAreaOfEachMaterial) {
  for (const int materials : {1, 2}) {
    put("plate.msh", msh2(materials));
    put("plate.mesh", medit(materials));
    put("plate.ply", ply(materials));
    for (const char* input : {"plate.msh", "plate.mesh", "plate.ply"})
      for (const char* options :
           {"", "--target-faces 60", "--strategy paper", "--max-distance 1 --coarsest",
            "--topology paper --target-faces 60", "--snap model --target-faces 60"})
        expect_kept(input, "out.ply", options);
    for (const char* output : {"out.msh", "out.mesh", "out.vtk", "out.vtu"})
      expect_kept("plate.msh", output, "--target-faces 60");
  }
}

// The border is as free to coarsen as that of the same plate without any class.
TEST_F(ClassifiedCommand, BordersCoarsenLikeThoseOfUnclassifiedPlates) {
  put("plate.msh", msh2(1));
  ASSERT_EQ(aomd("convert plate.msh plain.off").code, 0);
  for (const char* input : {"plate.msh", "plain.off"})
    ASSERT_EQ(aomd(std::string("decimate ") + input + " o.ply --target-faces 40 --report " + input +
                   ".json")
                  .code,
              0);
  EXPECT_LE(json("plate.msh.json")["output"]["boundary_edges"], 40);
  EXPECT_EQ(json("plate.msh.json")["output"], json("plain.off.json")["output"]);
}

}  // namespace
}  // namespace aomd::test::cli_classified_test
