#include "core/decimate/curves/original_curves.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "core/model/triangle_tree.h"

namespace aomd {
namespace {

double squared(const glm::dvec3& d) { return glm::dot(d, d); }

/// Where a point lies beside a vertex of a curve: on which of the pieces to either side, how far
/// along it from the vertex, and how far off.
struct Foot {
  std::size_t side = 0;
  double part = 0, distance2 = std::numeric_limits<double>::infinity();
};

/// The feet of points beside a vertex at `x`.
class Feet {
 public:
  Feet(const Mesh& mesh, const CurvePlace& place, const glm::dvec3& x) : x_(x) {
    for (std::size_t side = 0; side < 2; ++side) {
      if (!place.far[side].valid()) continue;
      const glm::dvec3 along = mesh.position(place.far[side]) - x;
      sides_[count_++] = {side, along, squared(along)};
    }
  }

  [[nodiscard]] Foot of(const glm::dvec3& p) const {
    Foot best;
    for (std::size_t i = 0; i < count_; ++i) {
      const auto& [side, along, length2] = sides_[i];
      const double part =
          length2 > 0 ? std::clamp(glm::dot(p - x_, along) / length2, 0.0, 1.0) : 0.0;
      const double distance2 = squared(x_ + part * along - p);
      if (distance2 < best.distance2) best = {side, part, distance2};
    }
    return best;
  }

 private:
  struct Side {
    std::size_t side = 0;
    glm::dvec3 along{};
    double length2 = 0;
  };
  glm::dvec3 x_;
  std::array<Side, 2> sides_;
  std::size_t count_ = 0;
};

}  // namespace

OriginalCurves::OriginalCurves(const Mesh& mesh, std::uint32_t most_points)
    : most_points_(most_points) {
  find_pieces(mesh);
  add_points(mesh);
}

void OriginalCurves::find_pieces(const Mesh& mesh) {
  pieces_.clear();
  nodes_.clear();
  node_of_ = {};
  for (const Edge e : mesh.edges()) {
    if (mesh.classification(e).dimension() > 1) continue;
    if (pieces_.empty()) node_of_.assign(mesh.capacity(0), no_index);
    const std::uint32_t piece = static_cast<std::uint32_t>(pieces_.size());
    pieces_.push_back({mesh.edge_vertices(e), mesh.classification(e)});
    for (const Vertex v : pieces_.back().ends) add_piece(mesh, v, piece);
  }
  for (Node& node : nodes_) node.inside = node.inside && node.pieces[1] != no_index;
}

// A third piece, or one of another curve, makes a vertex an end of them all.
void OriginalCurves::add_piece(const Mesh& mesh, Vertex v, std::uint32_t piece) {
  if (node_of_[v] == no_index) {
    node_of_[v] = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({.inside = mesh.classification(v).dimension() == 1});
  }
  Node& node = nodes_[node_of_[v]];
  const bool full = node.pieces[1] != no_index;
  node.inside = node.inside && !full && pieces_[piece].curve == mesh.classification(v);
  if (!full) node.pieces[node.pieces[0] == no_index ? 0 : 1] = piece;
}

void OriginalCurves::add_points(const Mesh& mesh) {
  Column<Vertex, std::uint32_t> point_of(node_of_.size(), no_index);
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    const glm::dvec3 a = mesh.position(pieces_[i].ends[0]), b = mesh.position(pieces_[i].ends[1]);
    const double length = glm::length(b - a);
    for (const Vertex v : pieces_[i].ends) {
      if (point_of[v] == no_index) {
        point_of[v] = static_cast<std::uint32_t>(points_.size());
        points_.push_back({mesh.position(v), 0, pieces_[i].curve});
        add_point(i, point_of[v]);
      }
      points_[point_of[v]].length += length / 6;
    }
    points_.push_back({(a + b) / 2.0, 2 * length / 3, pieces_[i].curve});
    add_point(i, static_cast<std::uint32_t>(points_.size() - 1));
  }
}

void OriginalCurves::add_point(std::uint32_t piece, std::uint32_t point) {
  points_[point].next = pieces_[piece].first;
  pieces_[piece].first = point;
}

bool OriginalCurves::inside(Vertex v) const {
  return v.index < node_of_.size() && node_of_[v] != no_index && nodes_[node_of_[v]].inside;
}

std::uint32_t OriginalCurves::piece_between(Vertex v, Vertex w) const {
  if (inside(v)) {
    for (const std::uint32_t piece : nodes_[node_of_[v]].pieces)
      if (far_end(piece, v) == w) return piece;
    return no_index;
  }
  return inside(w) ? piece_between(w, v) : no_index;
}

Vertex OriginalCurves::far_end(std::uint32_t piece, Vertex v) const {
  const auto [a, b] = pieces_[piece].ends;
  return a == v ? b : a;
}

std::uint32_t OriginalCurves::other_piece(Vertex v, std::uint32_t piece) const {
  const auto& [a, b] = nodes_[node_of_[v]].pieces;
  return a == piece ? b : a;
}

bool OriginalCurves::between(Vertex v, Vertex w, CurvePlace& place) const {
  const std::uint32_t piece = piece_between(v, w);
  if (piece == no_index) return false;
  place = {};
  place.pieces[2] = piece;
  for (const std::size_t side : {0u, 1u}) {
    const Vertex end = side == 0 ? v : w;
    if (!inside(end)) continue;
    place.pieces[side] = other_piece(end, piece);
    place.far[side] = far_end(place.pieces[side], end);
  }
  return true;
}

CurvePlace OriginalCurves::around(Vertex v) const {
  CurvePlace place;
  const auto& [a, b] = nodes_[node_of_[v]].pieces;
  place.pieces = {a, b, no_index};
  place.far = {far_end(a, v), far_end(b, v)};
  return place;
}

std::array<Vertex, 2> OriginalCurves::neighbours(Vertex v) const { return around(v).far; }

template <typename Visit>
void OriginalCurves::for_points(const CurvePlace& place, Visit&& visit) const {
  for (const std::uint32_t piece : place.pieces) {
    if (piece == no_index) continue;
    for (std::uint32_t i = pieces_[piece].first; i != no_index; i = points_[i].next)
      visit(points_[i]);
  }
}

double OriginalCurves::length(const CurvePlace& place) const {
  double sum = 0;
  for_points(place, [&](const Point& p) { sum += p.length; });
  return sum;
}

CurveError OriginalCurves::error(const Mesh& mesh, const CurvePlace& place,
                                 const glm::dvec3& x) const {
  const Feet feet(mesh, place, x);
  CurveError error;
  for_points(place, [&](const Point& p) {
    error.squares += p.length * feet.of(p.position).distance2;
    error.length += p.length;
  });
  return error;
}

Quadric OriginalCurves::quadric(const Mesh& mesh, const CurvePlace& place,
                                const glm::dvec3& x) const {
  const Feet feet(mesh, place, x);
  std::array<glm::dvec3, 2> ends{}, directions{};  // of the pieces to either side
  for (std::size_t side = 0; side < 2; ++side) {
    if (!place.far[side].valid()) continue;
    ends[side] = mesh.position(place.far[side]) - x;
    const double length = glm::length(ends[side]);
    if (length > 0) directions[side] = ends[side] / length;
  }
  Quadric sum;
  for_points(place, [&](const Point& p) {
    const Foot foot = feet.of(p.position);
    const double own = 1 - foot.part;
    if (!(own > 0)) return;
    const glm::dvec3 off = (p.position - x - foot.part * ends[foot.side]) / own;
    const double weight = own * own * p.length;
    sum.add_point(off, weight);
    const glm::dvec3& along = directions[foot.side];
    if (along != glm::dvec3(0.0)) sum.add_plane(along, -glm::dot(along, off), -weight);
  });
  return sum;
}

// An arc as high as h over a chord of length l turns by twice the angle with the tangent 2 h / l.
double OriginalCurves::turn_cosine(const Mesh& mesh, const CurvePlace& place,
                                   const glm::dvec3& x) const {
  const Feet feet(mesh, place, x);
  double cosine = 1;
  for_points(place, [&](const Point& p) {
    const Foot foot = feet.of(p.position);
    const double length2 = squared(mesh.position(place.far[foot.side]) - x);
    if (foot.distance2 > 0)
      cosine = std::min(cosine, (length2 - 4 * foot.distance2) / (length2 + 4 * foot.distance2));
  });
  return cosine;
}

// The pieces hold all points between their ends; which of two holds one says only where a search
// for its foot begins.
void OriginalCurves::merged(const Mesh& mesh, Vertex deleted, Vertex kept) {
  const std::uint32_t gone = piece_between(deleted, kept);
  if (gone == no_index) return;
  const std::uint32_t stretched = other_piece(deleted, gone);
  auto& ends = pieces_[stretched].ends;
  std::replace(ends.begin(), ends.end(), deleted, kept);
  Node& node = nodes_[node_of_[kept]];
  std::replace(node.pieces.begin(), node.pieces.end(), gone, stretched);
  CurvePlace place;
  place.pieces = {stretched, no_index, gone};
  place.far[0] = far_end(stretched, kept);
  if (inside(kept)) {
    place.pieces[1] = other_piece(kept, stretched);
    place.far[1] = far_end(place.pieces[1], kept);
  }
  node.inside = node.inside && place.far[0] != kept && place.far[0] != place.far[1];
  share_out(mesh, place, kept);
}

void OriginalCurves::share_out(const Mesh& mesh, const CurvePlace& place, Vertex v) {
  std::array<std::uint32_t, 3> rest{};
  for (std::size_t i = 0; i < 3; ++i)
    rest[i] = place.pieces[i] == no_index ? no_index
                                          : std::exchange(pieces_[place.pieces[i]].first, no_index);
  const Feet feet(mesh, place, mesh.position(v));
  for (std::uint32_t i : rest)
    while (i != no_index) {
      const std::uint32_t following = points_[i].next;
      add_point(place.pieces[feet.of(points_[i].position).side], i);
      i = following;
    }
  for (const std::uint32_t piece : place.pieces)
    if (piece != no_index) join_points(piece);
}

// Two in a row that stand for more than twice their share stay, so that half of the points do.
void OriginalCurves::join_points(std::uint32_t piece) {
  std::uint32_t count = 0;
  double length = 0;
  for (std::uint32_t i = pieces_[piece].first; i != no_index; i = points_[i].next)
    ++count, length += points_[i].length;
  if (count <= most_points_) return;
  const double enough = 4 * length / most_points_;
  for (std::uint32_t i = pieces_[piece].first; i != no_index; i = points_[i].next)
    for (std::uint32_t out = points_[i].next;
         out != no_index && points_[i].length + points_[out].length <= enough;
         out = points_[i].next = points_[out].next)
      points_[i].length += std::exchange(points_[out].length, 0);
}

void OriginalCurves::locate(const Mesh& mesh) {
  if (empty()) return;
  for (const Vertex v : mesh.vertices())
    if (inside(v)) share_out(mesh, around(v), v);
}

void OriginalCurves::locate_anywhere(const Mesh& mesh) {
  find_pieces(mesh);
  struct Curve {
    std::vector<std::uint32_t> pieces, points;
  };
  std::map<ModelRef, Curve> curves;
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) curves[pieces_[i].curve].pieces.push_back(i);
  for (std::uint32_t i = 0; i < points_.size(); ++i) curves[points_[i].curve].points.push_back(i);
  for (const auto& [ref, curve] : curves) {
    std::vector<Triangle> segments;
    for (const std::uint32_t i : curve.pieces) {
      const glm::dvec3 a = mesh.position(pieces_[i].ends[0]), b = mesh.position(pieces_[i].ends[1]);
      segments.push_back({a, b, b});
    }
    const TriangleTree tree(segments);
    std::uint32_t hint = no_index;
    for (const std::uint32_t i : curve.points) {
      hint = tree.nearest(points_[i].position, hint).triangle;
      if (hint != no_index) add_point(curve.pieces[tree.source(hint)], i);
    }
  }
}

}  // namespace aomd
