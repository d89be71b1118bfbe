// Tens of thousands of damaged small files of every format through the readers: no crash, no hang,
// no allocation out of proportion. The mutations are the same on every run; AOMD_FUZZ_SEED in the
// environment asks for others.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "core/base/text.h"
#include "core/io/formats.h"
#include "core/io/io.h"
#include "core/samples/numeric.h"
#include "core/samples/samples.h"
#include "tests/io/fuzz/counted_new.h"
#include "tests/support/volume_helpers.h"
#include "tests/support/vtu_texts.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace aomd::io_fuzz_test {
namespace {

/// In the order of the names in fuzz/io_fuzz.cpp, where one without an extension comes last.
constexpr const char* formats[] = {"obj",  "ply", "off", "stl", "msh",
                                   "mesh", "vtk", "vtu", "su2", "gltf"};
constexpr std::size_t format_count = std::size(formats);

/// What reading may hold at once, and ask for altogether, for a file of this size.
std::size_t most_held(std::size_t size) { return (1u << 20) + 500 * size; }
std::size_t most_asked_for(std::size_t size) { return (4u << 20) + 2000 * size; }

/// The seeds of each format.
using Seeds = std::array<std::vector<std::string>, format_count>;

void add(Seeds& seeds, std::string_view format, std::string bytes) {
  const auto at = std::find(std::begin(formats), std::end(formats), format);
  seeds[static_cast<std::size_t>(at - std::begin(formats))].push_back(std::move(bytes));
}

class Random {
 public:
  std::uint64_t below(std::uint64_t n) {
    return static_cast<std::uint64_t>((sample::hashed(state_++) + 1) / 2 * static_cast<double>(n));
  }

 private:
  static std::uint64_t seed() {
    const char* wanted = std::getenv("AOMD_FUZZ_SEED");
    return wanted ? std::strtoull(wanted, nullptr, 10) << 32 : 0;
  }

  std::uint64_t state_ = seed();
};

void add_written(Seeds& seeds, const MeshData& mesh, std::initializer_list<std::string> names,
                 bool binary) {
  const test::TemporaryFolder folder;
  for (const std::string& name : names) {
    const std::filesystem::path path = folder / ("a." + name).c_str();
    io::write(path, mesh, {.binary = binary});
    add(seeds, name == "meshb" ? "mesh" : name, test::bytes_of(path));
  }
}

/// Files that may hold regions, written and by hand.
void add_volume_seeds(Seeds& seeds) {
  MeshData mesh = test::one_of_each();
  mesh.attributes = {{"medit:normal", 0, 3, false, std::vector<double>(36, 1)},
                     {"medit:required", 2, 1, true, {0, 1}},
                     {"region", 3, 1, true, {1, 2, 3, 4}}};
  add_written(seeds, mesh, {"vtk", "vtu"}, true);
  add_written(seeds, mesh, {"vtk", "vtu", "mesh", "su2"}, false);
  add_written(seeds, mesh, {"meshb"}, true);
  add(seeds, "vtu",
      test::vtu_file(test::vtu_piece(test::vtu_zlib, "format=\"binary\""), test::zlib));
  add(seeds, "vtu", test::vtu_appended(test::vtu_zlib_wide, test::zlib_wide));
  add(seeds, "vtu", test::vtu_appended(test::vtu_base64_big, test::big_wide));
  add(seeds, "vtk",
      "# vtk DataFile Version 5.1\nt\nASCII\nDATASET POLYDATA\nPOINTS 5 float\n0 0 0 2 0 0 2 2 0 1 "
      "3 0 0 2 "
      "0\n"
      "POLYGONS 3 9\nOFFSETS vtktypeint64\n0 5 9\nCONNECTIVITY vtktypeint64\n0 1 2 3 4 0 1 2 "
      "4\nTRIANGLE_STRIPS 2 4\n"
      "OFFSETS vtktypeint64\n0 4\nCONNECTIVITY vtktypeint64\n0 1 2 3\nCELL_DATA 3\nSCALARS "
      "material int\n"
      "LOOKUP_TABLE d\n1 2 3\nPOINT_DATA 5\nCOLOR_SCALARS c 1\n0 1 0 1 0\nMETADATA\nINFORMATION "
      "0\n\n");
  add(seeds, "mesh",
      "MeshVersionFormatted 2\nDimension 2\nVertices 3\n0 0 1\n1 0 0\n0 1 0\nTriangles 1 1 2 3 "
      "4\nCorners 1 "
      "1\n"
      "Ridges 1 1\nEdges 1 1 2 3\nTangents 1 0 1\nTangentAtVertices 1 1 1\nBox 1 2\nEnd");
  for (const char* grid :
       {"STRUCTURED_POINTS\nDIMENSIONS 3 2 2\nORIGIN 0 0 0\nSPACING 1 1 1\n",
        "RECTILINEAR_GRID\nDIMENSIONS 3 2 1\nX_COORDINATES 3 float\n0 1 2\n"
        "Y_COORDINATES 2 float\n0 1\nZ_COORDINATES 1 int\n5\n",
        "STRUCTURED_GRID\nDIMENSIONS 2 2 1\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 1 1 0\n"})
    add(seeds, "vtk",
        "# vtk DataFile Version 3.0\nt\nASCII\nDATASET " + std::string(grid) +
            "CELL_DATA 2\nSCALARS s int\nLOOKUP_TABLE d\n1 2\n");
  add(seeds, "mesh",
      "MeshVersionFormatted 2\nDimension 3\nVertices 6\n0 0 0 0\n2 0 0 0\n0 2 0 0\n1 0 0 0\n1 1 0 "
      "0\n"
      "0 1 0 0\nTrianglesP2 1\n1 2 3 4 5 6 3\nEdgesP2Ordering 3\n0\n2\n1\nRequiredTriangles 1 "
      "1\nEnd");
  const std::string zone =
      "NDIME= 2\nNELEM= 1\n5 0 1 2\nNPOIN= 3\n0 0 0.5 0\n1 0 0.5 1\n0 1 0.5 2\nNMARK= 0\n";
  add(seeds, "su2", "NZONE= 2\nIZONE= 1\n" + zone + "IZONE= 2\n" + zone);
  add(seeds, "su2",
      "NDIME= 2\nNELEM= 1\n9 0 1 2 3 0\nNPOIN= 4\n0 0 0\n1 0 1\n1 1 2\n0 1 3\nNMARK= "
      "1\nMARKER_TAG= a\n"
      "MARKER_ELEMS= 1\n3 0 1\nFFD_NBOX= 1\n0 0\n");
}

/// Whether a format is there to be damaged.
bool is_built_in(std::size_t format) {
  return formats[format] != std::string("gltf") || io::detail::has_gltf();
}

/// Both containers, with arrays, seams, pictures, places and sparse accessors.
void add_gltf_seeds(Seeds& seeds) {
  MeshData mesh = make_sample("box", 1);
  mesh.edges.add(Shape::Line, {0, 1});
  mesh.attributes = {{"u", 0, 1, true, std::vector<double>(mesh.positions.size(), 7)}};
  mesh.corners = {{"uv", 2, 2, false, std::vector<double>(2 * mesh.faces.vertices.size(), 0.5)}};
  mesh.corners[0].meaning = Meaning::Texture;
  mesh.corners[0].values[3] = 0.25;
  mesh.appearance.pictures = {{"p", "\x89PNG"}};
  mesh.appearance.materials = {{.name = "m", .picture = 0}};
  for (const char* file : {"a.glb", "a.gltf"})
    add(seeds, "gltf", io::to_bytes(file, io::Format::Gltf, mesh, {.beside = false}).bytes);
  add(seeds, "gltf",
      R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"children":[1],"matrix":)"
      R"([1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]},{"mesh":0,"scale":[1,-1,2],"rotation":[0,0,0,1]}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":5}]}],"accessors":[{)"
      R"("componentType":5126,"count":4,"type":"VEC3","sparse":{"count":2,"indices":{)"
      R"("bufferView":0,"componentType":5121},"values":{"bufferView":1}}}],"bufferViews":[{)"
      R"("buffer":0,"byteLength":4},{"buffer":0,"byteOffset":4,"byteLength":24}],"buffers":[{)"
      R"("byteLength":28,"uri":"data:;base64,AQIAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAA=="}]})");
}

Seeds all_seeds() {
  Seeds seeds;
  const MeshData box = make_sample("box", 1);
  add_written(seeds, box, {"ply", "off", "stl", "msh"}, true);
  add_written(seeds, box, {"ply", "off", "stl", "msh", "obj"}, false);
  for (const bool binary : {false, true}) {
    const test::TemporaryFolder folder;
    io::write(folder / "a.msh", box, {.binary = binary, .msh2 = true});
    add(seeds, "msh", test::bytes_of(folder / "a.msh"));
  }
  add(seeds, "msh",
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n3 1 \"b\"\n$EndPhysicalNames\n"
      "$Entities\n1 0 0 1\n7 0 0 0 0\n9 0 0 0 1 1 1 1 1 "
      "0\n$EndEntities\n$Periodic\n0\n$EndPeriodic\n"
      "$Nodes\n2 5 1 90\n0 7 0 1\n90\n0 0 0\n3 9 1 4\n1\n2\n3\n5\n"
      "1 0 0 1 1 1\n0 1 0 1 1 1\n0 0 1 1 1 1\n1 1 1 1 1 1\n$EndNodes\n"
      "$Elements\n4 5 1 9\n0 7 15 1\n1 90\n1 2 8 1\n2 1 2 5\n2 3 2 1\n3 90 1 2\n"
      "3 9 4 2\n8 90 1 2 3\n9 3 2 1 90\n$EndElements\n"
      "$NodeData\n1\n\"t\"\n1\n0\n3\n0\n1\n2\n90 1\n2 nan\n$EndNodeData\n"
      "$ElementData\n1\n\"e\"\n1\n0\n3\n0\n3\n2\n3 1 2 3\n8 4 5 6\n$EndElementData\n"
      "$ElementNodeData\n1\n\"c\"\n1\n0\n3\n0\n1\n1\n3 3 1 2 3\n$EndElementNodeData\n");
  add(seeds, "msh",
      "$Comments\nc\n$EndComments\n$MeshFormat\n4.1 0 "
      "8\n$EndMeshFormat\n$PartitionedEntities\n2\n1\n7 1\n"
      "0 1 2 0\n21 2 1 2 1 2 0 0 0 1 1 0 0 0\n11 2 1 1 1 0 0 0 1 1 0 1 8 0\n12 2 1 1 2 0 0 0 1 1 0 "
      "0 0\n"
      "$EndPartitionedEntities\n$Nodes\n2 4 1 4\n1 21 0 2\n1\n3\n0 0 0\n1 1 0\n2 12 0 2\n2\n4\n1 0 "
      "0\n"
      "0 1 0\n$EndNodes\n$Elements\n3 3 1 3\n1 21 1 1\n1 1 3\n2 11 2 1\n2 1 2 3\n2 12 2 1\n3 1 3 "
      "4\n"
      "$EndElements\n$Periodic\n1\n1 5 6\n1 2\n1\n1 3\n$EndPeriodic\n");
  add(seeds, "msh",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$ParametricNodes\n3\n1 0 0 0 0 1\n2 1 0 0 1 2 .5\n3 1 "
      "1 0 2 1 "
      ".5 .5\n$EndParametricNodes\n$Elements\n1\n1 2 2 7 1 1 2 3\n$EndElements\n$Periodic\n1\n0 1 "
      "2\n"
      "Affine 1 0\n1\n1 2\n$EndPeriodic\n");
  if (io::detail::has_gltf()) add_gltf_seeds(seeds);
  add(seeds, "off", "OFF\n6 1 0\n0 0 0\n2 0 0\n2 2 0\n1 1 0\n0 2 0\n0 1 0\n6 0 1 2 3 4 5\n");
  add(seeds, "obj",
      "mtllib m\ng a b\nusemtl x\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nf 1/1/1 2//2 3/3 "
      "-1\nl 1 2 "
      "3\nt x 9/9/9\n");
  add(seeds, "ply",
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
      "z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 "
      "0\n1 1 0\n5 "
      "0 1 2 -1 3\n");
  add(seeds, "stl",
      "\xef\xbb\xbfSolid a b\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 "
      "1 "
      "0\nend loop\nend facet\nend solid\nsolid\nendsolid\nrest\n");
  add_volume_seeds(seeds);
  return seeds;
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
                              "ply\n",
                              "\x1b[2J",
                              "\xef\xbb\xbf",
                              "\xc2\x9b"};

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

void read(std::size_t name, const std::string& bytes) {
  const std::string file = static_cast<char>(name) + bytes;
  const std::size_t before = test::live_bytes, asked_before = test::total_bytes;
  test::peak_bytes = before;
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(file.data()), file.size());
  EXPECT_LT(test::peak_bytes - before, most_held(bytes.size())) << printable(bytes.substr(0, 500));
  EXPECT_LT(test::total_bytes - asked_before, most_asked_for(bytes.size()))
      << printable(bytes.substr(0, 500));
}

class Fuzz : public testing::TestWithParam<std::size_t> {};

TEST_P(Fuzz, DamagedFilesAreRefusedOrRead) {
  if (!is_built_in(GetParam())) GTEST_SKIP() << "built without glTF";
  const std::vector<std::string> files = all_seeds()[GetParam()];
  Random random;
  for (int round = 0; round < 60'000 && !HasFailure(); ++round) {
    const bool own_name = random.below(8) > 0;
    read(own_name ? GetParam() : random.below(format_count + 1),
         mutated(files[random.below(files.size())], random));
  }
}

TEST_P(Fuzz, LargerFilesStayInProportion) {
  if (!is_built_in(GetParam())) GTEST_SKIP() << "built without glTF";
  const std::string format = formats[GetParam()];
  const bool volume = format == "su2" || format == "vtu" || format == "mesh";
  const MeshData mesh = volume ? make_sample("tet-box", 7) : make_sample("scan", 3000);
  for (const bool binary : {false, true}) {
    const std::string name = format == "gltf" && binary ? "a.glb" : "a." + format;
    const io::WriteOptions how{.binary = binary, .beside = false};
    const std::string file = io::to_bytes(name, io::format_for_writing(name), mesh, how).bytes;
    EXPECT_GT(file.size(), 30'000u);
    Random random;
    for (int round = 0; round < 100 && !HasFailure(); ++round)
      read(GetParam(), mutated(file, random));
  }
}

TEST_P(Fuzz, EveryPrefixIsRefusedOrRead) {
  if (!is_built_in(GetParam())) GTEST_SKIP() << "built without glTF";
  const std::vector<std::string> files = all_seeds()[GetParam()];
  for (const std::string& file : files) {
    for (std::size_t size = 0; size <= file.size(); ++size)
      read(format_count, file.substr(0, size));
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, Fuzz, testing::Range(std::size_t{0}, format_count),
                         [](const auto& of) { return std::string(formats[of.param]); });

}  // namespace
}  // namespace aomd::io_fuzz_test
