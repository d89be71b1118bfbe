#include "core/decimate/spacing/spacing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <system_error>
#include <vector>

#include <glm/geometric.hpp>

#include "core/base/text.h"
#include "core/decimate/spacing/curvature.h"
#include "core/decimate/spacing/spacing_expression.h"
#include "core/decimate/spacing/vertex_neighbours.h"
#include "core/io/source.h"
#include "core/io/text_cursor.h"
#include "core/io/text_file.h"

namespace aomd {
namespace {

void check_positive(double value, const char* what) {
  if (!(value > 0) || !std::isfinite(value))
    throw std::invalid_argument(std::string(what) + " must be positive and finite, not " +
                                number_text(value));
}

/// Evaluates one kind of source after the other.
struct Evaluator {
  const Mesh& mesh;
  const VertexNeighbours& neighbours;

  Column<Vertex, double> operator()(const SpacingByFactor& source) const;
  Column<Vertex, double> operator()(const SpacingFile& source) const;
  Column<Vertex, double> operator()(const SpacingFormula& source) const {
    return SpacingExpression(source.text).evaluate(mesh, neighbours);
  }
  Column<Vertex, double> operator()(const SpacingByCurvature& source) const;
  Column<Vertex, double> operator()(const SpacingBySurface& source) const;
};

Column<Vertex, double> Evaluator::operator()(const SpacingByFactor& source) const {
  check_positive(source.factor, "the factor of a spacing");
  Column<Vertex, double> spacing = average_edge_lengths(mesh, neighbours);
  for (const Vertex v : mesh.vertices()) spacing[v] *= source.factor;
  return spacing;
}

double read_value(io::detail::TextCursor& cursor) {
  const double value = cursor.real("a spacing");
  if (!(value > 0)) cursor.fail("a spacing must be positive, not " + number_text(value));
  return value;
}

Column<Vertex, double> Evaluator::operator()(const SpacingFile& source) const {
  const io::detail::TextFile file(source.path);
  io::detail::TextCursor cursor(file.source(), file.source().bytes, 0, '#');
  Column<Vertex, double> spacing(mesh.capacity(0), 0.0);
  std::uint32_t read = 0;
  for (const Vertex v : mesh.vertices()) {
    if (cursor.skip_to_content())
      cursor.fail("the file ends after " + counted(read, "spacing") + "; the mesh has " +
                  counted(mesh.count(0), "vertex"));
    spacing[v] = read_value(cursor);
    ++read;
  }
  if (!cursor.skip_to_content())
    cursor.fail("more spacings than the mesh has vertices (" + std::to_string(read) + ")");
  return spacing;
}

Column<Vertex, double> Evaluator::operator()(const SpacingByCurvature& source) const {
  if (mesh.count(3) > 0)
    throw std::invalid_argument(
        "by curvature is for surfaces: it says nothing about what is inside a volume");
  check_positive(source.chord_error, "the chord error of a spacing");
  check_positive(source.largest, "the largest spacing");
  const double diagonal = box_of_used(mesh, neighbours).diagonal();
  const Column<Vertex, double> curvatures = vertex_curvatures(mesh);
  Column<Vertex, double> spacing = average_edge_lengths(mesh, neighbours);
  for (const Vertex v : mesh.vertices()) {
    if (neighbours.of(v).empty()) continue;
    const double by_error = std::sqrt(8 * source.chord_error * diagonal / curvatures[v]);
    spacing[v] = std::max(spacing[v], std::min(by_error, source.largest * diagonal));
  }
  return spacing;
}

// The sides of the faces on model faces, each once, from its smaller vertex.
std::vector<std::array<std::uint32_t, 2>> edges_on_model_faces(const Mesh& mesh) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  VertexBuffer buffer;
  for (const Face f : mesh.faces()) {
    if (mesh.classification(f).dimension() == 3) continue;
    const auto v = mesh.vertices_of(f, buffer);
    for (std::size_t k = 0; k < v.size(); ++k) {
      const auto [a, b] = std::minmax(v[k], v[(k + 1) % v.size()]);
      edges.push_back({a, b});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

Column<Vertex, double> Evaluator::operator()(const SpacingBySurface& source) const {
  if (mesh.count(3) == 0)
    throw std::invalid_argument("surface is for volumes: a surface has nothing inside");
  check_positive(source.factor, "the factor of a spacing");
  Column<Vertex, double> sum(mesh.capacity(0), 0.0);
  Column<Vertex, std::uint32_t> count(mesh.capacity(0), 0);
  for (const auto& [a, b] : edges_on_model_faces(mesh)) {
    const double length = glm::length(mesh.position(Vertex(a)) - mesh.position(Vertex(b)));
    for (const std::uint32_t v : {a, b}) {
      sum[Vertex(v)] += length;
      ++count[Vertex(v)];
    }
  }
  Column<Vertex, double> spacing(mesh.capacity(0), 0.0);
  for (const Vertex v : mesh.vertices()) {
    if (neighbours.of(v).empty()) continue;
    spacing[v] =
        count[v] > 0 ? source.factor * sum[v] / count[v] : std::numeric_limits<double>::infinity();
  }
  return spacing;
}

bool is_file(const std::string& text) {
  std::error_code none;
  const auto status = std::filesystem::status(text, none);
  return std::filesystem::exists(status) && !std::filesystem::is_directory(status);
}

}  // namespace

SpacingSource parse_spacing(const std::string& text, double factor) {
  if (is_file(text)) return {SpacingFile{text}, {}};
  if (text == "curvature") return {SpacingByCurvature{}, default_spacing_growth};
  if (text == "surface") return {SpacingBySurface{factor}, default_spacing_growth};
  try {
    (void)SpacingExpression(text);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string(error.what()) + " (and there is no such file)");
  }
  return {SpacingFormula{text}, {}};
}

Column<Vertex, double> evaluate_spacing(const Mesh& mesh, const SpacingSource& source) {
  const VertexNeighbours neighbours(mesh);
  Column<Vertex, double> spacing = std::visit(Evaluator{mesh, neighbours}, source.from);
  if (source.growth) limit_growth(mesh, neighbours, *source.growth, spacing);
  return spacing;
}

}  // namespace aomd
