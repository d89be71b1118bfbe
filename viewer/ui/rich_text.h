#pragma once
// Paragraphs of a lesson: words in several looks, broken at blanks.

#include "viewer/lessons/lesson.h"
#include "viewer/ui/frame.h"

namespace aomd::ui {

/// As wide as there is room; links emit their lines.
void rich_text(Frame& frame, const scene::Paragraph& paragraph, ImVec4 color);

/// A round sign, empty or ticked, beside a line of text.
void tick_sign(const Frame& frame, ImVec2 at, bool ticked);

}  // namespace aomd::ui
