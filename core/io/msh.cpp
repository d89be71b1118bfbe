#include "core/io/msh.h"

#include <algorithm>
#include <array>
#include <map>

#include "core/io/error.h"
#include "core/io/formats.h"

namespace aomd::io::detail {
namespace {

struct Row {
  int number;
  MshType type;
};

// Complete and incomplete ("serendipity") elements; the first-order ones come first, one a shape.
constexpr std::array<Row, 46> element_types{{
    {1, {Shape::Line, 2}},          {2, {Shape::Triangle, 3}},       {3, {Shape::Quad, 4}},
    {4, {Shape::Tetrahedron, 4}},   {5, {Shape::Hexahedron, 8}},     {6, {Shape::Prism, 6}},
    {7, {Shape::Pyramid, 5}},       {15, {Shape::Point, 1}},         {8, {Shape::Line, 3}},
    {26, {Shape::Line, 4}},         {27, {Shape::Line, 5}},          {28, {Shape::Line, 6}},
    {9, {Shape::Triangle, 6}},      {20, {Shape::Triangle, 9}},      {21, {Shape::Triangle, 10}},
    {22, {Shape::Triangle, 12}},    {23, {Shape::Triangle, 15}},     {24, {Shape::Triangle, 15}},
    {25, {Shape::Triangle, 21}},    {10, {Shape::Quad, 9}},          {16, {Shape::Quad, 8}},
    {36, {Shape::Quad, 16}},        {37, {Shape::Quad, 25}},         {38, {Shape::Quad, 36}},
    {39, {Shape::Quad, 12}},        {40, {Shape::Quad, 16}},         {11, {Shape::Tetrahedron, 10}},
    {29, {Shape::Tetrahedron, 20}}, {30, {Shape::Tetrahedron, 35}},  {31, {Shape::Tetrahedron, 56}},
    {32, {Shape::Tetrahedron, 22}}, {137, {Shape::Tetrahedron, 16}}, {12, {Shape::Hexahedron, 27}},
    {17, {Shape::Hexahedron, 20}},  {92, {Shape::Hexahedron, 64}},   {93, {Shape::Hexahedron, 125}},
    {99, {Shape::Hexahedron, 32}},  {100, {Shape::Hexahedron, 44}},  {13, {Shape::Prism, 18}},
    {18, {Shape::Prism, 15}},       {90, {Shape::Prism, 40}},        {91, {Shape::Prism, 75}},
    {14, {Shape::Pyramid, 14}},     {19, {Shape::Pyramid, 13}},      {118, {Shape::Pyramid, 30}},
    {119, {Shape::Pyramid, 55}},
}};

void enlarge(ModelEntity& entity, bool first, const glm::dvec3& p) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double x = p[static_cast<int>(axis)];
    entity.box[axis] = first ? x : std::min(entity.box[axis], x);
    entity.box[axis + 3] = first ? x : std::max(entity.box[axis + 3], x);
  }
}

}  // namespace

std::optional<MshType> msh_type(std::int64_t number) {
  for (const Row& row : element_types)
    if (row.number == number) return row.type;
  return {};
}

bool msh_has_nodes(Shape shape, std::int64_t nodes) {
  return std::any_of(element_types.begin(), element_types.end(), [&](const Row& row) {
    return row.type.shape == shape && row.type.nodes == nodes;
  });
}

int msh_number(Shape shape) {
  for (const Row& row : element_types)
    if (row.type.shape == shape) return row.number;
  throw WriteError("MSH", {},
                   "the format has no element for " + std::string(shape_template(shape).name));
}

void set_boxes(const MeshData& mesh, std::span<ModelEntity> entities) {
  std::map<ModelRef, std::pair<ModelEntity*, bool>> wanted;  // the flag: still without any point
  for (ModelEntity& entity : entities) wanted.emplace(entity.ref, std::pair(&entity, true));
  auto last = wanted.end();
  const auto add = [&](ModelRef ref, const glm::dvec3& p) {
    if (last == wanted.end() || last->first != ref) last = wanted.find(ref);
    if (last == wanted.end()) return;
    enlarge(*last->second.first, last->second.second, p);
    last->second.second = false;
  };
  for (std::size_t v = 0; v < mesh.vertex_classes.size(); ++v)
    add(mesh.vertex_classes[v], mesh.positions[v]);
  for (int dim = 1; dim <= 3; ++dim) {
    if (mesh.list(dim).classes.empty()) continue;
    for_each_entity(mesh.list(dim), [&](auto vertices, ModelRef ref) {
      for (const std::uint32_t v : vertices) add(ref, mesh.positions[v]);
    });
  }
}

}  // namespace aomd::io::detail
