#include "viewer/session/seen_files.h"

#include <algorithm>
#include <system_error>

#include <glm/geometric.hpp>

namespace aomd::scene {
namespace {

std::filesystem::path whole_path(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::absolute(file, ignored).lexically_normal();
}

/// Seen from where the one was seen, the other one is in sight too.
bool alike(const Box& a, const Box& b) {
  constexpr double most_times = 3;
  const double small = std::min(a.diagonal(), b.diagonal());
  const double large = std::max(a.diagonal(), b.diagonal());
  return small > 0 && large <= most_times * small &&
         glm::distance(a.center(), b.center()) <= 0.5 * small;
}

}  // namespace

void SeenFiles::remember(const std::filesystem::path& file, const Box& bounds,
                         const Camera& camera) {
  const std::filesystem::path path = whole_path(file);
  std::erase_if(seen_, [&](const Seen& each) { return each.file == path; });
  seen_.push_front({path, bounds, camera});
  if (seen_.size() > most) seen_.pop_back();
}

std::optional<Camera> SeenFiles::camera(const std::filesystem::path& file,
                                        const Box& bounds) const {
  const std::filesystem::path path = whole_path(file);
  for (const Seen& each : seen_)
    if (each.file == path && alike(each.bounds, bounds)) return each.camera;
  return {};
}

}  // namespace aomd::scene
