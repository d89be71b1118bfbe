#include "viewer/explain/seam_words.h"

#include <algorithm>

namespace aomd::scene {
namespace {

/// The arrays that have a seam at one of these vertices, as a sentence; else an empty string.
std::string words(const std::vector<VertexSeams>& seams, std::initializer_list<Vertex> at) {
  std::string names;
  for (const VertexSeams& each : seams) {
    const bool there = std::any_of(at.begin(), at.end(), [&](Vertex v) {
      return std::binary_search(each.vertices.begin(), each.vertices.end(), v);
    });
    if (there) names += (names.empty() ? "" : " and ") + each.array;
  }
  return names.empty() ? names : " The seam of " + names + " would tear.";
}

/// Those that both vertices lie on.
std::string common_words(const std::vector<VertexSeams>& seams, Vertex a, Vertex b) {
  std::vector<VertexSeams> common;
  for (const VertexSeams& each : seams)
    if (!words({each}, {a}).empty() && !words({each}, {b}).empty()) common.push_back(each);
  return words(common, {a});
}

}  // namespace

void add_seam_words(const Document& document, EntityVerdict& verdict) {
  const std::vector<VertexSeams>& seams = document.content().seams;
  const Mesh& mesh = document.mesh();
  if (seams.empty()) return;
  for (CollapseWay& way : verdict.ways)
    if (way.outlook.verdict.reason == Reason::Classification)
      way.words += words(seams, {way.outlook.contraction.deleted});
  if (verdict.swap && verdict.swap->verdict.reason == Reason::Classification &&
      mesh.classification(verdict.entity).dimension() == 1) {
    const auto [a, b] = mesh.edge_vertices(Edge(verdict.entity.index));
    verdict.swap_words += common_words(seams, a, b);
  }
  if (verdict.move && verdict.move->verdict.reason == Reason::Classification)
    verdict.move_words += words(seams, {verdict.move->vertex});
}

}  // namespace aomd::scene
