// A CAD file meshed by Gmsh.

#include <optional>

#include "core/model/gmsh_library.h"
#include "core/model/gmsh_model.h"

namespace aomd {
namespace {

using gmsh::call;
using gmsh::functions;

// Gmsh's numbers of linear elements; their vertices are in the order of our templates.
std::optional<Shape> shape_of(int type) {
  switch (type) {
    case 1:
      return Shape::Line;
    case 2:
      return Shape::Triangle;
    case 3:
      return Shape::Quad;
    case 4:
      return Shape::Tetrahedron;
    case 5:
      return Shape::Hexahedron;
    case 6:
      return Shape::Prism;
    case 7:
      return Shape::Pyramid;
    default:
      return {};
  }
}

class Taker {
 public:
  MeshData take(const gmsh::File& file) {
    for (const ModelRef e : file.entities()) take_nodes(e);
    for (const ModelRef e : file.entities())
      if (e.dimension() > 0) take_elements(e);
    return std::move(data_);
  }

 private:
  void take_nodes(ModelRef e) {
    gmsh::Array<std::size_t> tags;
    gmsh::Array<double> coordinates, unused;
    call(functions().ModelMeshGetNodes, &tags.data, &tags.size, &coordinates.data,
         &coordinates.size, &unused.data, &unused.size, e.dimension(), e.tag(), 0, 0);
    for (std::size_t i = 0; i < tags.size; ++i) {
      const double* p = coordinates.data + 3 * i;
      if (tags.data[i] >= index_.size()) index_.resize(tags.data[i] + 1, no_index);
      index_[tags.data[i]] = static_cast<std::uint32_t>(data_.positions.size());
      data_.positions.emplace_back(p[0], p[1], p[2]);
      data_.vertex_classes.push_back(e);
    }
  }

  void take_elements(ModelRef e) {
    gmsh::Array<int> types;
    gmsh::Table<std::size_t> tags, nodes;
    call(functions().ModelMeshGetElements, &types.data, &types.size, &tags.data, &tags.sizes,
         &tags.size, &nodes.data, &nodes.sizes, &nodes.size, e.dimension(), e.tag());
    for (std::size_t k = 0; k < types.size; ++k) {
      const auto shape = shape_of(types.data[k]);
      if (!shape) throw ModelError("Gmsh made elements of type " + std::to_string(types.data[k]));
      EntityList& list = data_.list(e.dimension());
      for (const std::size_t node : nodes.row(k)) list.vertices.push_back(index_.at(node));
      list.shapes.resize(list.shapes.size() + tags.row(k).size(), *shape);
      list.classes.resize(list.shapes.size(), e);
    }
  }

  MeshData data_;
  std::vector<std::uint32_t> index_;  ///< by Gmsh's node tag
};

}  // namespace

MeshData mesh_with_gmsh(const std::string& path, const GmshMeshOptions& options) {
  const gmsh::File file(path);
  file.make_current();
  const gmsh::Silence silence;
  call(functions().OptionSetNumber, "Mesh.MeshSizeMin", options.size);
  call(functions().OptionSetNumber, "Mesh.MeshSizeMax", options.size > 0 ? options.size : 1e22);
  call(functions().ModelMeshGenerate, options.dimension);
  return Taker().take(file);
}

}  // namespace aomd
