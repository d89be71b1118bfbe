#pragma once
// The camera: a turntable around a point. No GL.

#include <optional>
#include <string>
#include <string_view>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "viewer/base/box.h"
#include "viewer/base/up_axis.h"

namespace aomd::scene {

enum class StandardView { Iso, Front, Back, Left, Right, Top, Bottom };

struct Ray {
  glm::dvec3 origin{0};
  glm::dvec3 direction{0, 0, -1};  ///< unit length
};

/// A turntable: it looks at `target` from `distance`, turned by `azimuth_deg` around the up axis (0
/// is the front, positive moves the eye to the right) and raised by `elevation_deg` in [-90,90], so
/// that it cannot flip over. All lengths are in world units. A screen position is given as `ndc`,
/// -1..1 to the right and upward; `aspect` is width by height. In orthographic projection
/// `distance` gives the scale: what lies at the target keeps its size when the projection is
/// switched.
class Camera {
 public:
  glm::dvec3 target{0};
  double azimuth_deg = 45;
  double elevation_deg = 30;
  double distance = 3;
  double fov_deg = 30;  ///< vertical angle of view, in (0,170)
  bool orthographic = false;
  UpAxis up_axis = UpAxis::Z;

  void orbit(double azimuth_step_deg, double elevation_step_deg);
  /// Moves so that what lies at the target's depth under `from` comes to lie under `to`.
  void pan(glm::dvec2 from, glm::dvec2 to, double aspect);
  /// Scales the distance by `factor` (> 0, below 1 is nearer); what lies at the target's depth
  /// under `ndc` stays.
  void zoom(double factor, glm::dvec2 ndc, double aspect);
  /// Looks at the whole box, as near as the present direction and projection allow. An empty box or
  /// a point changes the target only.
  void fit(const Box& box, double aspect);
  /// From how far away that is, for a box that is more than a point.
  [[nodiscard]] double fitting_distance(const Box& box, double aspect) const;
  /// Turns to a standard view, keeping target and distance.
  void turn_to(StandardView view);

  [[nodiscard]] glm::dvec3 eye() const;
  [[nodiscard]] glm::dvec3 right() const;
  [[nodiscard]] glm::dvec3 up() const;
  /// Unit vector from the eye into the scene.
  [[nodiscard]] glm::dvec3 forward() const;
  /// Half the height of what is seen at the target's depth, in world units.
  [[nodiscard]] double half_height() const;

  /// World to eye space (x right, y up, looking along -z).
  [[nodiscard]] glm::dmat4 view() const;
  /// Eye to clip space; near and far enclose `scene`, whatever the camera does.
  [[nodiscard]] glm::dmat4 projection(double aspect, const Box& scene) const;
  /// The ray under a screen position: from the eye, or in orthographic projection from in front of
  /// `scene`.
  [[nodiscard]] Ray ray(glm::dvec2 ndc, double aspect, const Box& scene) const;

  /// "azimuth=45 elevation=30 distance=3 target=0,0,0 fov=30 perspective up=z": parse_camera gives
  /// back an equal camera.
  [[nodiscard]] std::string to_text() const;

  friend bool operator==(const Camera&, const Camera&) = default;

 private:
  struct DepthRange {
    double near_depth = 0;
    double far_depth = 0;
  };
  [[nodiscard]] DepthRange depth_range(const Box& scene) const;
  [[nodiscard]] glm::dvec3 on_target_plane(glm::dvec2 ndc, double aspect) const;
};

/// "iso", "front", "back", "left", "right", "top" or "bottom".
[[nodiscard]] std::optional<StandardView> standard_view(std::string_view name);
/// The name of the view whose eye is at one end of an axis: 0 <= axis < 3.
[[nodiscard]] std::string_view view_from(int axis, bool positive, UpAxis up);

/// What parse_camera answers: a camera, or the reason why the text is none.
struct CameraSpec {
  std::optional<Camera> camera;
  std::string error;
};

/// Reads the text of `--camera` and of the command `camera`: words applied from left to right to
/// `start`.
///   iso front back left right top bottom   a standard view, fitted to `scene`
///   azimuth=DEG elevation=DEG              the direction (elevation is clamped to [-90,90])
///   target=X,Y,Z distance=LENGTH           the point looked at, and from how far
///   zoom=FACTOR                            2 shows things twice as large
///   fov=DEG up=y|z perspective orthographic fit
/// Examples: "iso", "front orthographic zoom=2", "azimuth=30 elevation=20 fit".
[[nodiscard]] CameraSpec parse_camera(std::string_view text, const Camera& start, const Box& scene,
                                      double aspect);

}  // namespace aomd::scene
