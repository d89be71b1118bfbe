#pragma once
// Where things stand in the viewer's window, found out by clicking on an interface that nobody
// sees: what it draws and emits is what the window draws and emits.

#include <optional>
#include <string_view>

#include <glm/vec2.hpp>

#include "viewer/session/session.h"
#include "viewer/ui/layout.h"

namespace aomd::test {

/// The areas of a window of `size` units that shows the session.
[[nodiscard]] ui::Layout layout_of(scene::Session& session, glm::ivec2 size);

/// A place in `area` of such a window where a click emits `line`; none where nothing does. The
/// session stays as it is. Costs about 2000 frames without drawing.
[[nodiscard]] std::optional<glm::ivec2> place_of(scene::Session& session, glm::ivec2 size,
                                                 std::string_view line, const ui::Area& area);

}  // namespace aomd::test
