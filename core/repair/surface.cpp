#include "core/repair/surface.h"

#include <algorithm>
#include <stdexcept>
#include <unordered_map>

#include <glm/geometric.hpp>

#include "core/repair/connectivity.h"

namespace aomd::repair_detail {
namespace {

void require(bool condition, const char* what) {
  if (!condition) throw std::invalid_argument(std::string("repair: ") + what);
}

void check(const MeshData& data) {
  require(data.regions.empty(), "a mesh with regions is no surface");
  require(data.positions.size() < no_index / 2 && data.faces.vertices.size() < no_index / 2,
          "the mesh is too large");
  require(data.vertex_classes.empty() || data.vertex_classes.size() == data.positions.size(),
          "there are not as many classes as vertices");
  for (int dim = 1; dim <= 2; ++dim) {
    const EntityList& list = data.list(dim);
    require(list.classes.empty() || list.classes.size() == list.size(), "a list lacks classes");
    std::size_t corners = 0;
    for (const Shape shape : list.shapes) {
      require(shape_template(shape).dimension == dim, "an entity has a wrong shape");
      corners += static_cast<std::size_t>(shape_template(shape).vertex_count);
    }
    require(corners == list.vertices.size(), "shapes and vertices of a list do not fit");
    require(std::all_of(list.vertices.begin(), list.vertices.end(),
                        [&](auto v) { return v < data.positions.size(); }),
            "a vertex does not exist");
  }
  for (const Attribute& a : data.attributes) {
    const std::size_t n = a.dimension == 0 ? data.positions.size() : data.list(a.dimension).size();
    require(a.values.size() == n * static_cast<std::size_t>(a.components),
            "an attribute lacks values");
  }
}

void copy_values(Attribute& a, std::size_t from, std::size_t to) {
  const auto n = static_cast<std::size_t>(a.components);
  a.values.resize(std::max(a.values.size(), (to + 1) * n));
  std::copy_n(a.values.begin() + static_cast<std::ptrdiff_t>(from * n), n,
              a.values.begin() + static_cast<std::ptrdiff_t>(to * n));
}

// Keeps the blocks of `n` values whose flag is set.
template <typename Value>
void keep_blocks(std::vector<Value>& values, std::size_t n, const std::vector<std::uint8_t>& keep) {
  if (values.empty()) return;
  std::size_t at = 0;
  for (std::size_t i = 0; i < keep.size(); ++i)
    for (std::size_t k = 0; keep[i] && k < n; ++k) values[at++] = values[i * n + k];
  values.resize(at);
}

void keep_vertices_of(EntityList& list, const std::vector<std::uint8_t>& keep,
                      const std::vector<std::uint32_t>& begin) {
  std::size_t at = 0;
  for (std::size_t i = 0; i < keep.size(); ++i) {
    const int n = keep[i] ? shape_template(list.shapes[i]).vertex_count : 0;
    for (int k = 0; k < n; ++k)
      list.vertices[at++] = list.vertices[begin[i] + static_cast<std::size_t>(k)];
  }
  list.vertices.resize(at);
}

}  // namespace

Surface::Surface(MeshData& data) : data_(data) {
  check(data);
  begin_.reserve(data.faces.size());
  face_of_.reserve(data.faces.vertices.size());
  for (std::uint32_t f = 0; f < data.faces.size(); ++f) {
    begin_.push_back(static_cast<std::uint32_t>(face_of_.size()));
    face_of_.insert(face_of_.end(), size(f), f);
  }
  removed_.assign(data.faces.size(), 0);
}

glm::dvec3 Surface::normal(std::uint32_t f) const {
  const auto v = vertices(f);
  glm::dvec3 sum(0);
  for (std::size_t k = 1; k + 1 < v.size(); ++k)
    sum += glm::cross(position(v[k]) - position(v[0]), position(v[k + 1]) - position(v[0]));
  return sum;
}

void Surface::shrink(std::uint32_t f, std::span<const std::uint32_t> corners) {
  data_.faces.shapes[f] = face_shape(corners.size());
  std::copy(corners.begin(), corners.end(), vertices(f).begin());
  shrunk_ = true;
}

std::uint32_t Surface::copy_vertex(std::uint32_t v) {
  const std::uint32_t copy = vertex_count();
  data_.positions.emplace_back(data_.positions[v]);
  if (!data_.vertex_classes.empty()) data_.vertex_classes.emplace_back(data_.vertex_classes[v]);
  for (Attribute& a : data_.attributes)
    if (a.dimension == 0) copy_values(a, v, copy);
  return copy;
}

void Surface::take_properties(std::uint32_t f, std::uint32_t from) {
  if (!data_.faces.classes.empty()) data_.faces.classes[f] = data_.faces.classes[from];
  for (Attribute& a : data_.attributes)
    if (a.dimension == 2) copy_values(a, from, f);
}

void Surface::finish() {
  if (removed_count_ == 0 && !shrunk_) return;
  if (removed_count_ > 0) drop_bare_edges();
  std::vector<std::uint8_t> keep(removed_.size());
  std::transform(removed_.begin(), removed_.end(), keep.begin(),
                 [](std::uint8_t r) { return std::uint8_t{r == 0}; });
  keep_entities(data_, 2, keep, begin_);
}

void Surface::drop_bare_edges() {
  EntityList& edges = data_.edges;
  enum : std::uint8_t { lost = 1, held = 2 };
  std::unordered_map<std::uint64_t, std::uint8_t> listed;
  for (std::size_t e = 0; e < edges.size(); ++e)
    listed[edge_key(edges.vertices[2 * e], edges.vertices[2 * e + 1])] = 0;
  if (listed.empty()) return;
  for (std::uint32_t f = 0; f < face_count(); ++f) {
    const auto v = vertices(f);
    for (std::size_t k = 0; k < v.size(); ++k)
      if (const auto it = listed.find(edge_key(v[k], v[(k + 1) % v.size()])); it != listed.end())
        it->second |= alive(f) ? held : lost;
  }
  std::vector<std::uint8_t> keep(edges.size());
  std::vector<std::uint32_t> begin(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    begin[e] = static_cast<std::uint32_t>(2 * e);
    keep[e] = listed[edge_key(edges.vertices[2 * e], edges.vertices[2 * e + 1])] != lost;
  }
  keep_entities(data_, 1, keep, begin);
}

void keep_entities(MeshData& data, int dim, const std::vector<std::uint8_t>& keep,
                   const std::vector<std::uint32_t>& begin) {
  for (Attribute& a : data.attributes)
    if (a.dimension == dim) keep_blocks(a.values, static_cast<std::size_t>(a.components), keep);
  if (dim == 0) {
    keep_blocks(data.positions, 1, keep);
    return keep_blocks(data.vertex_classes, 1, keep);
  }
  EntityList& list = data.list(dim);
  keep_vertices_of(list, keep, begin);
  keep_blocks(list.classes, 1, keep);
  keep_blocks(list.shapes, 1, keep);
}

}  // namespace aomd::repair_detail
