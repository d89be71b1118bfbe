#include "core/decimate/explain/volume_words.h"

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

}  // namespace

std::string volume_model_words(const Mesh& mesh, const Contraction& c) {
  const ModelRef gone = mesh.classification(c.deleted);
  if (gone.dimension() == 0)
    return sentence(name_of(c.deleted) + " is " + name(gone) + ", and these stay");
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

std::string region_words(const Mesh& mesh, const Verdict& verdict) {
  const EntityRef who = verdict.entity;
  switch (verdict.reason) {
    case Reason::Inverted:
      return sentence(name_of(who) + " would turn inside out or lose its volume");
    case Reason::Overshoot:
      return sentence("the edge to " + name_of(who) + " would be " +
                      formatted("%.3g", verdict.number()) + " long, too much for the size there");
    case Reason::Kept:
      if (who.dimension != 3) return {};
      return sentence(name_of(who) + " is a " + std::string(shape_template(mesh.shape(who)).name) +
                      ": only tetrahedra are decimated");
    case Reason::Shape:
      if (who.dimension != 3) return {};
      return sentence(name_of(who) + " would be too flat, with a smallest dihedral angle of " +
                      degrees(verdict.number()) + " degrees");
    default:
      return {};
  }
}

std::string removal_words(const Mesh& mesh, Edge edge, const Verdict& verdict) {
  switch (verdict.reason) {
    case Reason::None:
      return "It would go, and the worst tetrahedron around it would get a better shape.";
    case Reason::Classification:
      if (mesh.classification(edge).dimension() == 1)
        return sentence("the edge lies on " + name(mesh.classification(edge)));
      return sentence(name_of(verdict.entity) +
                      " lies on another model entity than the rest of what " + "is around it");
    case Reason::Topology:
      return "What is around it is no single ring of at most nine vertices, or an edge or face "
             "that "
             "it would make is there already.";
    case Reason::Quality:
      return "It would not pay: a tetrahedron with a smallest dihedral angle of " +
             degrees(verdict.number()) + " degrees would come of it, and none around it is poorer.";
    default:
      return {};
  }
}

}  // namespace aomd::words
