#include "viewer/explain/measures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include <glm/geometric.hpp>

#include "core/measure/volume_statistics.h"
#include "core/mesh/geometry.h"

namespace aomd::scene {
namespace {

std::string five_digits(double value) {
  std::array<char, 32> text{};
  static_cast<void>(std::snprintf(text.data(), text.size(), "%.5g", value));
  return text.data();
}

void add(Measures& measures, std::string name, double value, const char* unit = "") {
  measures.facts.emplace_back(std::move(name), five_digits(value) + unit);
  measures.values.push_back(value);
}

double length_of(const Mesh& mesh, const Ruler& ruler) {
  return glm::length(mesh.position(ruler[0]) - mesh.position(ruler[1]));
}

double angle_deg(const glm::dvec3& a, const glm::dvec3& b) {
  return std::acos(std::clamp(cosine_between(a, b), -1.0, 1.0)) * 180 / std::numbers::pi;
}

std::string name_of(Vertex v) { return std::to_string(v.index); }

void add_pair(const Mesh& mesh, const Ruler& ruler, Measures& measures) {
  add(measures, "Distance", length_of(mesh, ruler));
  const glm::dvec3 along = mesh.position(ruler[1]) - mesh.position(ruler[0]);
  for (const int axis : {0, 1, 2})
    add(measures, std::string("    along ") + "xyz"[axis], std::abs(along[axis]));
}

/// Its sides, the angles between them, and the area.
void add_triangle(const Mesh& mesh, const std::vector<Ruler>& sides, Measures& measures) {
  for (const Ruler& side : sides)
    add(measures, "From " + name_of(side[0]) + " to " + name_of(side[1]), length_of(mesh, side));
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 at = mesh.position(sides[i][0]);
    add(measures, "Angle at " + name_of(sides[i][0]),
        angle_deg(mesh.position(sides[i][1]) - at, mesh.position(sides[(i + 2) % 3][0]) - at),
        "\u00b0");
  }
  const glm::dvec3 a = mesh.position(sides[0][0]);
  const glm::dvec3 u = mesh.position(sides[1][0]) - a, w = mesh.position(sides[2][0]) - a;
  add(measures, "Area between", 0.5 * glm::length(glm::cross(u, w)));
}

/// As a fan around its first corner.
double area_of(const Mesh& mesh, EntityRef face) {
  VertexBuffer buffer;
  const auto v = mesh.vertices_of(face, buffer);
  glm::dvec3 normal(0);
  const auto at = [&](std::size_t k) { return mesh.position(Vertex(v[k])); };
  for (std::size_t k = 1; k + 1 < v.size(); ++k)
    normal += glm::cross(at(k) - at(0), at(k + 1) - at(0));
  return 0.5 * glm::length(normal);
}

double size_of(const Mesh& mesh, EntityRef e) {
  if (e.dimension == 3) return std::abs(measure::signed_volume(mesh, Region(e.index)));
  if (e.dimension == 2) return area_of(mesh, e);
  VertexBuffer buffer;
  const auto ends = mesh.vertices_of(e, buffer);
  return length_of(mesh, {Vertex(ends[0]), Vertex(ends[1])});
}

void add_sum(const Mesh& mesh, std::span<const EntityRef> entities, Measures& measures) {
  constexpr std::array<const char*, 4> names = {"", "Length", "Area", "Volume"};
  double sum = 0;
  for (const EntityRef e : entities) sum += size_of(mesh, e);
  const std::string name = names[static_cast<std::size_t>(entities[0].dimension)];
  add(measures, entities.size() > 1 ? name + " of all" : name, sum);
}

}  // namespace

Measures measure_selection(const Mesh& mesh, const Selection& selection) {
  const auto entities = selection.entities();
  Measures measures;
  const bool alike = !entities.empty() && entities.front().dimension == entities.back().dimension;
  if (!alike) return measures;
  if (entities[0].dimension > 0) {
    add_sum(mesh, entities, measures);
    return measures;
  }
  const std::vector<Ruler> rulers = rulers_of(selection);
  if (rulers.size() == 1) add_pair(mesh, rulers[0], measures);
  if (rulers.size() == 3) add_triangle(mesh, rulers, measures);
  return measures;
}

std::vector<Ruler> rulers_of(const Selection& selection) {
  const auto entities = selection.entities();
  const bool few = entities.size() == 2 || entities.size() == 3;
  if (!few || entities.back().dimension > 0) return {};  // they are sorted, vertices first
  const auto vertex = [&](std::size_t k) { return Vertex(entities[k].index); };
  if (entities.size() == 2) return {{vertex(0), vertex(1)}};
  return {{vertex(0), vertex(1)}, {vertex(1), vertex(2)}, {vertex(2), vertex(0)}};
}

std::string ruler_text(const Mesh& mesh, const Ruler& ruler) {
  return five_digits(length_of(mesh, ruler));
}

}  // namespace aomd::scene
