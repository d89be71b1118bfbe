#include "viewer/document/skin.h"

#include <algorithm>
#include <tuple>

#include <glm/geometric.hpp>

#include "core/mesh/column.h"
#include "core/mesh/side_index.h"
#include "core/operators/ball.h"

namespace aomd::scene {
namespace {

/// A side of a region, or a face of the mesh, filed under its smallest vertex.
struct Entry {
  std::uint32_t second, high;  ///< its second smallest and its largest vertex
  std::uint32_t id;            ///< of the region or the face
  std::uint16_t corners;
  std::uint16_t place;  ///< of the side in the region's template, or `is_face`
};
constexpr std::uint16_t is_face = 0xffff;

EntityRef entity(const Entry& entry) { return {entry.place == is_face ? 2 : 3, entry.id}; }

/// Gives a face the vertices of an entry.
void take_corners(const Mesh& mesh, const Entry& entry, SkinFace& face) {
  VertexBuffer buffer;
  const auto whole = mesh.vertices_of(entity(entry), buffer);
  face.count = static_cast<std::uint8_t>(entry.corners);
  if (entry.place == is_face) {
    std::copy(whole.begin(), whole.end(), face.vertices.begin());
  } else {
    const SubEntity& side = shape_template(mesh.shape(entity(entry))).sub(2, entry.place);
    for (std::size_t k = 0; k < face.count; ++k) face.vertices[k] = whole[side.vertices[k]];
  }
}

/// The smallest, second smallest and largest of a polygon's vertices.
struct CornerKey {
  std::uint32_t low, second, high;
  explicit CornerKey(std::span<const std::uint32_t> v)
      : low(std::min(v[0], v[1])), second(std::max(v[0], v[1])), high(second) {
    for (std::size_t k = 2; k < v.size(); ++k) {
      second = std::min(second, std::max(low, v[k]));
      low = std::min(low, v[k]);
      high = std::max(high, v[k]);
    }
  }
};

}  // namespace

/// Brings together the sides and faces that lie on the same vertices. Sorting a few of them at a
/// time is several times as fast as looking each up in a table of all.
class SideMatcher {
 public:
  explicit SideMatcher(const Mesh& mesh)
      : mesh_(mesh), begin_(mesh.capacity(0) + std::size_t{1}, 0) {
    each_polygon([&](const CornerKey& key, const Entry&) { ++begin_[key.low + 1]; });
    for (std::size_t v = 1; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
    entries_.resize(begin_.back());
    std::vector<std::uint32_t> at(begin_.begin(), begin_.end() - 1);
    each_polygon(
        [&](const CornerKey& key, const Entry& entry) { entries_[at[key.low]++] = entry; });
    sort();
  }

  /// Calls visit(entries) for each set of vertices: the sides by region, then the faces.
  template <typename Visit>
  void each_match(Visit&& visit) {
    for (std::size_t v = 0; v + 1 < begin_.size(); ++v) {
      const auto filed = std::span(entries_).subspan(begin_[v], begin_[v + 1] - begin_[v]);
      for (std::size_t i = 0; i < filed.size();) {
        std::size_t end = i + 1;
        while (end < filed.size() && filed[end].second == filed[i].second &&
               filed[end].high == filed[i].high)
          ++end;
        each_equal(filed.subspan(i, end - i), visit);
        i = end;
      }
    }
  }

 private:
  void sort() {
    for (std::size_t v = 0; v + 1 < begin_.size(); ++v) {
      const auto filed = std::span(entries_).subspan(begin_[v], begin_[v + 1] - begin_[v]);
      std::sort(filed.begin(), filed.end(), [](const Entry& a, const Entry& b) {
        const bool a_face = a.place == is_face, b_face = b.place == is_face;
        return std::tie(a.second, a.high, a_face, a.id) < std::tie(b.second, b.high, b_face, b.id);
      });
    }
  }

  template <typename Visit>
  void each_polygon(Visit&& visit) const {
    VertexBuffer buffer;
    const auto entry = [](const CornerKey& key, std::uint32_t id, std::size_t corners, int place) {
      return Entry{key.second, key.high, id, static_cast<std::uint16_t>(corners),
                   static_cast<std::uint16_t>(place)};
    };
    for (const Region r : mesh_.regions()) {
      const auto whole = mesh_.vertices_of(r, buffer);
      const ShapeTemplate& shape = shape_template(mesh_.shape(r));
      for (int k = 0; k < shape.face_count; ++k) {
        const SideVertices side(shape.sub(2, k), whole.data());
        const CornerKey key(side.span());
        visit(key, entry(key, r.index, side.count, k));
      }
    }
    for (const Face f : mesh_.faces()) {
      const auto corners = mesh_.vertices_of(f, buffer);
      const CornerKey key(corners);
      visit(key, entry(key, f.index, corners.size(), is_face));
    }
  }

  /// Quads may share the three vertices that all here have, and differ in the fourth.
  template <typename Visit>
  void each_equal(std::span<Entry> run, Visit& visit) {
    if (std::all_of(run.begin(), run.end(), [](const Entry& e) { return e.corners == 3; }))
      return visit(std::span<const Entry>(run));
    while (!run.empty()) {
      const Entry first = run.front();
      const auto end = std::stable_partition(
          run.begin(), run.end(), [&](const Entry& other) { return equal(first, other); });
      const auto count = static_cast<std::size_t>(end - run.begin());
      visit(std::span<const Entry>(run.first(count)));
      run = run.subspan(count);
    }
  }

  [[nodiscard]] bool equal(const Entry& a, const Entry& b) const {
    if (a.corners != b.corners) return false;
    SkinFace p, q;
    take_corners(mesh_, a, p);
    take_corners(mesh_, b, q);
    return std::is_permutation(p.corners().begin(), p.corners().end(), q.corners().begin());
  }

  const Mesh& mesh_;
  std::vector<std::uint32_t> begin_;
  std::vector<Entry> entries_;
};

namespace {

glm::dvec3 middle(const Mesh& mesh, std::span<const std::uint32_t> corners) {
  glm::dvec3 sum{0};
  for (const std::uint32_t v : corners) sum += mesh.position(Vertex(v));
  return sum / static_cast<double>(corners.size());
}

/// Files bring regions that are numbered inside out; their sides are to look outward all the same.
bool looks_inward(const Mesh& mesh, std::span<const std::uint32_t> side, Region region) {
  const auto edge = [&](std::size_t k) {
    return mesh.position(Vertex(side[k])) - mesh.position(Vertex(side[0]));
  };
  glm::dvec3 normal{0};
  for (std::size_t k = 1; k + 1 < side.size(); ++k) normal += glm::cross(edge(k), edge(k + 1));
  VertexBuffer buffer;
  return glm::dot(normal, middle(mesh, side) - middle(mesh, mesh.vertices_of(region, buffer))) < 0;
}

/// Which regions and faces are before a plane, of all of them.
class Kept {
 public:
  Kept(const Mesh& mesh, const glm::dvec4& plane) {
    for (const int dim : {2, 3}) {
      auto& kept = kept_[dim - 2];
      kept.assign(mesh.capacity(dim), 0);
      for (std::uint32_t id = 0; id < kept.size(); ++id)
        kept[id] = mesh.alive({dim, id}) && is_before(mesh, {dim, id}, plane);
    }
  }
  [[nodiscard]] bool operator()(const Entry& e) const {
    return kept_[e.place == is_face ? 0 : 1][e.id] != 0;
  }

 private:
  std::array<std::vector<char>, 2> kept_;
};

/// Leaves what is kept. A face between regions that are gone goes with them.
template <typename Kept>
void leave(const Kept& kept, std::vector<Entry>& entries) {
  const bool has_region = entries.front().place != is_face;
  std::erase_if(entries,
                [&](const Entry& e) { return !(has_region && e.place == is_face) && !kept(e); });
  if (has_region && !entries.empty() && entries.front().place == is_face) entries.clear();
}

/// What the entities on the same vertices come to, without the vertices.
SkinFace skin_face(const Mesh& mesh, std::span<const Entry> entries) {
  SkinFace face;
  for (const Entry& entry : entries) {
    const ModelRef model = mesh.classification(entity(entry));
    if (entry.place == is_face) {
      face.model = model;
      face.face = Face(entry.id);
    } else if (!face.has_inside) {
      face.has_inside = true;
      face.inside = model;
      face.inside_region = Region(entry.id);
    } else {
      face.has_outside = true;
      face.outside = model;
      face.outside_region = Region(entry.id);
    }
  }
  return face;
}

bool to_be_seen(const SkinFace& face) {
  return face.outer() || face.inside != face.outside || face.model.dimension() == 2;
}

Box box_of(const Mesh& mesh, const std::vector<SkinFace>& faces) {
  Box box;
  const auto each_corner = [&](auto&& visit) {
    for (const SkinFace& face : faces)
      for (const std::uint32_t v : face.corners()) visit(mesh.position(Vertex(v)));
  };
  each_corner([&](const glm::dvec3& p) { box.add(p); });
  const glm::dvec3 center = box.center();
  double radius = 0;
  each_corner([&](const glm::dvec3& p) { radius = std::max(radius, glm::length(p - center)); });
  box.set_radius(radius);
  return box;
}

/// The face that these entities come to, where it is to be seen.
std::optional<SkinFace> visible_face(const Mesh& mesh, std::span<const Entry> entries) {
  SkinFace face = skin_face(mesh, entries);
  if (!to_be_seen(face)) return {};
  take_corners(mesh, entries.front(), face);
  if (face.has_inside && looks_inward(mesh, face.corners(), Region(entries.front().id)))
    std::reverse(face.vertices.begin(), face.vertices.begin() + face.count);
  return face;
}

/// What lies on a triangle, as a SideMatcher files it, found by stored relations.
void gather_entries(const Mesh& mesh, const TriangleSide& side, std::vector<Entry>& entries) {
  entries.clear();
  VertexBuffer buffer;
  const auto on_side = [&](std::span<const std::uint32_t> polygon) {
    return polygon.size() == 3 && std::all_of(side.begin(), side.end(), [&](Vertex v) {
             return std::find(polygon.begin(), polygon.end(), v.index) != polygon.end();
           });
  };
  for (const Region r : mesh.row<3>(side[0])) {
    const auto whole = mesh.vertices_of(r, buffer);
    const ShapeTemplate& shape = shape_template(mesh.shape(r));
    for (int k = 0; k < shape.face_count; ++k)
      if (on_side(SideVertices(shape.sub(2, k), whole.data()).span()))
        entries.push_back({0, 0, r.index, 3, static_cast<std::uint16_t>(k)});
  }
  for (const Face f : mesh.row<2>(side[0]))
    if (on_side(mesh.vertices_of(f, buffer))) entries.push_back({0, 0, f.index, 3, is_face});
}

/// Which tetrahedra are before a plane, and which vertices have some on both sides.
class PlaneSides {
 public:
  PlaneSides(const Mesh& mesh, const glm::dvec4& plane)
      : before_(mesh.capacity(3), 0), sides_(mesh.capacity(0), 0) {
    for (const Region r : mesh.regions()) {
      before_[r] = is_before(mesh, r, plane);
      for (const Vertex v : mesh.tetrahedron(r)) sides_[v] |= before_[r] != 0 ? 1 : 2;
    }
  }
  /// Of those before it, the sides that may have one behind it on their other side.
  template <typename Visit>
  void each_side(const Mesh& mesh, Visit&& visit) const {
    for (const Region r : mesh.regions()) {
      if (before_[r] == 0) continue;
      const auto t = mesh.tetrahedron(r);
      for (const auto& [a, b, c] : seen_from)
        if (sides_[t[a]] == 3 && sides_[t[b]] == 3 && sides_[t[c]] == 3) visit({t[a], t[b], t[c]});
    }
  }

 private:
  Column<Region, std::uint8_t> before_;
  Column<Vertex, std::uint8_t> sides_;
};

}  // namespace

bool is_before(const Mesh& mesh, EntityRef e, const glm::dvec4& plane) {
  VertexBuffer buffer;
  return glm::dot(glm::dvec3(plane), middle(mesh, mesh.vertices_of(e, buffer))) + plane.w >= 0;
}

std::optional<SkinFace> skin_face_on(const Mesh& mesh, const TriangleSide& side,
                                     const std::optional<glm::dvec4>& plane) {
  thread_local std::vector<Entry> entries;
  gather_entries(mesh, side, entries);
  if (plane && !entries.empty())
    leave([&](const Entry& e) { return is_before(mesh, entity(e), *plane); }, entries);
  return entries.empty() ? std::optional<SkinFace>() : visible_face(mesh, entries);
}

Skin::Skin(const Mesh& mesh) {
  SideMatcher sides(mesh);
  sides.each_match([&](std::span<const Entry> entries) { add(visible_face(mesh, entries)); });
  finish(mesh);
}

bool is_of_tetrahedra(const Mesh& mesh) {
  const ShapeTemplate *regions = mesh.uniform_shape(3), *faces = mesh.uniform_shape(2);
  return regions != nullptr && regions->vertex_count == 4 && faces != nullptr &&
         faces->vertex_count == 3;
}

Skin Skin::of_tetrahedra(const Mesh& mesh, const std::optional<glm::dvec4>& plane) {
  Skin skin;
  for (const Face f : mesh.faces()) {
    const auto face = skin_face_on(mesh, mesh.triangle(f), plane);
    if (face && face->face == f) skin.add(face);  // each of several on the same vertices would come
  }
  if (plane)
    PlaneSides(mesh, *plane).each_side(mesh, [&](const TriangleSide& side) {
      const auto face = skin_face_on(mesh, side, plane);
      if (face && !face->face.valid()) skin.add(face);
    });
  skin.finish(mesh);
  return skin;
}

void Skin::add(const std::optional<SkinFace>& face) {
  if (face) faces_.push_back(*face);
}

void Skin::finish(const Mesh& mesh) {
  outer_ = std::count_if(faces_.begin(), faces_.end(), [](const SkinFace& f) { return f.outer(); });
  bounds_ = box_of(mesh, faces_);
}

SkinCutter::SkinCutter(const Mesh& mesh)
    : mesh_(mesh), sides_(std::make_unique<SideMatcher>(mesh)) {}

SkinCutter::~SkinCutter() = default;

Skin SkinCutter::before(const glm::dvec4& plane) const {
  const Kept kept(mesh_, plane);
  Skin skin;
  std::vector<Entry> left;
  sides_->each_match([&](std::span<const Entry> entries) {
    left.assign(entries.begin(), entries.end());
    leave(kept, left);
    if (!left.empty()) skin.add(visible_face(mesh_, left));
  });
  skin.finish(mesh_);
  return skin;
}

}  // namespace aomd::scene
