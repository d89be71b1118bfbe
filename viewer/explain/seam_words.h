#pragma once
// Refusals that a seam of the file's arrays is behind.

#include "viewer/document/document.h"
#include "viewer/explain/entity_verdict.h"

namespace aomd::scene {

/// Where an edge or a vertex stays because of the classification, and lies on a seam, what would
/// tear: "The seam of uv would tear."
void add_seam_words(const Document& document, EntityVerdict& verdict);

}  // namespace aomd::scene
