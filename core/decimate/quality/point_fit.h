#pragma once
// Improvement against the original surface: vertices go where the original's points want their
// faces, and edges are swapped where that brings the surface closer or its triangles into better
// shape.

#include <vector>

#include "core/base/lanes.h"
#include "core/decimate/curves/original_curves.h"
#include "core/decimate/quality/attribute_fit.h"
#include "core/decimate/quality/original_surface.h"
#include "core/model/model.h"
#include "core/operators/star.h"
#include "core/operators/swap.h"

namespace aomd {

/// Weights of one energy: sum over the original's points of weight * distance^2, plus for each face
/// `face_energy` * `shape` * (1 / quality - 1), where quality is 4 sqrt(3) area / (sum of squared
/// sides).
struct FitRules {
  double shape = 1;    ///< what a misshapen face costs, in multiples of face_energy
  double pull = 0.01;  ///< how strongly the neighbourhood's centre pulls along the surface
  double stay =
      0.1;  ///< how strongly a vertex keeps to the plane of the nearest point of the original
  /// 0: face_energy counts for all faces alike; 1: for each in proportion to its own error, where
  /// that is smaller. Thin triangles that lie right then cost little.
  double local = 0;
  double face_energy = 0;  ///< the error of an average face, set from the present state
  /// How much more points count that are further off, and the plane of the nearest point where the
  /// vertex is, by the squared distance of an average point.
  double far = 0.1, stay_far = 0.3;
  double mean_square = 1;  ///< the squared distance of an average point, set from the present state
  TurnLimit max_turn{
      30.0};  ///< of a face against what it was; after a swap, against the two old ones together
  TurnLimit max_away{60.0};  ///< of a face against the original under it
  LeastAngle least_angle{
      0};  ///< no face gets a smaller one, unless it had one (a swap: one of its two)
  const Model* model =
      nullptr;  ///< vertices go to its nearest point instead; none: where the fit puts them
};

/// 4 sqrt(3) area / (sum of squared sides): 1 for an equilateral triangle, 0 for one without area.
[[nodiscard]] double triangle_quality(const glm::dvec3& a, const glm::dvec3& b,
                                      const glm::dvec3& c);

/// Judges moves and swaps on one mesh against one original. The mesh must store T(0,2) and T(2,0);
/// the points of the original must have been located on it. O(faces around the place and the points
/// on them).
class Fitter {
 public:
  Fitter(const Mesh& mesh, OriginalSurface& original, const OriginalCurves& curves)
      : mesh_(mesh), original_(original), curves_(curves) {}
  /// From now on these numbers count too. They must outlive it.
  void count(AttributeFit& values) { values_ = &values; }

  /// Where a vertex inside a model face would go: the least-squares place for the points on the
  /// faces around it, each seen as a plane through its face, pulled along the surface towards the
  /// neighbourhood's centre; inside a model edge that for these points and those of the edge,
  /// pulled along it. Half or a quarter of the way where all of it goes too far. Refusals:
  /// Classification, Flat (no area around it), Angle (against what the face was, or the original
  /// under it), Quality (a poor face would get poorer, or the model edge further
  /// off), Shape (below the least angle). `star` receives the faces around the vertex.
  [[nodiscard]] Verdict judge_move(Vertex v, const FitRules& rules, Star& star,
                                   glm::dvec3& target) const;

  /// Whether swapping the edge between a and b lowers the energy. Refusals: those of find_pair,
  /// Topology (the other diagonal exists), Flat, Angle (a new face against the two old ones
  /// together, or the original under them), Shape (below the least angle), Quality (no gain).
  /// Several threads may ask at once, after Mesh::build_hash() where edges are found by it.
  [[nodiscard]] Verdict judge_swap(Vertex a, Vertex b, const FitRules& rules, EdgePair& pair) const;
  /// Gives the points of the two faces to those that they are nearest to. Call right before
  /// apply_swap().
  void swapped(const EdgePair& pair);

 private:
  [[nodiscard]] Verdict judge_target(Vertex v, const Star& star, const glm::dvec3& target,
                                     const FitRules& rules) const;
  [[nodiscard]] bool least_squares(Vertex v, const Star& star, const FitRules& rules,
                                   glm::dvec3& target) const;
  [[nodiscard]] bool least_squares_on_curve(Vertex v, const Star& star, const FitRules& rules,
                                            glm::dvec3& target) const;
  /// Adds the points on the faces around a vertex, as seen from it; returns their weight.
  double add_points(Vertex v, const Star& star, Quadric& error) const;
  [[nodiscard]] bool loses_values(Vertex v, const Star& star, const glm::dvec3& target,
                                  const FitRules& rules) const;
  [[nodiscard]] bool leaves_curve(Vertex v, const glm::dvec3& target) const;
  [[nodiscard]] static bool looks_away(const glm::dvec3& original, const glm::dvec3& normal,
                                       const FitRules& rules);
  [[nodiscard]] double error_of_values(const EdgePair& pair) const;
  [[nodiscard]] double error_of_values(const EdgePair& pair, const OriginalPoint& p,
                                       const TwoPoints& at, std::size_t face) const;
  [[nodiscard]] double swap_gain(const EdgePair& pair, const FitRules& rules, double enough) const;

  const Mesh& mesh_;
  OriginalSurface& original_;
  const OriginalCurves& curves_;
  AttributeFit* values_ = nullptr;  ///< none: the shape alone counts
};

}  // namespace aomd
