#pragma once
// The surface that a decimation started from, as points, and the faces of the present mesh that
// they lie on.

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "core/decimate/original_samples.h"
#include "core/mesh/column.h"
#include "core/mesh/mesh.h"
#include "core/model/triangle_tree.h"

namespace aomd {

/// One point of the original surface; a cache line.
struct OriginalPoint {
  glm::dvec3 position;
  glm::vec3 normal{0.0f};  ///< of the original surface there, of length 1, or 0
  float weight = 0;        ///< the area it stands for
  std::uint32_t face =
      no_index;  ///< the face of the present mesh that is nearest, as far as is known
  std::uint32_t next = no_index;  ///< the next point of that face
  glm::vec3 barycentric{0.0f};    ///< of the nearest place on that face, in the face's order
  float distance2 = 0;            ///< squared, to that place
};

/// Where the original has points: at its vertices, or in the middle of each face too, with the
/// weights of the quadrature that is exact for quadratic functions (1/12 of a face at each corner,
/// 3/4 in the middle).
enum class Sampling : std::uint8_t { Vertices, VerticesAndFaces };

/// The vertices of the mesh as it was at construction, and its faces' middles on request, each with
/// the face that it lies on now. Points follow collapses by the vertex that took theirs in, and
/// find the nearest face from there by walking; later changes move them to a neighbour. 64 bytes a
/// point. Not meant for exact distances: a walk may stop at a local minimum.
class OriginalSurface {
 public:
  /// O(vertices + faces). T(2,0) must be stored. Vertices of a surface that bends lie on one side
  /// of what they stand for: where there are no other points they go `inward`, 1: along the normal
  /// as far as the middle of the thirds of faces around them.
  explicit OriginalSurface(const Mesh& mesh, Sampling sampling = Sampling::Vertices,
                           double inward = 0);

  /// Points that are known, with faces of the mesh. O(vertices + points).
  OriginalSurface(const Mesh& mesh, const OriginalSamples& samples);

  [[nodiscard]] const std::vector<OriginalPoint>& points() const { return points_; }
  /// The vertex that a point was, or a corner of the face that it is inside of: those come after
  /// all vertices. Of points that were given: a corner of the face that was given with it.
  [[nodiscard]] Vertex vertex_of(std::size_t point) const { return vertex_of_[point]; }
  /// The diagonal of its box, and its area.
  [[nodiscard]] double diagonal() const { return diagonal_; }
  [[nodiscard]] double area() const { return area_; }

  /// A collapse took `deleted` into `kept`.
  void merged(Vertex deleted, Vertex kept) { taken_by_[deleted] = kept; }
  /// Finds the face of every point: from the vertices that took it in since the last time, else
  /// from the face it lay on. T(0,2) and T(2,0) must be stored. O(points). Here and below the
  /// result does not depend on the number of threads.
  void locate(const Mesh& mesh, int threads = 1);
  /// Forgets all faces and finds each anew by a search over all of `mesh`. O(points log faces).
  void locate_anywhere(const Mesh& mesh, int threads = 1);
  /// The points that lie on faces, as of the last locate().
  [[nodiscard]] OriginalSamples samples() const;
  /// Sum over the points of weight times squared distance, as of the last locate().
  [[nodiscard]] double error() const;

  /// What the original looked like under a face: the sum of its points' normals, each by its
  /// weight; 0 without points.
  [[nodiscard]] glm::dvec3 normal_under(Face f) const {
    return f.index < normal_.size() ? glm::dvec3(normal_[f]) : glm::dvec3(0.0);
  }
  /// Calls visit(point) for the points on a face.
  template <typename Visit>
  void for_points(Face f, Visit&& visit) const {
    if (f.index >= first_.size()) return;
    for (std::uint32_t i = first_[f]; i != no_index; i = points_[i].next) visit(points_[i]);
  }
  /// The same as long as visit(point) is true; whether it was for all of them.
  template <typename Visit>
  bool for_points_while(Face f, Visit&& visit) const {
    std::uint32_t i = f.index < first_.size() ? first_[f] : no_index;
    while (i != no_index && visit(points_[i])) i = points_[i].next;
    return i == no_index;
  }
  /// Distributes the points of two faces anew: to `f` where goes_to_f(point), else to `g`. The call
  /// may set barycentric coordinates and distance.
  template <typename Where>
  void redistribute(Face f, Face g, Where&& goes_to_f);

 private:
  void add_vertices(const Mesh& mesh, double inward);
  void share_out_faces(const Mesh& mesh, const Column<Vertex, std::uint32_t>& point_of);
  void draw_in(const Mesh& mesh, const Column<Vertex, std::uint32_t>& point_of, double inward);
  void add_faces(const Mesh& mesh);
  void locate_point(const Mesh& mesh, std::size_t i);
  static void find_face(const Mesh& mesh, OriginalPoint& p);
  static bool walk_once(const Mesh& mesh, OriginalPoint& p);
  static void start_at_vertex(const Mesh& mesh, OriginalPoint& p, Vertex v);
  [[nodiscard]] Vertex taken_by(Vertex v);
  void link_points(const Mesh& mesh);

  std::vector<OriginalPoint> points_;
  std::vector<Vertex> vertex_of_;    ///< by point: the vertex that it was, or a corner of its face
  Column<Vertex, Vertex> taken_by_;  ///< by vertex: the one that took it in; itself while it lives
  Column<Face, std::uint32_t> first_;  ///< by face: its first point
  Column<Face, glm::vec3> normal_;     ///< by face: see normal_under()
  double diagonal_ = 0, area_ = 0;
};

template <typename Where>
void OriginalSurface::redistribute(Face f, Face g, Where&& goes_to_f) {
  std::uint32_t rest[] = {first_[f], first_[g]};
  first_[f] = first_[g] = no_index;
  normal_[f] = normal_[g] = glm::vec3(0.0f);
  for (std::uint32_t i : rest)
    while (i != no_index) {
      OriginalPoint& p = points_[i];
      const std::uint32_t following = p.next;
      const Face to = goes_to_f(p) ? f : g;
      p.face = to.index;
      normal_[to] += p.weight * p.normal;
      p.next = first_[to];
      first_[to] = i;
      i = following;
    }
}

}  // namespace aomd
