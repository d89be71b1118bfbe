#pragma once
// A mesh as plain arrays: what a file holds and what a generator makes, before a Mesh is built from
// it.

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "core/mesh/appearance.h"
#include "core/mesh/model_ref.h"
#include "core/mesh/model_table.h"
#include "core/mesh/number_type.h"
#include "core/mesh/shape.h"

#pragma GCC visibility push(default)

namespace aomd {

/// Entities of one dimension (1 edges, 2 faces, 3 regions), each by its vertices in template order.
struct EntityList {
  std::vector<Shape> shapes;            ///< one an entity
  std::vector<std::uint32_t> vertices;  ///< concatenated; the shape tells how many belong to each
  std::vector<ModelRef> classes;        ///< one an entity, or empty where nothing is classified

  [[nodiscard]] std::size_t size() const { return shapes.size(); }
  [[nodiscard]] bool empty() const { return shapes.empty(); }
  void add(Shape shape, std::initializer_list<std::uint32_t> v, ModelRef model = {}) {
    shapes.push_back(shape);
    vertices.insert(vertices.end(), v);
    if (model.valid() || !classes.empty()) {
      classes.resize(shapes.size() - 1);
      classes.push_back(model);
    }
  }
  friend bool operator==(const EntityList&, const EntityList&) = default;
};

/// What the numbers of an array stand for, where their file says so: it decides how they move when
/// the geometry does, and what another format calls them. The last three are what VTK shows first.
enum class Meaning : std::uint8_t {
  Any,
  Colour,   ///< red, green, blue and perhaps alpha: 0 to 1, or all that whole numbers can be
  Normal,   ///< unit vectors
  Texture,  ///< texture coordinates
  Scalars,
  Vectors,
  Tensors
};

/// Numbers that a file attaches to every entity of one dimension, in the order of the lists.
struct Attribute {
  std::string name;
  int dimension = 0;  ///< 0 vertices, 1 edges, 2 faces, 3 regions
  int components = 1;
  bool integer = false;        ///< whole numbers of at most 53 bits
  std::vector<double> values;  ///< `components` for each entity
  /// How the file stores them. None: doubles, or whole numbers of 32 bits (64 where one needs
  /// them).
  std::optional<NumberType> type{};
  Meaning meaning = Meaning::Any;
  std::vector<std::string> names{};  ///< what the numbers 0, 1, ... of a label stand for, or none
  friend bool operator==(const Attribute&, const Attribute&) = default;
};

/// Vertices of one model entity that correspond to those of another: $Periodic of MSH files.
struct Periodicity {
  ModelRef entity, source;
  std::vector<double> transformation;  ///< 4 by 4, row by row, from the source; or none
  std::vector<std::array<std::uint32_t, 2>> pairs;  ///< a vertex and its counterpart of the source
  friend bool operator==(const Periodicity&, const Periodicity&) = default;
};

/// A line of a file that says something of the whole: "comment" and "obj_info" of PLY, "mtllib" of
/// OBJ.
struct Remark {
  std::string keyword, text;
  friend bool operator==(const Remark&, const Remark&) = default;
};

/// Vertex positions and the entities that a file lists. Edges and faces are listed only where the
/// file names them (feature lines, classified surfaces): the Mesh makes the others when its T asks
/// for them. Indices are 0-based into `positions`. Vertices that nothing uses are kept.
struct MeshData {
  std::vector<glm::dvec3> positions;
  std::vector<ModelRef> vertex_classes;  ///< one a vertex, or empty
  EntityList edges;
  EntityList faces;
  EntityList regions;
  std::vector<Attribute> attributes;
  /// On the corners of faces, where values may jump from one face to the next (texture
  /// coordinates): in the order of `faces.vertices`. A Mesh does not take them.
  std::vector<Attribute> corners;
  std::vector<Remark> remarks;  ///< a Mesh does not take them
  Appearance appearance;        ///< of faces; a Mesh does not take it
  ModelTable model;
  std::vector<Periodicity> periodic;  ///< a Mesh does not take it: edits would make it wrong

  /// The list of one dimension, 1 to 3.
  [[nodiscard]] const EntityList& list(int dim) const {
    return dim == 1 ? edges : dim == 2 ? faces : regions;
  }
  [[nodiscard]] EntityList& list(int dim) { return dim == 1 ? edges : dim == 2 ? faces : regions; }
  /// True where the source classifies at least one entity of dimension 1 or more, or a vertex.
  [[nodiscard]] bool classified() const {
    return !vertex_classes.empty() || !edges.classes.empty() || !faces.classes.empty() ||
           !regions.classes.empty();
  }
  friend bool operator==(const MeshData&, const MeshData&) = default;
};

}  // namespace aomd

#pragma GCC visibility pop
