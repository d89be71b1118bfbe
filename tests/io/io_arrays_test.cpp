// Every format gives back what it holds: names, types, meanings and the bytes of the values of all
// arrays, generated from one table; what it does not hold is named.

#include <bit>
#include <functional>

#include "core/io/formats.h"
#include "core/io/held_arrays.h"
#include "core/io/medit_solution.h"
#include "core/io/stored_numbers.h"
#include "tests/support/volume_helpers.h"

namespace aomd::test::io_arrays_test {
namespace {

constexpr NumberType all_types[] = {NumberType::Int8,    NumberType::UInt8,  NumberType::Int16,
                                    NumberType::UInt16,  NumberType::Int32,  NumberType::UInt32,
                                    NumberType::Float32, NumberType::Float64};
constexpr int all_components[] = {1, 2, 3, 4, 6, 9};

/// A strip of triangles, with an edge listed.
MeshData strip() {
  MeshData mesh;
  for (int i = 0; i < 7; ++i) mesh.positions.emplace_back(i, i % 2, 0.5 * i);
  for (std::uint32_t i = 0; i < 5; ++i)
    mesh.faces.add(Shape::Triangle, {i, i + 1 + i % 2, i + 2 - i % 2});
  return mesh;
}

std::size_t entities(const MeshData& mesh, int dim) {
  return dim == 0 ? mesh.positions.size() : mesh.list(dim).size();
}

/// Values that need all bits of a type, different ones everywhere.
std::vector<double> values_of(NumberType type, std::size_t n) {
  std::vector<double> values;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = (i % 2 == 0 ? 1 : -1) * (1.0 / 3 + 1e9 * static_cast<double>(i * i));
    use_as(type, i % 5 == 4 ? 0.1 * static_cast<double>(i) : x,
           [&](auto held) { values.push_back(static_cast<double>(held)); });
  }
  return values;
}

Attribute array(const MeshData& mesh, const std::string& name, int dim, int components,
                NumberType type, Meaning meaning = Meaning::Any) {
  Attribute a{name, dim, components, is_integer(type), {}};
  a.values = values_of(type, static_cast<std::size_t>(components) * entities(mesh, dim));
  const bool usual = type == NumberType::Float64 || type == NumberType::Int32 ||
                     (type == NumberType::Int64 && !io::detail::fit_int32(a.values));
  if (!usual) a.type = type;
  a.meaning = meaning;
  return a;
}

/// Of every type and number of components, on entities of these dimensions.
MeshData with_all(MeshData mesh, std::initializer_list<int> dims,
                  std::initializer_list<NumberType> others = {}) {
  std::vector<NumberType> types(std::begin(all_types), std::end(all_types));
  types.insert(types.end(), others);
  for (const int dim : dims) {
    if (entities(mesh, dim) == 0) continue;
    for (const NumberType type : types)
      mesh.attributes.push_back(
          array(mesh, "t" + std::to_string(static_cast<int>(type)), dim, 1, type));
    for (const int n : all_components)
      mesh.attributes.push_back(array(mesh, "c" + std::to_string(n), dim, n,
                                      n % 2 == 0 ? NumberType::Float32 : NumberType::Float64));
  }
  return mesh;
}

MeshData for_ply() {
  MeshData mesh = strip();
  mesh.edges.add(Shape::Line, {0, 1});
  mesh.edges.add(Shape::Line, {5, 6});
  mesh = with_all(std::move(mesh), {0, 2, 1});
  for (const int dim : {0, 2}) {
    mesh.attributes.push_back(array(mesh, "normal", dim, 3, NumberType::Float32, Meaning::Normal));
    mesh.attributes.push_back(array(mesh, "color", dim, 4, NumberType::UInt8, Meaning::Colour));
    mesh.attributes.push_back(array(mesh, "quality", dim, 1, NumberType::Float32));
    mesh.attributes.push_back(array(mesh, "st", dim, 2, NumberType::Float64, Meaning::Texture));
    mesh.attributes.push_back(array(mesh, "diffuse", dim, 3, NumberType::UInt8, Meaning::Colour));
  }
  std::stable_sort(
      mesh.attributes.begin(), mesh.attributes.end(),
      [](const auto& a, const auto& b) { return (3 - a.dimension) % 3 < (3 - b.dimension) % 3; });
  Attribute texture{"texcoord", 2, 2, false, {}};
  texture.values = values_of(NumberType::Float32, 2 * mesh.faces.vertices.size());
  texture.type = NumberType::Float32;
  texture.meaning = Meaning::Texture;
  mesh.corners = {texture};
  mesh.remarks = {{"comment", "made by hand"}, {"obj_info", "num_cols 512"}, {"comment", ""}};
  return mesh;
}

MeshData for_obj() {
  MeshData mesh = strip();
  mesh.attributes.push_back(array(mesh, "color", 0, 3, NumberType::Float64, Meaning::Colour));
  for (double& x : mesh.attributes[0].values) x = 1 / (2 + std::abs(x));
  const auto label = [&](const char* name, std::vector<double> values,
                         std::vector<std::string> names) {
    Attribute a{name, 2, 1, true, std::move(values)};
    a.names = std::move(names);
    mesh.attributes.push_back(std::move(a));
  };
  label("group", {0, 1, 1, 0, 2}, {"wing left", "wing right", "tail"});
  label("object", {0, 0, 0, 0, 0}, {"plane"});
  label("material", {0, 1, 1, 0, 0}, {"steel", "glass"});
  label("smoothing", {0, 1, 1, 2, 0}, {});
  mesh.faces.classes = {{2, 1}, {2, 2}, {2, 2}, {2, 1}, {2, 3}};
  std::rotate(mesh.attributes.begin(), mesh.attributes.begin() + 1, mesh.attributes.end());
  const auto on_corners = [&](const char* name, int components, Meaning meaning) {
    Attribute a{name, 2, components, false, {}};
    a.values = values_of(NumberType::Float64,
                         static_cast<std::size_t>(components) * mesh.faces.vertices.size());
    a.meaning = meaning;
    mesh.corners.push_back(std::move(a));
  };
  on_corners("uv", 2, Meaning::Texture);
  on_corners("normal", 3, Meaning::Normal);
  for (int k = 0; k < 2; ++k)
    mesh.corners[0].values[static_cast<std::size_t>(4 + k)] = std::nan("");
  mesh.remarks = {{"mtllib", "plane.mtl"}};
  return mesh;
}

MeshData for_obj_by_vertex() {
  MeshData mesh = strip();
  mesh.attributes = {array(mesh, "uv", 0, 3, NumberType::Float64, Meaning::Texture),
                     array(mesh, "normal", 0, 3, NumberType::Float64, Meaning::Normal)};
  return mesh;
}

/// Floats and small whole numbers; one face has no texture coordinates.
MeshData for_gltf() {
  MeshData mesh = strip();
  const auto label = [&](const char* name, std::vector<double> values,
                         std::vector<std::string> names) {
    mesh.attributes.push_back({name, 2, 1, true, std::move(values)});
    mesh.attributes.back().names = std::move(names);
  };
  label("group", {0, 0, 1, 1, 2}, {"wing left", "wing right", "tail"});
  label("object", {0, 0, 0, 0, 0}, {"plane"});
  label("material", {0, 0, 1, 1, 1}, {"steel", "glass"});
  label("smoothing", {0, 0, 0, 2, 2}, {});
  mesh.faces.classes = {{2, 1}, {2, 1}, {2, 2}, {2, 2}, {2, 3}};
  mesh.attributes.push_back(array(mesh, "color", 0, 3, NumberType::UInt8, Meaning::Colour));
  mesh.attributes.push_back(array(mesh, "color_1", 0, 4, NumberType::UInt16, Meaning::Colour));
  mesh.attributes.push_back(array(mesh, "color_2", 0, 3, NumberType::Float32, Meaning::Colour));
  mesh.attributes.push_back(array(mesh, "normal", 0, 3, NumberType::Float32, Meaning::Normal));
  for (const int n : {1, 2, 3, 4, 9})
    mesh.attributes.push_back(array(mesh, "c" + std::to_string(n), 0, n, NumberType::Float32));
  for (const NumberType type :
       {NumberType::Int8, NumberType::UInt8, NumberType::Int16, NumberType::UInt16})
    mesh.attributes.push_back(
        array(mesh, "t" + std::to_string(static_cast<int>(type)), 0, 1, type));
  for (const int k : {0, 1}) {
    Attribute uv{k == 0 ? "uv" : "uv_1", 2, 2, false, {}};
    for (const double x : values_of(NumberType::Float32, 2 * mesh.faces.vertices.size()))
      uv.values.push_back(uv.values.size() % 2 == 0 ? x : 1 - x);
    uv.meaning = Meaning::Texture;
    mesh.corners.push_back(std::move(uv));
  }
  std::fill_n(mesh.corners[0].values.begin() + 6, 6, std::nan(""));
  return mesh;
}

/// Text knows doubles, and bytes for colours.
MeshData for_off(bool binary) {
  MeshData mesh = strip();
  const NumberType real = binary ? NumberType::Float32 : NumberType::Float64;
  const NumberType shade = binary ? NumberType::Float32 : NumberType::UInt8;
  mesh.attributes = {array(mesh, "normal", 0, 3, real, Meaning::Normal),
                     array(mesh, "color", 0, 4, shade, Meaning::Colour),
                     array(mesh, "uv", 0, 2, real, Meaning::Texture),
                     array(mesh, "color", 2, 3, real, Meaning::Colour)};
  return mesh;
}

MeshData for_binary_stl(bool colours) {
  MeshData mesh = strip();
  if (!colours) {
    mesh.attributes = {array(mesh, "attribute", 2, 1, NumberType::UInt16)};
    mesh.attributes[0].values[1] = 7;
    return mesh;
  }
  Attribute a{"color", 2, 3, true, {}};
  for (std::size_t i = 0; i < 3 * mesh.faces.size(); ++i)
    a.values.push_back(std::round(static_cast<double>(i * 2 % 32) * 255 / 31));
  a.type = NumberType::UInt8;
  a.meaning = Meaning::Colour;
  mesh.attributes = {a};
  return mesh;
}

MeshData for_text_stl() {
  MeshData mesh = strip();
  Attribute label{"solid", 2, 1, true, {0, 0, 1, 1, 1}};
  label.names = {"left half", "right half"};
  mesh.attributes = {label};
  mesh.faces.classes = {{2, 1}, {2, 1}, {2, 2}, {2, 2}, {2, 2}};
  return mesh;
}

MeshData for_vtk() {
  MeshData mesh = with_all(one_of_each(), {0, 1, 2, 3}, {NumberType::Int64});
  for (const int dim : {0, 3}) {
    const auto at = mesh.attributes.insert(
        std::find_if(mesh.attributes.begin(), mesh.attributes.end(),
                     [&](const Attribute& a) { return a.dimension > dim; }),
        array(mesh, "pressure", dim, 1, NumberType::Float32, Meaning::Scalars));
    const auto rest = {array(mesh, "velocity", dim, 3, NumberType::Float64, Meaning::Vectors),
                       array(mesh, "Normals", dim, 3, NumberType::Float32, Meaning::Normal),
                       array(mesh, "stress", dim, 9, NumberType::Float64, Meaning::Tensors),
                       array(mesh, "tc", dim, 2, NumberType::Float32, Meaning::Texture),
                       array(mesh, "RGB", dim, 3, NumberType::UInt8, Meaning::Colour)};
    mesh.attributes.insert(at + 1, rest);
  }
  return mesh;
}

MeshData for_msh() {
  MeshData mesh = one_of_each();
  for (const int dim : {0, 1, 2, 3})
    for (const int n : all_components)
      mesh.attributes.push_back(array(mesh, "c" + std::to_string(n), dim, n, NumberType::Float64));
  for (const int n : {1, 3}) {
    const std::size_t numbers = static_cast<std::size_t>(n) * mesh.faces.vertices.size();
    mesh.corners.push_back(
        {"at corners " + std::to_string(n), 2, n, false, values_of(NumberType::Float64, numbers)});
    mesh.corners.back().type = mesh.attributes.back().type;
    mesh.corners.back().values[1] = std::nan("");
  }
  return mesh;
}

/// Numbered as the file beside the mesh has them.
MeshData for_medit() {
  MeshData mesh = one_of_each();
  for (const int dim : {0, 1, 2, 3})
    for (std::size_t k = 0; k < 4; ++k) {
      constexpr int components[] = {1, 3, 6, 9};
      mesh.attributes.push_back(
          array(mesh, io::detail::solution_name(k), dim, components[k], NumberType::Float64));
      for (double& x : mesh.attributes.back().values) x = std::isfinite(x) ? x : 0.1;
    }
  return mesh;
}

struct Case {
  const char* name;
  const char* file;
  std::optional<bool> binary;
  std::function<MeshData()> make;
};

const Case cases[] = {
    {"PlyBinary", "a.ply", true, for_ply},
    {"PlyText", "a.ply", false, for_ply},
    {"Obj", "a.obj", {}, for_obj},
    {"ObjByVertex", "a.obj", {}, for_obj_by_vertex},
    {"GltfBinary", "a.glb", {}, for_gltf},
    {"GltfText", "a.gltf", {}, for_gltf},
    {"OffText", "a.off", false, [] { return for_off(false); }},
    {"OffBinary", "a.off", true, [] { return for_off(true); }},
    {"StlColours", "a.stl", true, [] { return for_binary_stl(true); }},
    {"StlMarks", "a.stl", true, [] { return for_binary_stl(false); }},
    {"StlText", "a.stl", false, for_text_stl},
    {"VtkText", "a.vtk", false, for_vtk},
    {"VtkBinary", "a.vtk", true, for_vtk},
    {"VtuText", "a.vtu", false, for_vtk},
    {"VtuBinary", "a.vtu", true, for_vtk},
    {"MshText", "a.msh", false, for_msh},
    {"MshBinary", "a.msh", true, for_msh},
    {"MeditText", "a.mesh", {}, for_medit},
    {"MeditBinary", "a.meshb", {}, for_medit},
};

void expect_equal(const Attribute& a, const Attribute& b) {
  SCOPED_TRACE(a.name + " on " + std::to_string(a.dimension));
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.dimension, b.dimension);
  EXPECT_EQ(a.components, b.components);
  EXPECT_EQ(a.integer, b.integer);
  EXPECT_EQ(a.type, b.type);
  EXPECT_EQ(a.meaning, b.meaning);
  EXPECT_EQ(a.names, b.names);
  ASSERT_EQ(a.values.size(), b.values.size());
  for (std::size_t i = 0; i < a.values.size(); ++i)
    ASSERT_TRUE(std::bit_cast<std::uint64_t>(a.values[i]) ==
                    std::bit_cast<std::uint64_t>(b.values[i]) ||
                (std::isnan(a.values[i]) && std::isnan(b.values[i])))
        << i << ": " << a.values[i] << " and " << b.values[i];
}

class RoundTrip : public testing::TestWithParam<Case> {};

bool can_write(const std::string& file) {
  return file.find(".gl") == std::string::npos || io::detail::has_gltf();
}

TEST_P(RoundTrip, GivesBackEveryArray) {
  if (!can_write(GetParam().file)) GTEST_SKIP() << "built without glTF";
  const MeshData mesh = GetParam().make();
  const TemporaryFolder folder;
  const auto path = folder / GetParam().file;
  EXPECT_EQ(io::write(path, mesh, {.binary = GetParam().binary}), std::vector<std::string>{});
  const MeshData again = io::read(path).mesh;
  EXPECT_EQ(again.remarks, mesh.remarks);
  ASSERT_EQ(again.attributes.size(), mesh.attributes.size());
  for (std::size_t i = 0; i < mesh.attributes.size(); ++i)
    expect_equal(mesh.attributes[i], again.attributes[i]);
  ASSERT_EQ(again.corners.size(), mesh.corners.size());
  for (std::size_t i = 0; i < mesh.corners.size(); ++i)
    expect_equal(mesh.corners[i], again.corners[i]);
  EXPECT_EQ(again.faces, mesh.faces);
  const auto bytes =
      io::to_bytes(path, io::format_for_writing(path), again, {.binary = GetParam().binary});
  EXPECT_EQ(bytes.bytes, bytes_of(path)) << "the second writing";
}

/// In every other format what has no place there is named, and nothing else.
TEST_P(RoundTrip, OtherFormatsNameWhatTheyLack) {
  const MeshData mesh = GetParam().make();
  for (const char* file : {"o.ply", "o.obj", "o.off", "o.stl", "o.glb", "o.gltf", "o.msh", "o.mesh",
                           "o.vtk", "o.vtu"}) {
    if (!can_write(file)) continue;
    const io::Format format = io::format_for_writing(file);
    if (!mesh.regions.empty() && format < io::Format::Msh) continue;
    const io::EncodedMesh encoded = io::to_bytes(file, format, mesh, {.beside = false});
    std::string notes;
    for (const std::string& note : encoded.notes) notes += note + "; ";
    const bool binary =
        format == io::Format::Ply || (format == io::Format::Stl && mesh.faces.classes.empty());
    const auto held = io::detail::held_arrays(format, binary, false, mesh);
    std::size_t lost = 0;
    for (const auto* list : {&mesh.attributes, &mesh.corners})
      for (const Attribute& a : *list)
        lost += std::find(held.begin(), held.end(), &a) == held.end();
    EXPECT_EQ(lost > 0, notes.find("attribute ") != std::string::npos) << file << ": " << notes;
    const io::ReadResult again = io::read_bytes(file, encoded.bytes);
    EXPECT_EQ(again.mesh.faces.size(), mesh.faces.size());
    EXPECT_GE(again.mesh.attributes.size() + again.mesh.corners.size() + lost,
              mesh.attributes.size())
        << file;
  }
}

INSTANTIATE_TEST_SUITE_P(Arrays, RoundTrip, testing::ValuesIn(cases),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace aomd::test::io_arrays_test
