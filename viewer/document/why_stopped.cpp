#include "viewer/document/why_stopped.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "viewer/base/text.h"

namespace aomd::scene {
namespace {

/// What decided, as one says it after "mostly by".
const char* decider(Reason reason) {
  constexpr std::array<const char*, reason_count> names = {
      "nothing",      "length",    "the classification", "the topology", "faces without area",
      "the angle",    "the shape", "vertices to keep",   "small angles", "the distance",
      "intersections"};
  return names[static_cast<std::size_t>(reason)];
}

/// What a reason says of `n` edges.
std::string said_of(Reason reason, bool one, const DecimationOptions& options) {
  switch (reason) {
    case Reason::None:
      return "could go now that all is fitted";
    case Reason::Spacing:
      return one ? "is long enough for the spacing" : "are long enough for the spacing";
    case Reason::Classification:
      return "would cut a corner off the model";
    case Reason::Topology:
      return "would pinch or tear the surface";
    case Reason::Flat:
      return "would leave a face without area";
    case Reason::Angle:
      return "would turn a face by more than " + short_number(options.angle_deg, 1) + " degrees";
    case Reason::Quality:
      return "would make the shape worse";
    case Reason::Kept:
      return one ? "is to stay" : "are to stay";
    case Reason::Shape:
      return "would make an angle too small";
    case Reason::Distance:
      return "would leave the original";
    case Reason::Intersection:
      break;
  }
  return "would cut the surface with itself";
}

using Count = std::pair<std::int64_t, Reason>;

/// What keeps any, the most first.
std::vector<Count> by_number(const EdgesByReason& edges) {
  std::vector<Count> counts;
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (edges[i] > 0) counts.emplace_back(edges[i], static_cast<Reason>(i));
  std::stable_sort(counts.begin(), counts.end(),
                   [](const Count& a, const Count& b) { return a.first > b.first; });
  return counts;
}

}  // namespace

EdgesByReason edges_left(Decimation& decimation, const Mesh& mesh) {
  constexpr std::uint32_t judged_at_once = 300'000;  // less than a second
  EdgesByReason edges{};
  if (decimation.options().strategy == Strategy::Paper && mesh.count(1) > judged_at_once) {
    const auto& refused = decimation.sweeps().back().refused;
    std::copy(refused.begin(), refused.end(), edges.begin());
    return edges;
  }
  Vertex deleted;
  for (const Edge e : mesh.edges())
    ++edges[static_cast<std::size_t>(decimation.judge(e, deleted).reason)];
  return edges;
}

std::string why_stopped(const EdgesByReason& edges, const DecimationOptions& options,
                        std::int64_t faces) {
  const std::string target = counted(options.target_faces, "face");
  if (options.target_faces > 0 && faces <= options.target_faces)
    return "Stopped at the aim of " + target + ".";
  const std::vector<Count> counts = by_number(edges);
  const std::int64_t all = std::accumulate(edges.begin(), edges.end(), std::int64_t{0});
  std::string text = options.target_faces > 0 ? "Stopped above the aim of " + target : "Stopped";
  if (counts.empty()) return text + ": no edge is left.";
  const auto [most, reason] = counts.front();
  if (reason != Reason::None && 2 * most > all)
    text += std::string(", mostly by ") + decider(reason);
  std::vector<std::string> parts;
  for (const auto& [n, why] : counts)
    parts.push_back(grouped(n) + " " + said_of(why, n == 1, options));
  return text + ": of " + counted(all, "edge") + " left, " + joined(parts, " and ") + ".";
}

}  // namespace aomd::scene
