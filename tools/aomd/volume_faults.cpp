#include "tools/aomd/volume_faults.h"

#include "core/base/text.h"
#include "core/measure/volume_statistics.h"

namespace aomd::cli {
namespace {

// Those that their neighbours prove to be numbered inside out are none of these: readers turn them.
std::string inverted_note(const VolumeFaults& faults, const std::string& kind) {
  return grouped(faults.inverted) + " of " + grouped(faults.regions) + " " + kind +
         " stand inside out or are flat, and may stay so: aomd check names them";
}

}  // namespace

VolumeFaults::VolumeFaults(const Mesh& mesh, const measure::Counts& counts)
    : regions(counts.regions), crowded(counts.nonmanifold_faces), folded(counts.folded_faces) {
  for (const Region r : mesh.regions()) inverted += !(measure::signed_volume(mesh, r) > 0);
}

std::vector<std::string> notes_of(const VolumeFaults& faults, const char* kind) {
  std::vector<std::string> notes;
  if (faults.inverted > 0) notes.push_back(inverted_note(faults, kind));
  const auto places = [&](std::size_t faces, const char* what, const char* words) {
    if (faces > 0)
      notes.push_back(counted(faces, "face") + what + kind + words +
                      ", and may stay so: aomd check names them");
  };
  places(faults.crowded, " of three or more ", "");
  places(faults.folded, " with two ", " on one side");
  return notes;
}

std::optional<std::string> made_worse(const VolumeFaults& before, const VolumeFaults& after) {
  const auto more = [](std::size_t was, std::size_t is) { return is > was ? is - was : 0; };
  if (const std::size_t n = more(before.inverted, after.inverted); n > 0)
    return counted(n, "region") + " inside out";
  if (const std::size_t n = more(before.crowded, after.crowded); n > 0)
    return counted(n, "face") + " of three or more regions";
  if (const std::size_t n = more(before.folded, after.folded); n > 0)
    return counted(n, "face") + " with two regions on one side";
  return {};
}

}  // namespace aomd::cli
