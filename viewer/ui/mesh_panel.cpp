#include <algorithm>

#include "viewer/scene/text.h"
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
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  muted(frame, row.label);
  tooltip(row.help);
  ImGui::TableNextColumn();
  text_right(grouped(row.now));
  if (row.now != row.before) tooltip(signed_grouped(row.now - row.before) + " since loading");
  if (ImGui::TableGetColumnCount() == 3) change_cell(frame, row);
}

void memory_row(const Frame& frame, const char* label, std::size_t bytes, const char* help) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  muted(frame, label);
  tooltip(help);
  ImGui::TableNextColumn();
  text_right(scene::bytes_text(bytes));
}

void file_line(const Frame& frame) {
  const scene::LoadedMesh& content = frame.document().content();
  heading(frame, fitted(content.name, ImGui::GetContentRegionAvail().x).c_str());
  tooltip(content.file.empty() ? "A built-in sample" : content.file.string());
  muted(frame, content.classified_by_file() ? "Classified by its source" : "Classified by feature angle");
  tooltip(
      "Which model vertex, edge or face every vertex, edge and face of the mesh lies on. What a file says "
      "wins; "
      "the rest follows from feature angles.");
}

void memory_rows(const Frame& frame) {
  const Mesh& mesh = frame.document().mesh();
  memory_row(frame, "Mesh", mesh.entity_bytes(), "Entities, coordinates and classification");
  memory_row(frame, "Adjacency", mesh.adjacency_bytes(),
             "Stored relations T(I,J): what the algorithms have asked for");
  memory_row(frame, "History", frame.document().journal().bytes(),
             "The journal that undo, stepping and replay read");
}

void count_rows(const Frame& frame) {
  const scene::MeshFacts& now = frame.session.facts();
  const scene::MeshFacts& then = frame.session.loaded_facts();
  const Row rows[] = {
      {"Faces", now.faces, then.faces, "Triangles"},
      {"Edges", now.edges, then.edges, "Edges of triangles, each counted once"},
      {"Vertices", now.vertices, then.vertices, "All vertices, also those that no face uses"},
      {"Unused vertices", now.unused, then.unused, "Vertices that no face uses; they are kept and saved"},
      {"Boundary edges", now.boundary, then.boundary, "Edges with one face"},
      {"Non-manifold", now.nonmanifold, then.nonmanifold, "Edges with more than two faces"},
      {"Euler number", now.euler(), then.euler(),
       "Used vertices \u2212 edges + faces: 2 for a sphere, 0 for a torus. It stays while the topology "
       "does."},
  };
  for (const Row& row : rows) count_row(frame, row);
}

}  // namespace

void mesh_panel(Frame& frame) {
  if (!frame.has_mesh()) {
    heading(frame, "No mesh yet");
    muted(frame, "Open a file, or drop one here.");
    return;
  }
  file_line(frame);
  gap(0.1f);
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(0.25f * em(), 0.12f * em()));
  // Where it is narrow, or nothing has changed, the names need the room more than the changes do.
  const bool changed = !(frame.session.facts() == frame.session.loaded_facts());
  const int columns = changed && ImGui::GetContentRegionAvail().x > 15 * em() ? 3 : 2;
  if (ImGui::BeginTable("counts", columns, ImGuiTableFlags_SizingFixedFit)) {
    ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("now", ImGuiTableColumnFlags_WidthFixed, 3.9f * em());
    if (columns == 3) ImGui::TableSetupColumn("change", ImGuiTableColumnFlags_WidthFixed, 4.0f * em());
    count_rows(frame);
    memory_rows(frame);
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
}

}  // namespace aomd::ui
