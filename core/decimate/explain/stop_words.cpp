#include "core/decimate/explain/stop_words.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/base/text.h"
#include "core/decimate/explain/verdict_words.h"

namespace aomd {
namespace {

/// What decided, as one says it after "mostly by".
const char* decider(Reason reason) {
  constexpr std::array<const char*, reason_count> names = {"nothing",
                                                           "length",
                                                           "the classification",
                                                           "the topology",
                                                           "faces without area",
                                                           "the angle",
                                                           "the shape",
                                                           "vertices to keep",
                                                           "small angles",
                                                           "the distance",
                                                           "intersections",
                                                           "tetrahedra inside out",
                                                           "overlong edges",
                                                           "the volumes of regions"};
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
      return "would turn a face by more than " + words::degrees(options.angle_deg) + " degrees";
    case Reason::Quality:
      return "would make the shape worse";
    case Reason::Kept:
      return one ? "is to stay" : "are to stay";
    case Reason::Shape:
      return "would make an angle too small";
    case Reason::Distance:
      return "would leave the original";
    case Reason::Inverted:
      return "would turn a tetrahedron inside out";
    case Reason::Overshoot:
      return "would make an edge too long";
    case Reason::Volume:
      return "would change a region's volume too much";
    case Reason::Intersection:
      break;
  }
  return "would cut the surface with itself";
}

/// The same where a volume has other words for it.
std::string said_of_volume(Reason reason, bool one, const DecimationOptions& options) {
  switch (reason) {
    case Reason::Classification:
      return one ? "joins parts of the model that stay" : "join parts of the model that stay";
    case Reason::Topology:
      return "would pinch or tear the model";
    case Reason::Shape:
      return "would make a tetrahedron or face too flat";
    case Reason::Intersection:
      return "would let model faces cut each other";
    default:
      return said_of(reason, one, options);
  }
}

/// "1 edge", "7,160 faces".
std::string grouped_count(std::int64_t n, const char* one) {
  return grouped(n) + " " + (n == 1 ? std::string(one) : plural(one));
}

std::int64_t total(const EdgesByReason& edges) {
  return std::accumulate(edges.begin(), edges.end(), std::int64_t{0});
}

}  // namespace

std::vector<ReasonCount> by_number(const EdgesByReason& edges) {
  std::vector<ReasonCount> counts;
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (edges[i] > 0) counts.push_back({static_cast<Reason>(i), edges[i]});
  std::stable_sort(counts.begin(), counts.end(),
                   [](const ReasonCount& a, const ReasonCount& b) { return a.edges > b.edges; });
  return counts;
}

std::string words_of_edges_left(const EdgesByReason& edges, const DecimationOptions& options,
                                bool volume) {
  constexpr std::size_t most_parts = 6;
  const std::vector<ReasonCount> counts = by_number(edges);
  const std::size_t named = counts.size() > most_parts ? most_parts - 1 : counts.size();
  std::int64_t others = total(edges);
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < named; ++i) {
    const auto [reason, n] = counts[i];
    parts.push_back(grouped(n) + " " +
                    (volume ? said_of_volume : said_of)(reason, n == 1, options));
    others -= n;
  }
  if (named < counts.size()) parts.push_back(grouped(others) + " stay for other reasons");
  if (parts.empty()) return "no edge is left";
  return "of " + grouped_count(total(edges), "edge") + " left, " + joined(parts, " and ");
}

std::string stop_words(const EdgesByReason& edges, const DecimationOptions& options,
                       std::int64_t cells, bool volume) {
  const std::string target = grouped_count(options.target_faces, volume ? "tetrahedron" : "face");
  if (options.target_faces > 0 && cells <= options.target_faces)
    return "Stopped at the aim of " + target + ".";
  std::string text = options.target_faces > 0 ? "Stopped above the aim of " + target : "Stopped";
  if (const auto counts = by_number(edges); !counts.empty()) {
    const auto [reason, most] = counts.front();
    if (reason != Reason::None && 2 * most > total(edges))
      text += std::string(", mostly by ") + decider(reason);
  }
  return text + ": " + words_of_edges_left(edges, options, volume) + ".";
}

}  // namespace aomd
