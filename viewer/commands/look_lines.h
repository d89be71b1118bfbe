#pragma once
// How a window looks, as commands.

#include <string>
#include <vector>

#include "viewer/drawing/view.h"

namespace aomd::scene {

/// The lines that lead from the look with which scripts begin to the theme and the panels of
/// `view`; none where these are the usual ones.
[[nodiscard]] std::vector<std::string> look_lines(const View& view);

}  // namespace aomd::scene
