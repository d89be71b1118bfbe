#include "viewer/ui/rich_text.h"

#include <algorithm>
#include <string>
#include <vector>

#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

using scene::TextSpan;
using Kind = scene::TextSpan::Kind;

constexpr float line_ems = 1.27f;
constexpr float key_pad_ems = 0.32f;

/// What is never broken: a word, or a key whatever stands on it.
struct Piece {
  const TextSpan* span;
  std::string text;
  bool after_blank;
};

std::vector<Piece> pieces_of(const scene::Paragraph& paragraph) {
  std::vector<Piece> pieces;
  bool blank = false;
  for (const TextSpan& span : paragraph) {
    if (span.kind == Kind::Key) {
      pieces.push_back({&span, span.text, blank});
      blank = false;
      continue;
    }
    for (std::size_t at = 0; at < span.text.size();) {
      if (span.text[at] == ' ') {
        blank = true;
        ++at;
        continue;
      }
      const std::size_t end = std::min(span.text.find(' ', at), span.text.size());
      pieces.push_back({&span, span.text.substr(at, end - at), blank});
      blank = false;
      at = end;
    }
  }
  return pieces;
}

/// Draws word after word and keeps where the next one stands.
class Writer {
 public:
  Writer(Frame& frame, ImVec4 color)
      : frame_(frame),
        color_(color),
        begin_(ImGui::GetCursorScreenPos()),
        at_(begin_),
        width_(ImGui::GetContentRegionAvail().x) {}

  void write(const std::vector<Piece>& pieces) {
    for (std::size_t i = 0; i < pieces.size();) {
      std::size_t end = i + 1;  // what no blank divides stays together
      while (end < pieces.size() && !pieces[end].after_blank) ++end;
      float unit = 0;
      for (std::size_t k = i; k < end; ++k) unit += width(pieces[k]);
      const float blank = at_.x > begin_.x && pieces[i].after_blank ? 0.27f * em() : 0;
      if (at_.x > begin_.x && at_.x + blank + unit > begin_.x + width_)
        at_ = {begin_.x, at_.y + line_ems * em()};
      else
        at_.x += blank;
      for (; i < end; ++i) draw(pieces[i], static_cast<int>(i));
    }
    ImGui::SetCursorScreenPos(begin_);
    ImGui::Dummy({width_, at_.y - begin_.y + line_ems * em()});
  }

 private:
  [[nodiscard]] ImFont* font(Kind kind) const {
    if (kind == Kind::Emphasis) return frame_.fonts.heading;
    return kind == Kind::Code ? frame_.fonts.mono : frame_.fonts.text;
  }
  /// Bold and code in the size that suits the text.
  [[nodiscard]] static float size(Kind kind) {
    return kind == Kind::Code ? 0.94f * em() : kind == Kind::Key ? 0.86f * em() : em();
  }
  [[nodiscard]] float width(const Piece& piece) const {
    const Kind kind = piece.span->kind;
    const float text = font(kind)->CalcTextSizeA(size(kind), 1e9f, 0, piece.text.c_str()).x;
    return kind == Kind::Key ? text + 2 * key_pad_ems * em() : text;
  }

  void draw(const Piece& piece, int number) {
    const Kind kind = piece.span->kind;
    const float w = width(piece);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImVec4 color = color_;
    if (kind == Kind::Link) color = link(piece, w, number);
    ImVec2 place{at_.x, at_.y + 0.5f * (em() - size(kind))};
    if (kind == Kind::Key) {
      list.AddRectFilled({at_.x, at_.y - 0.08f * em()}, {at_.x + w, at_.y + 1.06f * em()},
                         ImGui::GetColorU32(ImGuiCol_FrameBg), 0.25f * em());
      list.AddRect({at_.x, at_.y - 0.08f * em()}, {at_.x + w, at_.y + 1.06f * em()},
                   ImGui::GetColorU32(frame_.colors.border), 0.25f * em());
      place.x += key_pad_ems * em();
    }
    list.AddText(font(kind), size(kind), place, ImGui::GetColorU32(color), piece.text.c_str());
    at_.x += w;
  }

  /// The whole link reacts to the mouse word by word.
  [[nodiscard]] ImVec4 link(const Piece& piece, float w, int number) {
    ImGui::SetCursorScreenPos(at_);
    ImGui::PushID(&piece.span->line);
    ImGui::PushID(number);
    if (ImGui::InvisibleButton("link", {w, em()})) frame_.emit(piece.span->line);
    const bool hovered = ImGui::IsItemHovered();
    if (hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    command_tooltip(piece.span->line);
    ImGui::PopID();
    ImGui::PopID();
    ImVec4 line = frame_.colors.accent;
    line.w = hovered ? 1.0f : 0.5f;
    ImGui::GetWindowDrawList()->AddLine({at_.x, at_.y + 1.02f * em()},
                                        {at_.x + w, at_.y + 1.02f * em()}, ImGui::GetColorU32(line),
                                        0.07f * em());
    return frame_.colors.accent;
  }

  Frame& frame_;
  ImVec4 color_;
  ImVec2 begin_, at_;
  float width_;
};

}  // namespace

void rich_text(Frame& frame, const scene::Paragraph& paragraph, ImVec4 color) {
  Writer(frame, color).write(pieces_of(paragraph));
}

void tick_sign(const Frame& frame, ImVec2 at, bool ticked) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float r = 0.46f * em();
  const ImVec2 c{at.x + r, at.y + 0.5f * em()};
  if (!ticked) {
    list.AddCircle(c, r, ImGui::GetColorU32(frame.colors.text_muted), 24, 0.09f * em());
    return;
  }
  list.AddCircleFilled(c, r, ImGui::GetColorU32(frame.colors.good), 24);
  const ImVec2 points[] = {{c.x - 0.45f * r, c.y + 0.05f * r},
                           {c.x - 0.1f * r, c.y + 0.4f * r},
                           {c.x + 0.5f * r, c.y - 0.35f * r}};
  for (const int i : {0, 1})
    list.AddLine(points[i], points[i + 1], ImGui::GetColorU32(frame.colors.panel), 0.14f * em());
}

}  // namespace aomd::ui
