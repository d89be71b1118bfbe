#include "core/measure/volume_comparison.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/measure/statistics.h"
#include "core/mesh/geometry.h"

namespace aomd::measure {
namespace {

using SkinFaces = std::vector<const SkinFace*>;

// Faces of the skin as a mesh, with the vertices that they use.
Mesh mesh_of(const Mesh& mesh, const SkinFaces& faces) {
  std::vector<std::uint32_t> used;
  for (const SkinFace* face : faces)
    used.insert(used.end(), face->vertices.span().begin(), face->vertices.span().end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  MeshData data;
  for (const std::uint32_t v : used) data.positions.push_back(mesh.position(Vertex(v)));
  for (const SkinFace* face : faces) {
    data.faces.shapes.push_back(face_shape(face->vertices.count));
    for (const std::uint32_t v : face->vertices.span())
      data.faces.vertices.push_back(
          static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), v) - used.begin()));
  }
  return Mesh(data);
}

// One interface of one mesh, ready to be measured.
class Sheet {
 public:
  Sheet(const Mesh& mesh, const SkinFaces& faces, int threads)
      : mesh_(std::make_unique<Mesh>(mesh_of(mesh, faces))), surface_(*mesh_, threads) {
    facts_.faces = faces.size();
    facts_.euler = count_entities(*mesh_).euler;
    for (std::uint32_t n = 0; n < surface_.tree().size(); ++n) {
      const Triangle& t = surface_.tree().triangle(n);
      facts_.area += 0.5 * glm::length(area_normal(t[0], t[1], t[2]));
    }
  }
  [[nodiscard]] const SurfaceFacts& facts() const { return facts_; }
  [[nodiscard]] const Surface& surface() const { return surface_; }

 private:
  std::unique_ptr<Mesh> mesh_;  // the surface keeps its address
  Surface surface_;
  SurfaceFacts facts_;
};

using Sheets = std::map<Interface, Sheet>;

Sheets sheets_of(const Volume& volume, bool model_faces, int threads) {
  std::map<Interface, SkinFaces> faces;
  for (const SkinFace& face : volume.complex.skin)
    if (model_faces || face.on.separates()) faces[face.on.seen(model_faces)].push_back(&face);
  Sheets sheets;
  for (const auto& [on, list] : faces) sheets.try_emplace(on, volume.mesh, list, threads);
  return sheets;
}

double area_of(const Sheets& sheets) {
  double sum = 0;
  for (const auto& [on, sheet] : sheets) sum += sheet.facts().area;
  return sum;
}

// So many points that each stands for the same area, but no fewer than faces.
std::size_t share(const Sheet& sheet, double whole, std::size_t samples) {
  const double part = whole > 0 ? sheet.facts().area / whole : 0;
  return std::max(sheet.facts().faces,
                  static_cast<std::size_t>(std::llround(part * static_cast<double>(samples))));
}

std::vector<InterfaceChange> compare_sheets(const Sheets& original, const Sheets& result,
                                            std::size_t samples, int threads) {
  std::map<Interface, InterfaceChange> changes;
  for (const auto& [on, sheet] : original) changes[on].before = sheet.facts();
  for (const auto& [on, sheet] : result) changes[on].after = sheet.facts();
  const double before = area_of(original), after = area_of(result);
  std::vector<InterfaceChange> list;
  for (auto& [on, change] : changes) {
    change.on = on;
    if (change.measured()) {
      const Sheet &from = original.at(on), &to = result.at(on);
      change.to_result =
          distance_from(from.surface(), to.surface(), share(from, before, samples), threads);
      change.to_original =
          distance_from(to.surface(), from.surface(), share(to, after, samples), threads);
    }
    list.push_back(change);
  }
  return list;
}

// -----------------------------------------------------------------------------------------------

std::vector<RegionChange> compare_regions(const Volume& original, const Volume& result) {
  std::map<ModelRef, RegionChange> changes;
  for (const RegionFacts& facts : original.complex.regions) changes[facts.model].before = facts;
  for (const RegionFacts& facts : result.complex.regions) changes[facts.model].after = facts;
  std::vector<RegionChange> list;
  list.reserve(changes.size());
  for (const auto& [model, change] : changes) list.push_back(change);
  return list;
}

// Sums of squares with their weights.
struct Squares {
  double sum = 0, weight = 0, max = 0;

  void add(double square, double w) {
    sum += square * w;
    weight += w;
    max = std::max(max, square);
  }
  void add(const Distance& d, double area) {
    add(d.rms * d.rms, area);
    max = std::max(max, d.max * d.max);
  }
  void add(const Squares& other) {
    sum += other.sum;
    weight += other.weight;
    max = std::max(max, other.max);
  }
  [[nodiscard]] SetDistance distance() const {
    return {weight > 0 ? std::sqrt(sum / weight) : 0, std::sqrt(max)};
  }
};

void add(const InterfaceChange& change, Squares& squares) {
  squares.add(change.to_result, change.before->area);
  squares.add(change.to_original, change.after->area);
}

// -----------------------------------------------------------------------------------------------

// Curves as triangles without area, for which the tree finds nearest points as well.
TriangleTree tree_of(const Mesh& mesh, const VolumeCurves& curves) {
  std::vector<Triangle> flat;
  for (const auto& [a, b] : curves.edges)
    flat.push_back({mesh.position(a), mesh.position(b), mesh.position(b)});
  return TriangleTree(std::move(flat));
}

double length_of(const Mesh& mesh, const VolumeCurves& curves) {
  double sum = 0;
  for (const auto& [a, b] : curves.edges) sum += glm::distance(mesh.position(a), mesh.position(b));
  return sum;
}

// From points of the curves, no further apart than `step`, both ends of each edge among them.
Squares squares_from(const Mesh& mesh, const VolumeCurves& curves, const TriangleTree& to,
                     double step) {
  Squares squares;
  for (const auto& [a, b] : curves.edges) {
    const glm::dvec3 &p = mesh.position(a), &q = mesh.position(b);
    const double length = glm::distance(p, q);
    const int n = std::max(2, static_cast<int>(std::ceil(length / step)));
    for (int k = 0; k <= n; ++k)
      squares.add(to.nearest(glm::mix(p, q, static_cast<double>(k) / n)).distance2,
                  length / (n + 1));
  }
  return squares;
}

CurveChange compare_curves(const Volume& original, const VolumeCurves& before, const Volume& result,
                           const VolumeCurves& after, double diagonal) {
  CurveChange change{before.edges.size(),
                     after.edges.size(),
                     length_of(original.mesh, before),
                     length_of(result.mesh, after),
                     {},
                     {},
                     {}};
  if (before.edges.empty() || after.edges.empty()) return change;
  const double step = diagonal / 2000;
  Squares there = squares_from(original.mesh, before, tree_of(result.mesh, after), step);
  const Squares back = squares_from(result.mesh, after, tree_of(original.mesh, before), step);
  change.to_result = there.distance();
  change.to_original = back.distance();
  there.add(back);
  change.both = there.distance();
  return change;
}

// All vertices that regions use, as triangles of one point each.
TriangleTree tree_of_vertices(const Mesh& mesh) {
  const std::vector<bool> used = used_by_regions(mesh);
  std::vector<Triangle> points;
  for (const Vertex v : mesh.vertices())
    if (used[v.index]) points.push_back({mesh.position(v), mesh.position(v), mesh.position(v)});
  return TriangleTree(std::move(points));
}

ModelVertexChange compare_vertices(const Volume& original, const VolumeCurves& before,
                                   const Volume& result, const VolumeCurves& after,
                                   double diagonal) {
  ModelVertexChange change{before.ends.size(), after.ends.size(), 0, 0, {}};
  if (before.ends.empty()) return change;
  const TriangleTree tree = tree_of_vertices(result.mesh);
  for (const Vertex v : before.ends) {
    const double distance = std::sqrt(tree.nearest(original.mesh.position(v)).distance2);
    change.near += distance <= 1e-3 * diagonal;
    const bool kept = distance <= 1e-6 * diagonal;
    change.kept += kept;
    if (!kept) change.lost.push_back(v);
  }
  return change;
}

}  // namespace

Mesh Volume::skin() const {
  SkinFaces faces;
  for (const SkinFace& face : complex.skin) faces.push_back(&face);
  return mesh_of(mesh, faces);
}

Box Volume::box() const {
  const std::vector<bool> used = used_by_regions(mesh);
  Box box;
  for (const Vertex v : mesh.vertices())
    if (used[v.index]) box.add(mesh.position(v));
  return box;
}

bool Volume::lists_faces() const {
  return std::any_of(complex.skin.begin(), complex.skin.end(),
                     [](const SkinFace& face) { return face.on.face.valid(); });
}

bool Volume::lists_edges() const {
  for (const Edge e : mesh.edges())
    if (mesh.classification(e).dimension() == 1) return true;
  return false;
}

double RegionChange::volume_percent() const {
  if (!after) return -100;
  if (!before || !(before->volume > 0)) return std::numeric_limits<double>::infinity();
  return 100 * (after->volume - before->volume) / before->volume;
}

bool RegionChange::kept() const {
  return before && after && before->euler == after->euler && before->parts == after->parts;
}

SetDistance InterfaceChange::distance() const {
  Squares squares;
  if (measured()) add(*this, squares);
  return squares.distance();
}

std::optional<SetDistance> distance_over(std::span<const InterfaceChange> list, bool boundary) {
  Squares squares;
  bool some = false;
  for (const InterfaceChange& change : list) {
    if (change.on.boundary != boundary || !change.measured()) continue;
    add(change, squares);
    some = true;
  }
  return some ? std::optional(squares.distance()) : std::nullopt;
}

VolumeComparison compare_volumes(const Volume& original, const Volume& result, std::size_t samples,
                                 int threads) {
  VolumeComparison c;
  c.diagonal = original.box().diagonal();
  c.regions = compare_regions(original, result);
  const CurveOptions both{original.lists_faces() && result.lists_faces(),
                          original.lists_edges() && result.lists_edges()};
  for (const bool model_faces : {false, true}) {
    if (model_faces && !both.faces) continue;
    (model_faces ? c.model_faces : c.interfaces) =
        compare_sheets(sheets_of(original, model_faces, threads),
                       sheets_of(result, model_faces, threads), samples, threads);
  }
  const VolumeCurves before = curves_of(original.mesh, original.complex, both),
                     after = curves_of(result.mesh, result.complex, both);
  c.curves = compare_curves(original, before, result, after, c.diagonal);
  c.vertices = compare_vertices(original, before, result, after, c.diagonal);
  return c;
}

}  // namespace aomd::measure
