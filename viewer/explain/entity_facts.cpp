#include "viewer/explain/entity_facts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/measure/volume_statistics.h"
#include "core/mesh/derive.h"
#include "core/mesh/geometry.h"
#include "core/mesh/names.h"
#include "core/model/model.h"
#include "viewer/base/text.h"
#include "viewer/explain/value_facts.h"

namespace aomd::scene {
namespace {

std::string point_text(const glm::dvec3& p) {
  return short_number(p.x, 6) + ", " + short_number(p.y, 6) + ", " + short_number(p.z, 6);
}

std::string degrees_text(double deg) { return short_number(deg, 1) + " deg"; }

double degrees(double cosine) {
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
}

AdjacentLevel adjacent_level(const Mesh& mesh, EntityRef e, int level) {
  const AdjacencyPath path = explain(mesh, e.dimension, level);
  AdjacentLevel result{level, {}, path.kind == AdjacencyPath::Kind::Stored, true, {}, path.text()};
  if (result.stored) result.how = "stored";
  const bool no_hash = path.by_hash && !mesh.hash(level).built();
  if (path.kind == AdjacencyPath::Kind::None || no_hash ||
      (level < e.dimension && !mesh.complete(level) && level > 0)) {
    result.known = false;
    if (path.kind != AdjacencyPath::Kind::None)
      result.how = "not asked: it needs " + relation_name(e.dimension, level);
    return result;
  }
  adjacent(mesh, e, level, result.ids);
  if (!result.stored) return result;
  for (const std::uint32_t id : result.ids) {
    if (e.dimension == 2 && level == 1)
      result.forwards.push_back(mesh.use_direction(Face(e.index), Edge(id)));
    if (e.dimension == 3 && level == 2)
      result.forwards.push_back(mesh.use_direction(Region(e.index), Face(id)));
  }
  return result;
}

/// Only of surfaces that store T(0,2): the angle between the normals of an edge's two faces.
void add_fold(const Mesh& mesh, std::span<const std::uint32_t> faces, EntityFacts& result) {
  if (faces.size() != 2) return;
  std::array<glm::dvec3, 2> normals;
  VertexBuffer buffer;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto v = mesh.vertices_of({2, faces[i]}, buffer);
    normals[i] = area_normal(mesh.position(Vertex(v[0])), mesh.position(Vertex(v[1])),
                             mesh.position(Vertex(v[2])));
  }
  result.facts.emplace_back("Fold", degrees_text(degrees(cosine_between(normals[0], normals[1]))));
}

void add_edge_facts(const Document& document, EntityRef e, EntityFacts& result) {
  const Mesh& mesh = document.mesh();
  VertexBuffer buffer;
  const auto ends = mesh.vertices_of(e, buffer);
  const glm::dvec3 a = mesh.position(Vertex(ends[0])), b = mesh.position(Vertex(ends[1]));
  result.facts.emplace_back("Length", significant(glm::length(a - b)));
  if (const Decimation* decimation = document.decimation()) {
    const double wanted =
        std::max(decimation->spacing(Vertex(ends[0])), decimation->spacing(Vertex(ends[1])));
    result.facts.emplace_back("Spacing", std::isfinite(wanted) ? significant(wanted) : "no limit");
  }
  for (const AdjacentLevel& l : result.adjacent)
    if (l.level == 2 && mesh.dimension() == 2) add_fold(mesh, l.ids, result);
}

void add_face_facts(const Mesh& mesh, EntityRef e, EntityFacts& result) {
  VertexBuffer buffer;
  const auto v = mesh.vertices_of(e, buffer);
  double area = 0, least = 180, most = 0;
  const std::size_t n = v.size();
  for (std::size_t k = 0; k < n; ++k) {
    const glm::dvec3 p = mesh.position(Vertex(v[k])), next = mesh.position(Vertex(v[(k + 1) % n])),
                     last = mesh.position(Vertex(v[(k + n - 1) % n]));
    const double angle = degrees(cosine_between(next - p, last - p));
    least = std::min(least, angle);
    most = std::max(most, angle);
    if (k >= 2) area += 0.5 * glm::length(area_normal(mesh.position(Vertex(v[0])), last, p));
  }
  result.facts.emplace_back("Area", significant(area));
  result.facts.emplace_back("Angles", short_number(least, 1) + " to " + degrees_text(most));
}

void add_region_facts(const Mesh& mesh, Region r, EntityFacts& result) {
  result.facts.emplace_back("Shape", std::string(shape_template(mesh.shape(r)).name));
  result.facts.emplace_back("Volume", significant(measure::signed_volume(mesh, r)));
  result.facts.emplace_back("Dihedral angle",
                            degrees_text(measure::smallest_dihedral_deg(mesh, r)) + " at least");
}

void add_vertex_facts(const Document& document, Vertex v, EntityFacts& result) {
  result.facts.emplace_back("At", point_text(document.mesh().position(v)));
  for (const AdjacentLevel& l : result.adjacent)
    if (l.level == 1 && l.known) result.facts.emplace_back("Valence", std::to_string(l.ids.size()));
  const Decimation* decimation = document.decimation();
  if (decimation == nullptr) return;
  const double wanted = decimation->spacing(v);
  result.facts.emplace_back("Spacing", std::isfinite(wanted) ? significant(wanted) : "no limit");
}

std::string mark(CheckResult::State state) {
  return state == CheckResult::State::Passed   ? "yes"
         : state == CheckResult::State::Failed ? "NO"
                                               : "-";
}

std::string judgement_text(const EntityVerdict& j) {
  std::string text;
  for (const CollapseWay& way : j.ways) {
    text += way_title(way) + ": " + way.words + "\n ";
    for (const CheckResult& check : way.checks)
      text += " " + std::string(check.name) + " " + mark(check.state);
    text += "\n";
    if (way.outlook.cost) text += "  cost " + significant(*way.outlook.cost) + "\n";
  }
  if (!j.swap_words.empty()) text += "Swap: " + j.swap_words + "\n";
  if (!j.move_words.empty()) text += "Smoothing: " + j.move_words + "\n";
  return text;
}

}  // namespace

std::string adjacent_text(const AdjacentLevel& level, std::size_t which) {
  const std::string id = std::to_string(level.ids[which]);
  return level.forwards.empty() ? id : (level.forwards[which] ? "+" : "-") + id;
}

std::string entity_title(EntityRef e) { return capitalized(name_of(e)); }

std::string entity_label(EntityRef e) {
  return entity_name(e.dimension)[0] + std::to_string(e.index);
}

std::string model_words(ModelRef ref) { return ref.valid() ? name_of(ref) : "not classified"; }

EntityFacts entity_facts(const Document& document, EntityRef e) {
  const Mesh& mesh = document.mesh();
  EntityFacts result{e, {}, {}};
  for (int level = 0; level < 4; ++level)
    if (level != e.dimension && (level < 3 || mesh.count(3) > 0))
      result.adjacent.push_back(adjacent_level(mesh, e, level));
  result.facts.emplace_back("Lies on", model_words(mesh.classification(e)));
  if (e.dimension == 0) add_vertex_facts(document, Vertex(e.index), result);
  if (e.dimension == 1) add_edge_facts(document, e, result);
  if (e.dimension == 2) add_face_facts(mesh, e, result);
  if (e.dimension == 3) add_region_facts(mesh, Region(e.index), result);
  add_value_facts(document, e, result.facts);
  return result;
}

std::string entity_facts_text(const EntityFacts& inspection, const EntityVerdict* judgement) {
  std::string text = entity_title(inspection.entity) + "\n";
  for (const auto& [name, value] : inspection.facts) text += name + ": " + value + "\n";
  for (const AdjacentLevel& level : inspection.adjacent) {
    text += capitalized(entity_plural(level.level));
    if (level.known) text += " " + std::to_string(level.ids.size()) + ":";
    for (std::size_t i = 0; i < level.ids.size(); ++i) text += " " + adjacent_text(level, i);
    text += " (" + level.how + ")\n";
  }
  return judgement ? text + judgement_text(*judgement) : text;
}

}  // namespace aomd::scene
