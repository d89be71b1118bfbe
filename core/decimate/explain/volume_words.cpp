#include "core/decimate/explain/volume_words.h"

#include <cmath>

#include "core/base/text.h"
#include "core/decimate/explain/verdict_words.h"
#include "core/operators/region_checks.h"

namespace aomd::words {
namespace {

ModelRef class_of_edge(const Mesh& mesh, const Contraction& c) {
  Ball ball;
  Star star;
  gather(mesh, c.deleted, ball);
  gather_model_faces(mesh, c.deleted, star);
  return class_between(mesh, c.deleted, c.kept, star, ball);
}

const char* what_would_happen(int dimension) {
  return dimension == 2 ? "the face would be dented" : "a vertex goes only along what it lies on";
}

std::string change_words(ModelRef region, double percent, double limit) {
  const Held held = held_length(std::abs(percent), limit);
  return sentence(name(region) + " would be " + held.value + " % " +
                  (percent < 0 ? "smaller" : "larger") + "; " + held.limit + " % is the limit");
}

// One number for both: an angle that is large enough was refused for the shape as a whole.
std::string shape_words(EntityRef who, double deg, double least_deg) {
  if (deg >= least_deg)
    return sentence(name_of(who) + " would be too flat, with a smallest dihedral angle of " +
                    degrees(deg) + " degrees");
  const Held held = held_degrees(deg, least_deg);
  return sentence("tetrahedron " + std::to_string(who.index) + " would have an angle of " +
                  held.value + " degrees; the limit is " + held.limit);
}

std::string removal_model_words(const Mesh& mesh, Edge edge, EntityRef who) {
  if (mesh.classification(edge).dimension() == 1)
    return sentence("the edge lies on " + name(mesh.classification(edge)));
  return sentence("what is around it lies on more than one model " +
                  std::string(who.dimension == 3 ? "region" : "face") + ", as " + name_of(who) +
                  " shows");
}

std::string removal_topology_words(const Mesh& mesh, Edge edge, EntityRef who) {
  const auto [a, b] = mesh.edge_vertices(edge);
  if (who.dimension == 2)
    return sentence(name_of(who) + " at the edge is no side of the tetrahedra around it");
  if (who == EntityRef(a) || who == EntityRef(b))
    return "Around it there are other shapes than tetrahedra, more than nine on a side, or not all "
           "that would close a ring.";
  return sentence("an edge or face that it would make at " + name_of(who) + " is there already");
}

}  // namespace

std::string volume_model_words(const Mesh& mesh, const Contraction& c) {
  const ModelRef gone = mesh.classification(c.deleted);
  if (gone.dimension() == 0)
    return sentence(name_of(c.deleted) + " is a model vertex, and these stay");
  const ModelRef between = class_of_edge(mesh, c);
  if (gone != between)
    return sentence(name_of(c.deleted) + " lies on " + name(gone) + " and the edge " +
                    (between.dimension() == 3 ? "inside " : "on ") + name(between) + ": " +
                    what_would_happen(gone.dimension()));
  return sentence(name_of(c.kept) + " lies on " + name(mesh.classification(c.kept)) +
                  ", which it would have to leave");
}

std::string volume_topology_words(const Mesh& mesh, const CollapseOutlook& o) {
  const EntityRef who = o.verdict.entity;
  const Contraction& c = o.contraction;
  for (const Vertex v : {c.deleted, c.kept})
    if (in_crowd(mesh, v))
      return sentence(name_of(v) + " has " + counted(mesh.row<3>(v).size(), "region") +
                      ", and waits until it has no more than " + std::to_string(largest_ball));
  const std::string ends = name_of(c.deleted) + " and " + std::to_string(c.kept.index);
  if (who.dimension == 2) return sentence("a model face would fall onto " + name_of(who));
  if (who.dimension == 3)
    return sentence("a side or an edge that only " + name_of(who) +
                    " joins to the other end would fall onto another: the mesh would be pinched");
  if (who.dimension == 0 && who.index != c.deleted.index && who.index != c.kept.index)
    return sentence(ends + " are both joined to " + name_of(who) + ", " +
                    (mesh.classification(c.deleted).dimension() == 3
                         ? "but no tetrahedron lies between: a hollow would close"
                         : "and no face or tetrahedron between fills that: the model would be "
                           "pinched there"));
  return "Parts of the model that only this edge connects would meet in one vertex.";
}

std::string region_words(const Mesh& mesh, const Verdict& verdict, const Limits& limits) {
  const EntityRef who = verdict.entity;
  switch (verdict.reason) {
    case Reason::Inverted:
      return sentence(name_of(who) + " would turn inside out or lose its volume");
    case Reason::Overshoot:
      return sentence("the edge to " + name_of(who) + " would be " +
                      formatted("%.3g", verdict.number()) + " long, too much for the size there");
    case Reason::Volume:
      return change_words(mesh.classification(who), verdict.number(), limits.volume_pct);
    case Reason::Kept:
      if (who.dimension != 3) return {};
      return sentence(name_of(who) + " is a " + std::string(shape_template(mesh.shape(who)).name) +
                      ": only tetrahedra are decimated");
    case Reason::Shape:
      if (who.dimension != 3) return {};
      return shape_words(who, verdict.number(), limits.min_dihedral_deg);
    default:
      return {};
  }
}

std::string removal_words(const Mesh& mesh, Edge edge, const SwapOutlook& o) {
  if (std::string text = region_words(mesh, o.verdict, o.limits); !text.empty()) return text;
  const EntityRef who = o.verdict.entity;
  switch (o.verdict.reason) {
    case Reason::None:
      if (o.pair.f.valid())
        return sentence("it would join " + name_of(o.pair.c) + " and " + name_of(o.pair.d));
      return "The tetrahedra around it would make way for better ones that do without it.";
    case Reason::Classification:
      return removal_model_words(mesh, edge, who);
    case Reason::Topology:
      return removal_topology_words(mesh, edge, who);
    case Reason::Quality:
      return "It would not pay: the tetrahedra would have no better shapes than now, the worst one "
             "a "
             "smallest dihedral angle of " +
             degrees(o.verdict.number()) + " degrees.";
    case Reason::Distance:
      if (who.dimension != 0) return general_words(o.verdict, o.limits);
      return sentence("the other diagonal of its two faces would run " +
                      number_text(o.verdict.number(), 3) +
                      " beside it, too far for the model face");
    default:
      return general_words(o.verdict, o.limits);
  }
}

}  // namespace aomd::words
