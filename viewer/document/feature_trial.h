#pragma once
// A feature angle that is being tried out: what it would lead to, while the slider moves.

#include <array>

#include "core/mesh/mesh.h"
#include "core/model/feature_preview.h"

namespace aomd::scene {

/// Keeps the relations that the next trial needs too.
struct FeatureTrial {
  double angle_deg = 0;
  FeaturePreview preview;
  std::array<Request, 3> needs;
};

}  // namespace aomd::scene
