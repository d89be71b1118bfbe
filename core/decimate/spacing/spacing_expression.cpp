#include "core/decimate/spacing/spacing_expression.h"

#include <muParser.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "core/base/text.h"
#include "core/decimate/spacing/curvature.h"
#include "core/io/source.h"

namespace aomd {
namespace {

std::string reason(const mu::ParserError& error) {
  const std::string token = shown(error.GetToken());
  switch (error.GetCode()) {
    case mu::ecEMPTY_EXPRESSION:
      return "there is nothing";
    case mu::ecUNASSIGNABLE_TOKEN:
      return "nothing is called " + token +
             " here; there are x, y, z, h, k, diag, numbers and functions";
    case mu::ecUNEXPECTED_EOF:
      return "something is missing at the end";
    case mu::ecMISSING_PARENS:
      return "a parenthesis is not closed";
    case mu::ecUNEXPECTED_PARENS:
    case mu::ecUNEXPECTED_OPERATOR:
    case mu::ecUNEXPECTED_VAL:
    case mu::ecUNEXPECTED_VAR:
    case mu::ecUNEXPECTED_FUN:
      return token + " cannot stand here";
    case mu::ecUNEXPECTED_ARG_SEP:
    case mu::ecUNEXPECTED_ARG:
      return "a comma can only stand between what a function is given";
    case mu::ecTOO_MANY_PARAMS:
      return token + " takes fewer values";
    case mu::ecTOO_FEW_PARAMS:
      return token + " takes more values";
    default:
      return error.GetMsg();
  }
}

std::string complaint(const std::string& text, std::size_t character, const std::string& what) {
  return "spacing " + shown(text) + ", character " + std::to_string(character) + ": " + what;
}

// muparser counts from 0, says -1 where it does not know, and passes the end by one.
std::size_t character_of(const mu::ParserError& error, const std::string& text) {
  const auto at = static_cast<std::size_t>(std::max(error.GetPos(), 0));
  return std::min(at, text.size()) + 1;
}

// Assigning to a variable is part of muparser's language. Here it would only be a comparison
// mistyped.
std::size_t find_assignment(const std::string& text) {
  for (std::size_t i = text.find('='); i != std::string::npos; i = text.find('=', i + 1)) {
    if (i + 1 < text.size() && text[i + 1] == '=')
      ++i;
    else if (i == 0 || std::string_view("<>!").find(text[i - 1]) == std::string_view::npos)
      return i;
  }
  return std::string::npos;
}

}  // namespace

struct SpacingExpression::Parser {
  double x = 0, y = 0, z = 0, h = 0, k = 0, diag = 0;
  mu::Parser formula;

  explicit Parser(const std::string& text) {
    constexpr std::array names{"x", "y", "z", "h", "k", "diag"};
    const std::array values{&x, &y, &z, &h, &k, &diag};
    for (std::size_t i = 0; i < names.size(); ++i) formula.DefineVar(names[i], values[i]);
    formula.SetExpr(text);
    (void)formula.Eval();
  }
};

SpacingExpression::SpacingExpression(std::string text) : text_(std::move(text)) {
  if (const std::size_t at = find_assignment(text_); at != std::string::npos)
    throw std::invalid_argument(
        complaint(text_, at + 1, "nothing can be assigned; equality is =="));
  try {
    parser_ = std::make_unique<Parser>(text_);
  } catch (const mu::ParserError& error) {
    throw std::invalid_argument(complaint(text_, character_of(error, text_), reason(error)));
  }
  if (parser_->formula.GetNumResults() != 1)
    throw std::invalid_argument(complaint(
        text_, text_.find(',') + 1, "a comma can only stand between what a function is given"));
}

SpacingExpression::~SpacingExpression() = default;
SpacingExpression::SpacingExpression(SpacingExpression&&) noexcept = default;
SpacingExpression& SpacingExpression::operator=(SpacingExpression&&) noexcept = default;

Column<Vertex, double> SpacingExpression::evaluate(const Mesh& mesh,
                                                   const VertexNeighbours& neighbours) {
  Column<Vertex, double> spacing(mesh.capacity(0), 0.0);
  const Column<Vertex, double> lengths = average_edge_lengths(mesh, neighbours);
  const bool needs_curvature = parser_->formula.GetUsedVar().contains("k");
  const Column<Vertex, double> curvatures =
      needs_curvature ? vertex_curvatures(mesh) : Column<Vertex, double>(mesh.capacity(0), 0.0);
  parser_->diag = box_of_used(mesh, neighbours).diagonal();
  for (const Vertex v : mesh.vertices()) {
    if (neighbours.of(v).empty()) continue;
    const glm::dvec3& p = mesh.position(v);
    parser_->x = p.x, parser_->y = p.y, parser_->z = p.z;
    parser_->h = lengths[v], parser_->k = curvatures[v];
    spacing[v] = parser_->formula.Eval();
    if (!(spacing[v] > 0) || !std::isfinite(spacing[v])) fail_at(mesh, v, spacing[v]);
  }
  return spacing;
}

void SpacingExpression::fail_at(const Mesh& mesh, Vertex v, double value) const {
  const glm::dvec3& p = mesh.position(v);
  throw std::invalid_argument("spacing " + shown(text_) + " is " + number_text(value) +
                              " at vertex " + std::to_string(v.index) + " (" + number_text(p.x) +
                              ", " + number_text(p.y) + ", " + number_text(p.z) +
                              "); it must be positive and finite");
}

}  // namespace aomd
