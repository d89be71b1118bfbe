#include "core/model/facets.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace aomd {
namespace {

constexpr double corner_turn = FacetJudge::corner_deg * M_PI / 180;
constexpr double similar = 0.4;        // the part of an edge's turn that goes on beyond it
constexpr double end_of_round = 0.75;  // of the turn beyond, where a round runs into a plane
constexpr double uneven = 1.25;        // of the turn beyond, within a round
constexpr double widest = 3;           // between the facets on both sides
constexpr double behind = 1.5;         // widths, behind the first turn and before the second
constexpr double plane = 2.5;          // widths without a turn
constexpr double fine = 1.2;           // widths: the most that a face of a fine plane is long
constexpr double slight = 1.0 / 8;     // of the edge's turn: no turn
constexpr int most_faces = 24;

std::size_t side_of(Row<1> edges, Edge e) { return edges[0] == e ? 0 : edges[1] == e ? 1 : 2; }

}  // namespace

// Where a straight walk over the faces is, and how it got there.
struct FacetJudge::Walk {
  Face face;
  std::size_t side;              // of the face, through which it came
  glm::dvec3 at, direction, up;  // `up` is the side from which the surface of the edge turns away
  double height = 0;             // of the first face
  double length = 0, turned = 0, last_turn = 0;
};

// What a walk from an edge met.
struct FacetJudge::Beyond {
  double width = 0;      // to where the surface turns, at least the height of the face
  double turn = 0;       // by how much till half a width behind that
  double more = 0;       // the same a width further
  bool blocked = false;  // before that, by a border or by a corner

  [[nodiscard]] bool goes_on(double angle) const { return turn >= similar * angle; }

  // Whether a round comes from here and ends at an edge, beyond which lies the other.
  [[nodiscard]] bool ends_before(const Beyond& other, double angle) const {
    const bool round = goes_on(angle) && more >= turn + similar * angle;
    if (!round || width > widest * other.width) return false;
    const bool turns_back = other.width <= widest * width && angle <= uneven * turn;
    return other.blocked || turns_back || angle <= end_of_round * turn;
  }

  [[nodiscard]] bool is_like(const Beyond& other, double angle) const {
    return goes_on(angle) && other.goes_on(angle) &&
           std::max(width, other.width) <= widest * std::min(width, other.width);
  }
};

// From the line of a side, at right angles, to the corner opposite.
glm::dvec3 FacetJudge::into(Face f, std::size_t side, const glm::dvec3& unit) const {
  const auto t = mesh_.triangle(f);
  const glm::dvec3 across = mesh_.position(t[(side + 2) % 3]) - mesh_.position(t[side]);
  return across - glm::dot(across, unit) * unit;
}

// To the side through which the walk leaves its face; false in a face without area.
bool FacetJudge::leave(Walk& w, Edge& through) const {
  const auto t = mesh_.triangle(w.face);
  const std::size_t i = (w.side + 1) % 3, j = (w.side + 2) % 3;
  const glm::dvec3 a = mesh_.position(t[w.side]), b = mesh_.position(t[i]),
                   c = mesh_.position(t[j]);
  const glm::dvec3 n = glm::cross(b - a, c - a);
  const bool first = glm::dot(glm::cross(w.direction, c - w.at), n) > 0;
  const glm::dvec3 p = first ? b : c, q = first ? c : a;
  const double slope = glm::dot(glm::cross(q - p, w.direction), n);
  if (!(std::abs(slope) > 0)) return false;
  const double part = glm::dot(glm::cross(w.at - p, w.direction), n) / slope;
  const glm::dvec3 to = p + std::clamp(part, 0.0, 1.0) * (q - p);
  w.length += glm::length(to - w.at);
  w.at = to;
  w.side = first ? i : j;
  through = mesh_.row<1>(w.face)[w.side];
  return true;
}

// Steps into the next face; false where the way is blocked.
bool FacetJudge::go(Walk& w) const {
  Edge e;
  if (!leave(w, e)) return false;
  if (faces_.count(e) != 2) return false;
  const auto ends = mesh_.edge_vertices(e);
  const glm::dvec3 unit = glm::normalize(mesh_.position(ends[1]) - mesh_.position(ends[0]));
  const glm::dvec3 out = -glm::normalize(into(w.face, w.side, unit));
  w.face = faces_.across(e, w.face);
  w.side = side_of(mesh_.row<1>(w.face), e);
  const glm::dvec3 in = glm::normalize(into(w.face, w.side, unit));
  const double turn = std::atan2(-glm::dot(in, w.up), glm::dot(in, out));
  if (!(std::abs(turn) < corner_turn)) return false;
  const double across = glm::dot(w.direction, out);
  const double hand = glm::dot(w.up, glm::cross(unit, out)) < 0 ? -1 : 1;
  w.direction = glm::dot(w.direction, unit) * unit + across * in;
  w.up = hand * glm::cross(unit, in);
  w.last_turn = turn * across;
  w.turned += w.last_turn;
  return true;
}

FacetJudge::Beyond FacetJudge::look(Walk w, double angle) const {
  Beyond b;
  bool met = false;
  for (int i = 0; i < most_faces; ++i) {
    const bool on = go(w);
    if (!met) b.width = std::max(w.height, w.length);
    const bool near = w.length <= behind * b.width;
    b.blocked = !on && near;
    if (!on || (met && w.length > (behind + 1) * b.width)) break;
    met = met || std::abs(w.last_turn) > slight * angle;
    if (near) b.turn = w.turned;
    b.more = w.turned;
  }
  return b;
}

// Whether a walk over a round reaches a plane that is cut no coarser than the round.
bool FacetJudge::comes_to_fine_plane(Walk w, double angle, double width) const {
  bool met = false;
  double since = 0, longest = 0;
  for (int i = 0; i < most_faces; ++i) {
    const double before = w.length;
    const bool on = go(w), turns = on && std::abs(w.last_turn) > slight * angle;
    longest = std::max(longest, w.length - before);
    if (met && longest <= fine * width && w.length - since > plane * width) return true;
    if (!on) return false;
    if (turns) met = true, since = w.length, longest = 0;
  }
  return false;
}

std::optional<std::array<FacetJudge::Walk, 2>> FacetJudge::set_out(Edge e) const {
  const std::array faces = {faces_.first(e), faces_.second(e)};
  const auto ends = mesh_.edge_vertices(e);
  const glm::dvec3 p = mesh_.position(ends[0]), q = mesh_.position(ends[1]);
  const glm::dvec3 unit = glm::normalize(q - p);
  std::array<Walk, 2> walks;
  for (std::size_t k = 0; k < 2; ++k) {
    Walk& w = walks[k];
    w.face = faces[k];
    w.side = side_of(mesh_.row<1>(w.face), e);
    w.at = 0.5 * (p + q);
    w.direction = into(w.face, w.side, unit);
    w.height = glm::length(w.direction);
    if (!(w.height > 0)) return {};
    w.direction /= w.height;
    w.up = glm::cross(unit, w.direction);
  }
  for (std::size_t k = 0; k < 2; ++k)
    if (glm::dot(walks[k].up, walks[1 - k].direction) > 0) walks[k].up = -walks[k].up;
  return walks;
}

bool FacetJudge::is_step(Edge e) const {
  const auto walks = set_out(e);
  if (!walks) return false;
  const Walk &here = (*walks)[0], &there = (*walks)[1];
  const double angle = std::acos(std::clamp(-glm::dot(here.direction, there.direction), -1.0, 1.0));
  if (angle >= corner_turn) return false;
  const Beyond a = look(here, angle), b = look(there, angle);
  if (!a.is_like(b, angle) && !a.ends_before(b, angle) && !b.ends_before(a, angle)) return false;
  return !comes_to_fine_plane(here, angle, a.width) && !comes_to_fine_plane(there, angle, b.width);
}

}  // namespace aomd
