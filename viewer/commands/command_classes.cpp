// The classification edited by hand.

#include <string>

#include "core/base/text.h"
#include "core/io/io.h"
#include "core/mesh/names.h"
#include "core/mesh/part.h"
#include "core/model/class_edits.h"
#include "viewer/base/text.h"
#include "viewer/commands/command_groups.h"

namespace aomd::scene {
namespace {

void need_triangles(const Session& session) {
  need_mesh(session);
  if (session.document().content().skin)
    throw CommandError(
        "the classification of volumes and quads cannot be edited, only that of triangles");
}

/// The entities that are named, or else those that are selected.
std::vector<EntityRef> concerned(Session& session, Arguments& arguments) {
  Arguments ahead = arguments;
  const std::string word = ahead.done() ? "selection" : ahead.word("selection or entities");
  if (word != "selection") return listed_entities(session, arguments);
  ahead.end();
  const auto selected = session.sheet().selection.entities();
  if (selected.empty()) arguments.fail("nothing is selected");
  return {selected.begin(), selected.end()};
}

std::string model_counts(const Mesh& mesh) {
  std::string text;
  for (const int dim : {2, 1, 0}) {
    std::int64_t count = 0;
    for (const ModelRef ref : mesh.class_lists()->models(dim)) count += ref.dimension() == dim;
    text += (text.empty() ? "" : ", ") + grouped(count) + " model " +
            (count == 1 ? entity_name(dim) : entity_plural(dim));
  }
  return text;
}

/// Carries it out, or says which rule it would break and shows by what.
void edit(Session& session, const std::string& name, const ClassEdit& make) {
  session.play(false);
  const ClassVerdict verdict = session.document().edit_classes(name, make);
  session.sheet().point_out({});
  if (verdict.accepted()) {
    session.status = name + ": now " + model_counts(session.document().mesh());
    return;
  }
  std::vector<EntityRef> broken;
  for (const EntityRef e : {verdict.entity, verdict.other})
    if (e.valid()) broken.push_back(e);
  session.sheet().point_out(std::move(broken));
  throw CommandError(name + ": " + class_words(verdict));
}

void promote(Session& session, Arguments& arguments) {
  need_triangles(session);
  const auto entities = concerned(session, arguments);
  edit(session, "promote",
       [&](const Mesh& mesh, double corner) { return aomd::promote(mesh, entities, corner); });
}

void demote(Session& session, Arguments& arguments) {
  need_triangles(session);
  const auto entities = concerned(session, arguments);
  edit(session, "demote",
       [&](const Mesh& mesh, double corner) { return aomd::demote(mesh, entities, corner); });
}

/// "face:3", or "face:new" for one that nothing lies on yet.
ModelRef aim(const Session& session, Arguments& arguments) {
  Arguments ahead = arguments;
  const std::string word = ahead.word("a model entity like face:3 or face:new");
  for (int dim = 0; dim < 3; ++dim)
    if (word == std::string(entity_name(dim)) + ":new") {
      arguments = ahead;
      return {dim, free_tag(session.document().mesh(), dim)};
    }
  return arguments.model_entity();
}

void assign(Session& session, Arguments& arguments) {
  need_triangles(session);
  const ModelRef model = aim(session, arguments);
  Arguments ahead = arguments;
  const bool border = !ahead.done() && ahead.word("border") == "border";
  if (border) arguments = ahead;
  const auto entities = concerned(session, arguments);
  edit(session, "assign", [&](const Mesh& mesh, double corner) {
    return aomd::assign(mesh, entities, model, border, corner);
  });
}

void split_face(Session& session, Arguments& arguments) {
  need_triangles(session);
  const ModelRef face = arguments.model_entity();
  arguments.end();
  if (face.dimension() != 2) arguments.fail("only a model face can be split");
  edit(session, "split-face",
       [&](const Mesh& mesh, double) { return aomd::split_face(mesh, face); });
}

void feature_preview(Session& session, Arguments& arguments) {
  const std::string text = arguments.word("an angle in degrees, or off");
  arguments.end();
  need_triangles(session);
  session.sheet().point_out({});
  if (text == "off") return session.document().end_trial();
  const double angle =
      Arguments("feature-preview", "DEG|off", text).number("an angle in degrees", 0, 180);
  if (session.document().content().classified_by_file())
    throw CommandError("feature-preview: the file's classification wins, an angle has no say");
  session.play(false);
  const FeaturePreview& preview = session.document().try_feature_angle(angle).preview;
  session.sheet().point_out({preview.edges.begin(), preview.edges.end()});
  session.status = short_number(angle) + " deg would make " +
                   counted(preview.model_edges, "model edge") + " of " +
                   counted(preview.edges.size(), "edge") + ", " +
                   counted(preview.model_vertices, "model vertex");
}

void export_selection(Session& session, Arguments& arguments) {
  const std::string file = arguments.rest("a file");
  need_mesh(session);
  const MeshData part = part_of(session.document().mesh(), session.sheet().selection.entities());
  if (part.positions.empty()) arguments.fail("no faces or regions are selected");
  const std::vector<std::string> notes = io::write(expanded(file), part);
  const std::size_t regions = part.regions.size();
  session.status =
      "Saved " +
      counted(regions > 0 ? regions : part.faces.size(), regions > 0 ? "region" : "face") + " in " +
      printable(file);
  for (const std::string& note : notes) session.status += ", " + note;
}

}  // namespace

std::vector<Command> class_commands() {
  return {
      {"promote",
       "[selection] | KIND ID [ID...]",
       "Edges become model edges, vertices model vertices: collapses respect them. Ends, branches "
       "and sharp "
       "turns of the new model edges become model vertices.",
       CommandGroup::Selection,
       promote,
       {}},
      {"demote",
       "[selection] | KIND ID [ID...]",
       "The opposite: edges go onto the model face beside them, vertices onto the model edge or "
       "face around "
       "them.",
       CommandGroup::Selection,
       demote,
       {}},
      {"assign",
       "KIND:TAG|KIND:new [border] [selection | KIND ID [ID...]]",
       "Puts entities onto a model entity; new takes the next free tag, border makes model edges "
       "of the "
       "edges around faces. Refused where a rule of classification would be broken.",
       CommandGroup::Selection,
       assign,
       {}},
      {"split-face",
       "face:TAG",
       "Gives the parts of a model face that model edges separate tags of their own; the largest "
       "keeps its "
       "tag.",
       CommandGroup::Selection,
       split_face,
       {}},
      {"feature-preview",
       "DEG|off",
       "Shows which edges would be model edges past this feature angle, and changes nothing.",
       CommandGroup::Selection,
       feature_preview,
       {}},
      {"export-selection",
       "FILE",
       "Writes the selected faces and regions with what bounds them and their classification as a "
       "mesh.",
       CommandGroup::Selection,
       export_selection,
       {}},
  };
}

}  // namespace aomd::scene
