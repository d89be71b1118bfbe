#pragma once
// Classification of volume meshes: their skin is a surface, the rest follows from the regions.

#include "core/model/classify.h"

namespace aomd {

/// classify() for a mesh with regions. Regions that the file leaves unclassified become one model
/// region for each part connected through faces. Faces with one region, with regions on two model
/// regions, or with none are the skin: they, their edges and vertices are classified as a surface
/// of their own. What lies inside takes the class of its region. Creates faces and edges when there
/// are none. O(entities).
ClassifyResult classify_volume(Mesh& mesh, const ClassifyOptions& options);

}  // namespace aomd
