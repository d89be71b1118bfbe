#include "viewer/explain/value_facts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "viewer/base/text.h"

namespace aomd::scene {
namespace {

using Facts = std::vector<std::pair<std::string, std::string>>;

std::string numbers_text(std::span<const double> numbers) {
  std::string text;
  for (const double x : numbers) text += (text.empty() ? "" : ", ") + short_number(x, 6);
  return text;
}

std::string value_text(double x, const FileNumbers&) { return significant(x); }
std::string value_text(const glm::dvec3& v, const FileNumbers&) {
  return numbers_text(std::array{v.x, v.y, v.z});
}
template <std::size_t N>
std::string value_text(const std::array<double, N>& v, const FileNumbers&) {
  return numbers_text(v);
}
std::string value_text(std::int64_t x, const FileNumbers& numbers) {
  const bool named = x >= 0 && static_cast<std::uint64_t>(x) < numbers.names.size();
  return named ? numbers.names[static_cast<std::size_t>(x)] : std::to_string(x);
}

template <typename T, typename H>
void add_value(const Mesh& mesh, const AttachedBase& column, H h, Facts& facts) {
  if (const auto* values = mesh.find_attached<H, T>(column.name()))
    facts.emplace_back(column.name(), value_text((*values)[h], column.file_numbers()));
}

template <typename H>
void add_values(const Mesh& mesh, H h, Facts& facts) {
  for (const auto& column : mesh.attached(H::dimension)) {
    add_value<double>(mesh, *column, h, facts);
    add_value<std::int64_t>(mesh, *column, h, facts);
    add_value<std::array<double, 2>>(mesh, *column, h, facts);
    add_value<glm::dvec3>(mesh, *column, h, facts);
    add_value<std::array<double, 4>>(mesh, *column, h, facts);
    add_value<std::array<double, 6>>(mesh, *column, h, facts);
    add_value<std::array<double, 9>>(mesh, *column, h, facts);
  }
}

std::string at_corner(const Attribute& a, std::size_t corner) {
  const auto n = static_cast<std::size_t>(a.components);
  return numbers_text(std::span(a.values).subspan(n * corner, n));
}

/// "uv at vertex 7"; the file's faces are triangles, in the order of their ids.
void add_corners_of(const Mesh& mesh, Face face, const Attribute& a, Facts& facts) {
  const auto v = mesh.triangle(face);
  for (std::size_t k = 0; k < 3; ++k)
    facts.emplace_back(a.name + " at vertex " + std::to_string(v[k].index),
                       at_corner(a, 3 * std::size_t{face.index} + k));
}

/// The different ones at a vertex: more than one on a seam.
void add_corners_of(const Mesh& mesh, Vertex vertex, const Attribute& a, Facts& facts) {
  std::vector<std::string> known;
  for (const Face f : mesh.row<2>(vertex)) {
    const auto v = mesh.triangle(f);
    for (std::size_t k = 0; k < 3; ++k) {
      if (v[k] != vertex) continue;
      std::string text = at_corner(a, 3 * std::size_t{f.index} + k);
      if (std::find(known.begin(), known.end(), text) != known.end()) continue;
      facts.emplace_back(a.name + " in face " + std::to_string(f.index), text);
      known.push_back(std::move(text));
    }
  }
}

void add_corners(const Document& document, EntityRef e, Facts& facts) {
  const LoadedMesh& content = document.content();
  const Mesh& mesh = document.mesh();
  if (content.skin || document.journal().cursor() > 0) return;
  for (const Attribute& a : content.corners) {
    if (a.values.size() != 3 * static_cast<std::size_t>(a.components) * mesh.count(2)) continue;
    if (e.dimension == 2) add_corners_of(mesh, Face(e.index), a, facts);
    if (e.dimension == 0) add_corners_of(mesh, Vertex(e.index), a, facts);
  }
}

}  // namespace

void add_value_facts(const Document& document, EntityRef e, Facts& facts) {
  const Mesh& mesh = document.mesh();
  if (e.dimension == 0) add_values(mesh, Vertex(e.index), facts);
  if (e.dimension == 1) add_values(mesh, Edge(e.index), facts);
  if (e.dimension == 2) add_values(mesh, Face(e.index), facts);
  if (e.dimension == 3) add_values(mesh, Region(e.index), facts);
  add_corners(document, e, facts);
}

}  // namespace aomd::scene
