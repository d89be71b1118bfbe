// Thousands of damaged small files through every reader: no crash, no hang, no large allocation.
// The mutations are the same on every run.

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

#include "core/io/io.h"
#include "core/samples/numeric.h"
#include "core/samples/samples.h"
#include "tests/io/fuzz/counted_new.h"
#include "tests/support/volume_helpers.h"
#include "tests/support/vtu_texts.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace aomd {
namespace {

constexpr std::size_t largest_allocation = 64u << 20;

class Random {
 public:
  std::uint64_t below(std::uint64_t n) {
    return static_cast<std::uint64_t>((sample::hashed(state_++) + 1) / 2 * static_cast<double>(n));
  }

 private:
  std::uint64_t state_ = 0;
};

/// Files that may hold regions, written and by hand.
void add_volume_seeds(std::vector<std::string>& files) {
  const test::TemporaryFolder folder;
  MeshData mesh = test::one_of_each();
  mesh.attributes = {{"medit:normal", 0, 3, false, std::vector<double>(36, 1)},
                     {"medit:required", 2, 1, true, {0, 1}},
                     {"region", 3, 1, true, {1, 2, 3, 4}}};
  for (const auto& [name, binary] : {std::pair{"a.vtk", false},
                                     {"a.vtk", true},
                                     {"a.vtu", false},
                                     {"a.vtu", true},
                                     {"a.mesh", false},
                                     {"a.meshb", true},
                                     {"a.su2", false}}) {
    io::write(folder / name, mesh, {.binary = binary});
    files.push_back(test::bytes_of(folder / name));
  }
  files.push_back(test::vtu_file(test::vtu_piece(test::vtu_zlib, "format=\"binary\""), test::zlib));
  files.push_back(test::vtu_appended(test::vtu_zlib_wide, test::zlib_wide));
  files.push_back(test::vtu_appended(test::vtu_base64_big, test::big_wide));
  files.emplace_back(
      "# vtk DataFile Version 5.1\nt\nASCII\nDATASET POLYDATA\nPOINTS 5 float\n0 0 0 2 0 0 2 2 0 1 "
      "3 0 0 2 "
      "0\n"
      "POLYGONS 3 9\nOFFSETS vtktypeint64\n0 5 9\nCONNECTIVITY vtktypeint64\n0 1 2 3 4 0 1 2 "
      "4\nTRIANGLE_STRIPS 2 4\n"
      "OFFSETS vtktypeint64\n0 4\nCONNECTIVITY vtktypeint64\n0 1 2 3\nCELL_DATA 3\nSCALARS "
      "material int\n"
      "LOOKUP_TABLE d\n1 2 3\nPOINT_DATA 5\nCOLOR_SCALARS c 1\n0 1 0 1 0\nMETADATA\nINFORMATION "
      "0\n\n");
  files.emplace_back(
      "MeshVersionFormatted 2\nDimension 2\nVertices 3\n0 0 1\n1 0 0\n0 1 0\nTriangles 1 1 2 3 "
      "4\nCorners 1 "
      "1\n"
      "Ridges 1 1\nEdges 1 1 2 3\nTangents 1 0 1\nTangentAtVertices 1 1 1\nBox 1 2\nEnd");
  for (const char* grid :
       {"STRUCTURED_POINTS\nDIMENSIONS 3 2 2\nORIGIN 0 0 0\nSPACING 1 1 1\n",
        "RECTILINEAR_GRID\nDIMENSIONS 3 2 1\nX_COORDINATES 3 float\n0 1 2\n"
        "Y_COORDINATES 2 float\n0 1\nZ_COORDINATES 1 int\n5\n",
        "STRUCTURED_GRID\nDIMENSIONS 2 2 1\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 1 1 0\n"})
    files.push_back("# vtk DataFile Version 3.0\nt\nASCII\nDATASET " + std::string(grid) +
                    "CELL_DATA 2\nSCALARS s int\nLOOKUP_TABLE d\n1 2\n");
  files.emplace_back(
      "MeshVersionFormatted 2\nDimension 3\nVertices 6\n0 0 0 0\n2 0 0 0\n0 2 0 0\n1 0 0 0\n1 1 0 "
      "0\n"
      "0 1 0 0\nTrianglesP2 1\n1 2 3 4 5 6 3\nEdgesP2Ordering 3\n0\n2\n1\nRequiredTriangles 1 "
      "1\nEnd");
  const std::string zone =
      "NDIME= 2\nNELEM= 1\n5 0 1 2\nNPOIN= 3\n0 0 0.5 0\n1 0 0.5 1\n0 1 0.5 2\nNMARK= 0\n";
  files.push_back("NZONE= 2\nIZONE= 1\n" + zone + "IZONE= 2\n" + zone);
  files.emplace_back(
      "NDIME= 2\nNELEM= 1\n9 0 1 2 3 0\nNPOIN= 4\n0 0 0\n1 0 1\n1 1 2\n0 1 3\nNMARK= "
      "1\nMARKER_TAG= a\n"
      "MARKER_ELEMS= 1\n3 0 1\nFFD_NBOX= 1\n0 0\n");
}

std::vector<std::string> seeds() {
  const test::TemporaryFolder folder;
  std::vector<std::string> files;
  for (const auto& [name, binary] : {std::pair{"a.ply", false},
                                     {"a.ply", true},
                                     {"a.obj", false},
                                     {"a.off", false},
                                     {"a.off", true},
                                     {"a.stl", false},
                                     {"a.stl", true}}) {
    io::write(folder / name, make_sample("box", 1), {.binary = binary});
    files.push_back(test::bytes_of(folder / name));
  }
  for (const bool binary : {false, true}) {
    for (const bool msh2 : {false, true}) {
      io::write(folder / "a.msh", make_sample("box", 1), {.binary = binary, .msh2 = msh2});
      files.push_back(test::bytes_of(folder / "a.msh"));
    }
  }
  files.emplace_back(
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 1 \"b\"\n$EndPhysicalNames\n"
      "$Entities\n1 0 0 1\n7 0 0 0 0\n9 0 0 0 1 1 1 1 1 "
      "0\n$EndEntities\n$Periodic\n0\n$EndPeriodic\n"
      "$Nodes\n2 5 1 90\n0 7 0 1\n90\n0 0 0\n3 9 1 4\n1\n2\n3\n5\n"
      "1 0 0 1 1 1\n0 1 0 1 1 1\n0 0 1 1 1 1\n1 1 1 1 1 1\n$EndNodes\n"
      "$Elements\n4 5 1 9\n0 7 15 1\n1 90\n1 2 8 1\n2 1 2 5\n2 3 2 1\n3 90 1 2\n"
      "3 9 4 2\n8 90 1 2 3\n9 3 2 1 90\n$EndElements\n"
      "$NodeData\n1\n\"t\"\n1\n0\n3\n0\n1\n2\n90 1\n2 nan\n$EndNodeData\n"
      "$ElementData\n1\n\"e\"\n1\n0\n3\n0\n3\n2\n3 1 2 3\n8 4 5 6\n$EndElementData\n");
  files.emplace_back(
      "$Comments\nc\n$EndComments\n$MeshFormat\n4.1 0 "
      "8\n$EndMeshFormat\n$PartitionedEntities\n2\n1\n7 1\n"
      "0 1 2 0\n21 2 1 2 1 2 0 0 0 1 1 0 0 0\n11 2 1 1 1 0 0 0 1 1 0 1 8 0\n12 2 1 1 2 0 0 0 1 1 0 "
      "0 0\n"
      "$EndPartitionedEntities\n$Nodes\n2 4 1 4\n1 21 0 2\n1\n3\n0 0 0\n1 1 0\n2 12 0 2\n2\n4\n1 0 "
      "0\n"
      "0 1 0\n$EndNodes\n$Elements\n3 3 1 3\n1 21 1 1\n1 1 3\n2 11 2 1\n2 1 2 3\n2 12 2 1\n3 1 3 "
      "4\n"
      "$EndElements\n$Periodic\n1\n1 5 6\n1 2\n1\n1 3\n$EndPeriodic\n");
  files.emplace_back(
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$ParametricNodes\n3\n1 0 0 0 0 1\n2 1 0 0 1 2 .5\n3 1 "
      "1 0 2 1 "
      ".5 .5\n$EndParametricNodes\n$Elements\n1\n1 2 2 7 1 1 2 3\n$EndElements\n$Periodic\n1\n0 1 "
      "2\n"
      "Affine 1 0\n1\n1 2\n$EndPeriodic\n");
  files.emplace_back("OFF\n6 1 0\n0 0 0\n2 0 0\n2 2 0\n1 1 0\n0 2 0\n0 1 0\n6 0 1 2 3 4 5\n");
  files.emplace_back(
      "mtllib m\ng a b\nusemtl x\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nf 1/1/1 2//2 3/3 "
      "-1\nl 1 2 "
      "3\nt x 9/9/9\n");
  files.emplace_back(
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
      "z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 "
      "0\n1 1 0\n5 "
      "0 1 2 -1 3\n");
  add_volume_seeds(files);
  return files;
}

/// Pieces that tend to hurt.
const std::string tokens[] = {"4294967295",
                              "-1",
                              "99999999999999999999",
                              "nan",
                              "1e999",
                              "\n",
                              " ",
                              "\\\n",
                              "#",
                              std::string(4, '\xff'),
                              std::string(4, '\0'),
                              "\x7f\xff\xff\xff",
                              "list",
                              "OFF BINARY\n",
                              "ply\n"};

std::string mutated(std::string bytes, Random& random) {
  for (std::uint64_t edits = 1 + random.below(4); edits > 0 && !bytes.empty(); --edits) {
    const std::size_t at = random.below(bytes.size());
    const std::size_t length = std::min<std::size_t>(random.below(16), bytes.size() - at);
    switch (random.below(6)) {
      case 0:
        bytes[at] = static_cast<char>(random.below(256));
        break;
      case 1:
        bytes.resize(at);
        break;
      case 2:
        bytes.insert(at, tokens[random.below(std::size(tokens))]);
        break;
      case 3:
        bytes.erase(at, length);
        break;
      case 4:
        bytes.insert(random.below(bytes.size()), bytes.substr(at, length));
        break;
      default:
        bytes.replace(at, std::min<std::size_t>(4, bytes.size() - at),
                      tokens[random.below(std::size(tokens))]);
        break;
    }
  }
  return bytes;
}

TEST(Fuzz, DamagedFilesAreRefusedOrRead) {
  const std::vector<std::string> files = seeds();
  Random random;
  const auto start = std::chrono::steady_clock::now();
  for (int round = 0; round < 20'000; ++round) {
    const std::string file =
        static_cast<char>(random.below(5)) + mutated(files[random.below(files.size())], random);
    const std::size_t before = test::live_bytes;
    test::peak_bytes = before;
    const auto begin = std::chrono::steady_clock::now();
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(file.data()), file.size());
    EXPECT_LT(test::peak_bytes - before, largest_allocation) << "round " << round;
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2))
        << "round " << round;
  }
  RecordProperty(
      "seconds",
      std::to_string(
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()));
}

TEST(Fuzz, EveryPrefixIsRefusedOrRead) {
  for (const std::string& file : seeds()) {
    for (std::size_t size = 0; size <= file.size(); ++size) {
      const std::string prefix = '\4' + file.substr(0, size);
      LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(prefix.data()), prefix.size());
    }
  }
}

}  // namespace
}  // namespace aomd
