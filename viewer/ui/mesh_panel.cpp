#include <algorithm>
#include <cctype>
#include <optional>
#include <string>

#include "viewer/base/text.h"
#include "viewer/ui/panels.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

using scene::grouped;
using scene::signed_grouped;

/// One count: what it is, its value, how it changed.
struct Row {
  const char* label;
  std::int64_t now;
  std::int64_t before;
  const char* help;
};

void change_cell(const Frame& frame, const Row& row) {
  if (row.now == row.before || !ImGui::TableNextColumn()) return;
  ImGui::PushStyleColor(ImGuiCol_Text, frame.colors.text_muted);
  text_right(signed_grouped(row.now - row.before));
  ImGui::PopStyleColor();
  tooltip("Change since loading: it was " + grouped(row.before));
}

void count_row(const Frame& frame, const Row& row) {
  value_row(frame, row.label, grouped(row.now), row.help);
  if (row.now != row.before) tooltip(signed_grouped(row.now - row.before) + " since loading");
  if (ImGui::TableGetColumnCount() == 3) change_cell(frame, row);
}

const char* classified_by(const scene::Document& document) {
  if (document.content().classified_by_file()) return "Classified by its source";
  return document.lies_on_model() ? "Classified by its model" : "Classified by feature angle";
}

void model_lines(const Frame& frame) {
  const scene::GivenModel* model = frame.document().model();
  if (model == nullptr) return;
  const std::string help =
      "The CAD model " + model->file.string() + ": " + scene::counts_text(model->counts);
  const float width = ImGui::GetContentRegionAvail().x;
  text(fitted("Model " + model->file.filename().string(), width));
  tooltip(help);
  auto counts = model->counts;
  counts[3] = 0;  // what a surface lies on needs the room
  muted(frame, fitted(scene::counts_text(counts), width));
  tooltip(help);
}

void file_line(Frame& frame) {
  const scene::LoadedMesh& content = frame.document().content();
  heading(frame, fitted(content.name, ImGui::GetContentRegionAvail().x - 1.7f * em()).c_str());
  tooltip(content.file.empty() ? "A built-in sample" : content.file.string());
  copy_button(frame, "counts");
  muted(frame, classified_by(frame.document()));
  tooltip(
      "Which model vertex, edge or face every vertex, edge and face of the mesh lies on. What a "
      "file says "
      "wins; "
      "the rest follows from feature angles.");
}

void memory_rows(const Frame& frame) {
  const Mesh& mesh = frame.document().mesh();
  value_row(frame, "Mesh", scene::bytes_text(mesh.entity_bytes()), entity_memory_help);
  value_row(frame, "Adjacency", scene::bytes_text(mesh.adjacency_bytes()),
            "Stored relations T(I,J): the panel Adjacencies shows each");
  value_row(frame, "History", scene::bytes_text(frame.document().journal().bytes()),
            "The journal that undo, stepping and replay read");
}

std::string shape_words(Shape shape) {
  switch (shape) {
    case Shape::Tetrahedron:
      return "Tetrahedra";
    case Shape::Hexahedron:
      return "Hexahedra";
    default: {
      std::string name = std::string(shape_template(shape).name) + "s";
      name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
      return name;
    }
  }
}

/// The only shape of the highest level, if there is but one.
std::optional<Shape> only_shape(const scene::MeshFacts& facts) {
  const std::int64_t all = facts.regions > 0 ? facts.regions : facts.faces;
  for (std::size_t s = 0; s < shape_count(); ++s)
    if (facts.shapes[s] == all) return static_cast<Shape>(s);
  return {};
}

/// The shapes of the highest level, where there is more than one.
void shape_rows(const Frame& frame) {
  const scene::MeshFacts& facts = frame.session.sheet().facts();
  if (only_shape(facts)) return;
  for (std::size_t s = 0; s < shape_count(); ++s)
    if (facts.shapes[s] > 0)
      value_row(frame, ("   " + shape_words(static_cast<Shape>(s))).c_str(),
                grouped(facts.shapes[s]), "");
}

/// A level that holds what the file lists, or all sides of the level above.
void level_row(const Frame& frame, int dim, const char* complete, const char* listed,
               std::int64_t count) {
  const bool whole = frame.document().mesh().complete(dim);
  value_row(frame, whole ? complete : listed, grouped(count),
            whole ? "All that the regions have, each counted once"
                  : "Only those that the file lists, or that lie on model faces: the level is not "
                    "complete. Storing a relation that needs the others creates them (panel "
                    "Adjacencies).");
}

void volume_rows(const Frame& frame) {
  const scene::MeshFacts& facts = frame.session.sheet().facts();
  const scene::MeshFacts& then = frame.session.sheet().loaded_facts();
  const auto only = only_shape(facts);
  const std::string name = only ? shape_words(*only) : "Regions";
  count_row(frame, {name.c_str(), facts.regions, then.regions, "What fills the volume"});
  shape_rows(frame);
  count_row(frame, {"Outer faces", facts.outer_faces, then.outer_faces,
                    "Sides with one region, and faces with none: what is drawn"});
  level_row(frame, 2, "Faces", "Faces, listed", facts.faces);
  level_row(frame, 1, "Edges", "Edges, listed", facts.edges);
  count_row(frame, {"Vertices", facts.vertices, then.vertices,
                    "All vertices, also those that nothing uses"});
  count_row(frame, {"Unused vertices", facts.unused, then.unused,
                    "Vertices that nothing uses; they are kept"});
}

void surface_rows(const Frame& frame) {
  const scene::MeshFacts& now = frame.session.sheet().facts();
  const scene::MeshFacts& then = frame.session.sheet().loaded_facts();
  const auto only = only_shape(now);
  count_row(frame, {only == Shape::Quad ? "Quads" : "Faces", now.faces, then.faces,
                    "Triangles, and quads where a file has them"});
  shape_rows(frame);
  const Row rows[] = {
      {"Edges", now.edges, then.edges, "Edges of faces, each counted once"},
      {"Vertices", now.vertices, then.vertices, "All vertices, also those that no face uses"},
      {"Unused vertices", now.unused, then.unused,
       "Vertices that no face uses; they are kept and saved"},
      {"Boundary edges", now.boundary, then.boundary, "Edges with one face"},
      {"Non-manifold", now.nonmanifold, then.nonmanifold, "Edges with more than two faces"},
      {"Euler number", now.euler(), then.euler(),
       "Used vertices \u2212 edges + faces: 2 for a sphere, 0 for a torus. It stays while the "
       "topology "
       "does."},
  };
  for (const Row& row : rows) count_row(frame, row);
}

}  // namespace

void mesh_panel(Frame& frame) {
  if (!frame.has_mesh()) {
    heading(frame, "No mesh yet");
    muted(frame, "Open a file, or drop one here.");
    gap();
    command_button(frame, "Open\u2026", "dialog open", -1);
    command_button(frame, "Lessons", "dialog lessons", -1);
    return;
  }
  file_line(frame);
  model_lines(frame);
  gap(0.1f);
  // Where it is narrow, or nothing has changed, the names need the room more than the changes do.
  const bool volume = frame.document().content().volume();
  const scene::MeshFacts& facts = frame.session.sheet().facts();
  const scene::MeshFacts& then = frame.session.sheet().loaded_facts();
  const bool changed =
      volume ? facts.regions != then.regions || facts.vertices != then.vertices : !(facts == then);
  const int columns = changed && ImGui::GetContentRegionAvail().x > 15 * em() ? 3 : 2;
  if (!begin_values("counts", columns)) return;
  volume ? volume_rows(frame) : surface_rows(frame);
  memory_rows(frame);
  end_values();
}

}  // namespace aomd::ui
