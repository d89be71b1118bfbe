#pragma once
// What is dirty in a surface, in the words of the program, with the command that mends it.

#include <string>
#include <vector>

#include "core/measure/hanging_vertices.h"
#include "core/repair/survey.h"
#include "tools/aomd/report.h"

namespace aomd::cli {

/// "--weld 0.01", or "--weld" where equal positions are enough.
[[nodiscard]] std::string weld_words(const SurfaceFinding& finding);

/// "repeated faces: 1 face on the vertices of others, the same way round (face 2): aomd repair
/// FILE OUT".
[[nodiscard]] std::string line_of(const SurfaceFinding& finding, const std::string& file);

/// One object a finding: that of items_json(), what it breaks and the command that mends it, or
/// null.
[[nodiscard]] Json surface_json(const std::vector<SurfaceFinding>& findings,
                                const std::string& file);

/// The pairs of faces that cut each other, where there are any.
[[nodiscard]] std::vector<SurfaceFinding> self_intersection_findings(const Mesh& mesh);

/// The vertices of the boundary, of a volume too, that lie on a side that they are no corner of.
[[nodiscard]] std::vector<SurfaceFinding> hanging_findings(const Mesh& mesh, int threads,
                                                           measure::Skin skin);

/// What keeps a surface from being decimated, and `mending` as what mends it; a note each. Before a
/// run that of which there is much: at least a twentieth of the surface, and the counts show it, so
/// that a clean surface costs nothing. After a run that `missed` its target the rest.
[[nodiscard]] std::vector<std::string> dirt_notes(const MeshData& mesh,
                                                  const measure::Counts& counts, bool missed,
                                                  const std::string& mending);

}  // namespace aomd::cli
