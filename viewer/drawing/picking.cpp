#include "viewer/drawing/picking.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

namespace aomd::scene {
namespace {

constexpr double vertex_px = 9, edge_px = 7;  // so near a vertex or an edge wins
constexpr double reach_px = 5;                // beside the surface its rim is still found
constexpr std::size_t most_loose = 4096;      // faces beside the tree

double distance_to_segment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
  const glm::dvec2 ab = b - a;
  const double length2 = glm::dot(ab, ab);
  const double t = length2 > 0 ? std::clamp(glm::dot(p - a, ab) / length2, 0.0, 1.0) : 0.0;
  return glm::length(p - a - t * ab);
}

double inner_radius(const std::array<glm::dvec2, 3>& t) {
  const glm::dvec2 u = t[1] - t[0], v = t[2] - t[0];
  const double around = glm::length(u) + glm::length(v) + glm::length(t[2] - t[1]);
  return around > 0 ? std::abs(u.x * v.y - u.y * v.x) / around : 0;
}

/// What the clipping plane leaves, where it cuts or takes whole faces away; a skin is made without
/// the regions that it takes.
class Clipping {
 public:
  Clipping(const Shown& shown, const View& view) {
    if (!view.clip || (view.clip->cells && shown.skin)) return;
    plane_ = view.clip->plane(shown.bounds);
    cuts_ = !view.clip->cells;
  }
  [[nodiscard]] bool keeps(const glm::dvec3& p) const {
    return !plane_ || !cuts_ || height(p) >= 0;
  }
  [[nodiscard]] bool keeps(const Mesh& drawn, Face f) const {
    if (!plane_ || cuts_) return true;
    const auto [a, b, c] = drawn.triangle(f);
    return height((drawn.position(a) + drawn.position(b) + drawn.position(c)) / 3.0) >= 0;
  }
  /// From where to where a ray is on the side that is kept.
  [[nodiscard]] std::pair<double, double> kept_part(const Ray& ray) const {
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    if (!plane_ || !cuts_) return {0, unlimited};
    const double rise = glm::dot(glm::dvec3(*plane_), ray.direction), from = height(ray.origin);
    if (rise > 0) return {std::max(0.0, -from / rise), unlimited};
    if (rise < 0) return {0, -from / rise};
    return {0, from >= 0 ? unlimited : -1};
  }

 private:
  [[nodiscard]] double height(const glm::dvec3& p) const {
    return glm::dot(glm::dvec3(*plane_), p) + plane_->w;
  }
  std::optional<glm::dvec4> plane_;
  bool cuts_ = false;
};

/// The nearest corner and side of a face on the picture.
struct Near {
  std::size_t corner = 0, side = 3;  ///< side k goes from corner k to the next; 3: none
  double corner_px = std::numeric_limits<double>::infinity(), side_px = corner_px;
  double radius_px = 0;  ///< of the face's inner circle
};

/// What is clipped away is not near.
Near nearest_parts(const Projector& project, const Mesh& drawn, Face face, std::uint32_t flags,
                   const Clipping& clipping, glm::dvec2 at) {
  const auto t = drawn.triangle(face);
  std::array<glm::dvec2, 3> p;
  std::array<bool, 3> kept{};
  for (std::size_t i = 0; i < 3; ++i) {
    p[i] = project(drawn.position(t[i]));
    kept[i] = clipping.keeps(drawn.position(t[i]));
  }
  Near near;
  near.radius_px = inner_radius(p);
  for (std::size_t i = 0; i < 3; ++i) {
    if (const double d = glm::length(p[i] - at); kept[i] && d < near.corner_px)
      near.corner = i, near.corner_px = d;
    if ((flags >> i & 1u) != 0 || !(kept[i] || kept[(i + 1) % 3])) continue;  // a quad's diagonal
    if (const double d = distance_to_segment(at, p[i], p[(i + 1) % 3]); d < near.side_px)
      near.side = i, near.side_px = d;
  }
  return near;
}

std::uint32_t flags_of(const Shown& shown, Face face) {
  return shown.skin ? shown.skin->flags[face.index] : 0;
}

Vertex whole(const Shown& shown, Vertex v) {
  return shown.skin ? shown.skin->vertices[v.index] : v;
}

/// The face itself, or where the mesh does not have it the region behind.
EntityRef whole(const Shown& shown, Face face, PickLevel level) {
  if (!shown.skin) return level == PickLevel::Region ? EntityRef() : EntityRef(face);
  const Face own = shown.skin->faces[face.index];
  const Region region = shown.skin->regions[face.index];
  const bool takes_region =
      level == PickLevel::Region || (level == PickLevel::Automatic && !own.valid());
  if (takes_region) return region.valid() ? EntityRef(region) : EntityRef();
  return own.valid() ? EntityRef(own) : EntityRef();
}

}  // namespace

Projector::Projector(const View& view, const Box& bounds)
    : matrix_(view.camera.projection(view.aspect, bounds) * view.camera.view()),
      size_(view.aspect * view.height_px, view.height_px) {}

glm::dvec2 Projector::operator()(const glm::dvec3& p) const {
  const glm::dvec4 clip = matrix_ * glm::dvec4(p, 1);
  if (!(clip.w > 0)) return glm::dvec2(std::numeric_limits<double>::infinity());
  return pixels(glm::dvec2(clip) / clip.w);
}

void Picker::forget() {
  tree_.reset();
  cells_.reset();
  edges_known_ = false;
}

void Picker::note(const SurfaceChanges& changes) {
  if (changes.everything || loose_.size() + changes.faces.size() > most_loose) return forget();
  if (!tree_) return;
  for (const Face f : changes.faces) {
    if (f.index >= changed_.size()) changed_.resize(f.index + std::size_t{1}, 0);
    if (changed_[f.index] != 0) continue;
    changed_[f.index] = 1;
    loose_.push_back(f);
  }
}

void Picker::build(const Shown& shown) {
  if (!cells_ && !shown.cells.empty()) {
    std::vector<Triangle> cells(shown.cells.size() / 3);
    for (std::size_t i = 0; i < shown.cells.size(); ++i)
      cells[i / 3][i % 3] = shown.origin + glm::dvec3(shown.cells[i].position);
    cells_ = std::make_unique<const TriangleTree>(cells);
  }
  if (tree_) return;
  Triangles triangles = triangles_of(shown.drawn);
  tree_ = std::make_unique<const TriangleTree>(triangles.corners);
  faces_ = std::move(triangles.faces);
  changed_.assign(shown.drawn.capacity(2), 0);
  loose_.clear();
}

std::optional<Picker::Hit> Picker::first(const Shown& shown, const View& view,
                                         const Ray& ray) const {
  const auto [from, to] = Clipping(shown, view).kept_part(ray);
  const Ray kept{ray.origin + from * ray.direction, ray.direction};
  Hit best = first_face(shown, view, kept);
  if (cells_) {
    const auto hit =
        cells_->first_along(kept.origin, kept.direction, [](std::uint32_t) { return true; });
    if (hit.distance < best.distance)
      best = {{}, shown.cell_regions[cells_->source(hit.triangle)], hit.distance};
  }
  best.distance += from;
  if (!(best.distance <= to) || !std::isfinite(best.distance)) return {};
  return best;
}

/// Infinitely far where there is none.
Picker::Hit Picker::first_face(const Shown& shown, const View& view, const Ray& ray) const {
  const Clipping clipping(shown, view);
  const auto shows = [&](Face f) {
    return !view.hidden.contains(shown.drawn.classification(f)) && clipping.keeps(shown.drawn, f);
  };
  const auto takes = [&](std::uint32_t n) {
    const Face f = faces_[tree_->source(n)];
    return changed_[f.index] == 0 && shows(f);
  };
  const TriangleTree::RayHit hit = tree_->first_along(ray.origin, ray.direction, takes);
  Hit best{{}, {}, hit.distance};
  if (hit.triangle != no_index) best.face = faces_[tree_->source(hit.triangle)];
  for (const Face f : loose_) {
    if (!shown.drawn.alive(f) || !shows(f)) continue;
    const auto t = shown.drawn.triangle(f);
    const Triangle corners{shown.drawn.position(t[0]), shown.drawn.position(t[1]),
                           shown.drawn.position(t[2])};
    if (const double d = distance_along(ray.origin, ray.direction, corners); d < best.distance)
      best = {f, {}, d};
  }
  return best;
}

Edge Picker::entity(const Shown& shown, Vertex a, Vertex b) {
  const Mesh& mesh = shown.mesh;
  if (mesh.stored(0, 1)) return mesh.find_edge(a, b);
  const auto key = [](std::uint32_t u, std::uint32_t v) {
    return std::uint64_t{std::min(u, v)} << 32 | std::max(u, v);
  };
  if (!edges_known_) {
    edges_.clear();
    VertexBuffer buffer;
    for (const Edge e : mesh.edges()) {
      const auto ends = mesh.vertices_of(e, buffer);
      edges_.emplace(key(ends[0], ends[1]), e);
    }
    edges_known_ = true;
  }
  const auto found = edges_.find(key(a.index, b.index));
  return found == edges_.end() ? Edge() : found->second;
}

EntityRef Picker::at(const Shown& shown, const View& view, glm::dvec2 ndc) {
  build(shown);
  const Projector project(view, shown.bounds);
  const glm::dvec2 at = project.pixels(ndc);
  auto hit = first(shown, view, view.camera.ray(ndc, view.aspect, shown.bounds));
  const bool beside = !hit;
  constexpr double slant = 0.7071067811865476;
  for (const glm::dvec2 d : {glm::dvec2(1, 0),
                             {-1, 0},
                             {0, 1},
                             {0, -1},
                             {slant, slant},
                             {-slant, slant},
                             {slant, -slant},
                             {-slant, -slant}})
    if (!hit)
      hit = first(shown, view,
                  view.camera.ray(project.ndc(at + reach_px * d), view.aspect, shown.bounds));
  if (!hit) return {};
  const bool any = view.pick_level == PickLevel::Automatic;
  if (!hit->face.valid()) {
    const bool taken =
        !beside && hit->region.valid() && (any || view.pick_level == PickLevel::Region);
    return taken ? EntityRef(hit->region) : EntityRef();
  }
  const auto t = shown.drawn.triangle(hit->face);
  const Near near = nearest_parts(project, shown.drawn, hit->face, flags_of(shown, hit->face),
                                  Clipping(shown, view), at);
  // On small faces there is less room for each. Colours of edges are asked about as such.
  const bool asks_edges = !beside && view.coloring == Coloring::Verdict;
  const double vertex_share = asks_edges ? 0.3 : 0.7;
  const double vertex_reach =
      beside ? vertex_px : std::min(vertex_px, vertex_share * near.radius_px);
  const double edge_reach = asks_edges ? std::numeric_limits<double>::infinity()
                            : beside   ? edge_px
                                       : std::min(edge_px, 0.5 * near.radius_px);
  const bool some_corner = std::isfinite(near.corner_px);
  if (some_corner &&
      (view.pick_level == PickLevel::Vertex || (any && near.corner_px <= vertex_reach)))
    return whole(shown, t[near.corner]);
  if (near.side < 3 &&
      (view.pick_level == PickLevel::Edge || (any && near.side_px <= edge_reach))) {
    const Edge e = entity(shown, whole(shown, t[near.side]), whole(shown, t[(near.side + 1) % 3]));
    if (e.valid()) return e;
  }
  if (view.pick_level == PickLevel::Vertex || view.pick_level == PickLevel::Edge || (beside && any))
    return {};
  return whole(shown, hit->face, view.pick_level);
}

bool Picker::visible(const Shown& shown, const View& view, const Projector& project,
                     const glm::dvec3& p, Face own) const {
  const Ray ray = view.camera.ray(project.ndc(project(p)), view.aspect, shown.bounds);
  const auto hit = first(shown, view, ray);
  const double distance = glm::dot(p - ray.origin, ray.direction);
  return !hit || hit->face == own || hit->distance >= distance * (1 - 1e-6);
}

// What a face contributes to a box: itself, or its vertices or edges, each where all of it is
// inside and can be seen.
void Picker::add_parts(const Shown& shown, const View& view, const Inside& inside, Face f,
                       std::vector<EntityRef>& found) {
  const Mesh& drawn = shown.drawn;
  const auto t = drawn.triangle(f);
  const auto seen = [&](const glm::dvec3& p) { return visible(shown, view, inside.project, p, f); };
  const auto at = [&](std::size_t i) { return drawn.position(t[i]); };
  if (view.pick_level == PickLevel::Vertex) {
    for (std::size_t i = 0; i < 3; ++i)
      if (inside.vertices[t[i]] && seen(at(i))) found.emplace_back(whole(shown, t[i]));
  } else if (view.pick_level == PickLevel::Edge) {
    for (std::size_t i = 0, k = 1; i < 3; ++i, k = (i + 1) % 3) {
      if (!inside.vertices[t[i]] || !inside.vertices[t[k]] || (flags_of(shown, f) >> i & 1u) != 0)
        continue;
      const Edge e = entity(shown, whole(shown, t[i]), whole(shown, t[k]));
      if (e.valid() && seen(0.5 * (at(i) + at(k)))) found.emplace_back(e);
    }
  } else if (inside.vertices[t[0]] && inside.vertices[t[1]] && inside.vertices[t[2]]) {
    const EntityRef e = whole(shown, f, view.pick_level);
    if (e.valid() && seen((at(0) + at(1) + at(2)) / 3.0)) found.push_back(e);
  }
}

void Picker::add_cells(const Shown& shown, const View& view, const Inside& inside,
                       std::vector<EntityRef>& found) {
  if (view.pick_level != PickLevel::Automatic && view.pick_level != PickLevel::Region) return;
  for (std::uint32_t n = 0; cells_ && n < cells_->size(); ++n) {
    const Region region = shown.cell_regions[cells_->source(n)];
    const auto& [a, b, c] = cells_->triangle(n);
    if (region.valid() && inside(a) && inside(b) && inside(c) &&
        visible(shown, view, inside.project, (a + b + c) / 3.0, {}))
      found.emplace_back(region);
  }
}

std::vector<EntityRef> Picker::within(const Shown& shown, const View& view, glm::dvec2 low,
                                      glm::dvec2 high) {
  if (!loose_.empty()) forget();  // too many rays to look at those for each
  build(shown);
  const Mesh& drawn = shown.drawn;
  const Projector project(view, shown.bounds);
  Inside inside{project, project.pixels(glm::min(low, high)), project.pixels(glm::max(low, high)),
                Column<Vertex, std::uint8_t>(drawn.capacity(0), 0)};
  const Clipping clipping(shown, view);
  for (const Vertex v : drawn.vertices())
    inside.vertices[v] = inside(drawn.position(v)) && clipping.keeps(drawn.position(v));
  std::vector<EntityRef> found;
  for (const Face f : drawn.faces())
    if (!view.hidden.contains(drawn.classification(f)) && clipping.keeps(drawn, f))
      add_parts(shown, view, inside, f, found);
  add_cells(shown, view, inside, found);
  return found;
}

}  // namespace aomd::scene
