#pragma once
// What `aomd decimate` does to its input before anything else, and what it asks of it.

#include <string>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/model/classify.h"
#include "core/model/model.h"
#include "core/repair/repair.h"
#include "tools/aomd/decimate_options.h"

namespace aomd::cli {

/// Cuts quads into triangles; notes how many.
[[nodiscard]] std::vector<std::string> cut_quads(MeshData& mesh);

/// Cuts all regions into tetrahedra; notes what was cut, or that nothing was.
[[nodiscard]] std::vector<std::string> cut_regions(MeshData& mesh);

/// Mends what --repair mends; notes what was done and what is left.
[[nodiscard]] RepairReport mend(MeshData& mesh, const DecimateOptions& options,
                                std::vector<std::string>& notes);

/// Throws NothingToDo, io::LimitError or io::ReadError for a mesh that cannot be decimated.
void check_decimable(const Mesh& mesh, const std::string& file);

/// Classifies a mesh on a CAD model, or holds its classification against it. A step of the journal,
/// so that a replay needs no model. Throws io::ReadError.
void fit_to_model(Mesh& mesh, bool classified, const Model& model, const DecimateOptions& options);

/// Throws io::ReadError where the mesh lies on what the model does not have, such as one by its own
/// facets a model face without faces.
void check_snapping(const Mesh& mesh, const Model& model, const DecimateOptions& options);

/// A note on features that cost more of the faces `wanted` than they are worth: what is left for
/// the rest would come out worse than without them. Empty where they pay. A model vertex stays, and
/// two faces with it. Sharp edges get as long as all others; where more than a tenth of the
/// `original` faces is wanted they are worth it.
[[nodiscard]] std::string dear_features(const ClassifyResult& found, std::uint32_t original,
                                        std::uint32_t wanted);

}  // namespace aomd::cli
