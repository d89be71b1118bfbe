// The text form of a camera.

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <utility>

#include "viewer/drawing/camera.h"

namespace aomd::scene {
namespace {

constexpr std::array<std::pair<std::string_view, StandardView>, 7> view_names = {{
    {"iso", StandardView::Iso},
    {"front", StandardView::Front},
    {"back", StandardView::Back},
    {"left", StandardView::Left},
    {"right", StandardView::Right},
    {"top", StandardView::Top},
    {"bottom", StandardView::Bottom},
}};

/// The shortest text that reads back as the same number, whatever the locale.
std::string number(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

/// Reads exactly out.size() finite numbers separated by commas.
bool read_numbers(std::string_view text, std::span<double> out) {
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (i > 0 && (at == end || *at++ != ',')) return false;
    const auto [next, error] = std::from_chars(at, end, out[i]);
    if (error != std::errc{} || !std::isfinite(out[i])) return false;
    at = next;
  }
  return at == end;
}

/// A camera that is being changed word by word.
struct Parser {
  Camera camera;
  const Box& scene;
  double aspect;

  /// An empty answer means that the word was understood.
  std::string apply(std::string_view word) {
    const std::size_t equals = word.find('=');
    const bool known = equals == std::string_view::npos
                           ? apply_name(word)
                           : apply_value(word.substr(0, equals), word.substr(equals + 1));
    return known ? std::string() : "camera: cannot understand '" + std::string(word) + "'";
  }

 private:
  bool apply_name(std::string_view name) {
    if (const auto view = standard_view(name)) {
      camera.turn_to(*view);
      camera.fit(scene, aspect);
    } else if (name == "perspective" || name == "orthographic") {
      camera.orthographic = name == "orthographic";
    } else if (name == "fit") {
      camera.fit(scene, aspect);
    } else {
      return false;
    }
    return true;
  }

  bool apply_value(std::string_view key, std::string_view value) {
    if (key == "up") return apply_up(value);
    std::array<double, 3> v{};
    if (!read_numbers(value, std::span(v).first(key == "target" ? 3 : 1))) return false;
    const double x = v[0];
    if (key == "target") {
      camera.target = {v[0], v[1], v[2]};
    } else if (key == "azimuth") {
      camera.azimuth_deg = x;
    } else if (key == "elevation") {
      camera.elevation_deg = std::clamp(x, -90.0, 90.0);
    } else if (key == "distance" && x > 0) {
      camera.distance = x;
    } else if (key == "zoom" && x > 0) {
      camera.distance /= x;
    } else if (key == "fov" && x > 0 && x < 170) {
      camera.fov_deg = x;
    } else {
      return false;
    }
    return true;
  }

  bool apply_up(std::string_view value) {
    if (value != "y" && value != "z") return false;
    camera.up_axis = value == "y" ? UpAxis::Y : UpAxis::Z;
    return true;
  }
};

}  // namespace

std::optional<StandardView> standard_view(std::string_view name) {
  for (const auto& [known, view] : view_names)
    if (known == name) return view;
  return std::nullopt;
}

std::string_view view_from(int axis, bool positive, UpAxis up) {
  Camera camera;
  camera.up_axis = up;
  for (const auto& [name, view] : view_names) {
    camera.turn_to(view);
    if (camera.forward()[axis] * (positive ? -1 : 1) > 0.9) return name;
  }
  return "iso";
}

std::string Camera::to_text() const {
  return "azimuth=" + number(azimuth_deg) + " elevation=" + number(elevation_deg) +
         " distance=" + number(distance) + " target=" + number(target.x) + "," + number(target.y) +
         "," + number(target.z) + " fov=" + number(fov_deg) +
         (orthographic ? " orthographic" : " perspective") +
         (up_axis == UpAxis::Y ? " up=y" : " up=z");
}

CameraSpec parse_camera(std::string_view text, const Camera& start, const Box& scene,
                        double aspect) {
  constexpr std::string_view blanks = " \t\r\n;";
  Parser parser{start, scene, aspect};
  bool any = false;
  for (std::size_t at = text.find_first_not_of(blanks); at != std::string_view::npos;
       at = text.find_first_not_of(blanks, at)) {
    const std::size_t end = std::min(text.find_first_of(blanks, at), text.size());
    if (std::string error = parser.apply(text.substr(at, end - at)); !error.empty())
      return {{}, std::move(error)};
    any = true;
    at = end;
  }
  if (!any) return {{}, "camera: the text is empty"};
  return {parser.camera, {}};
}

}  // namespace aomd::scene
