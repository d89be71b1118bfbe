#include "viewer/ui/picture_choices.h"

#include <array>

#include "viewer/base/picture_size.h"
#include "viewer/base/text.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

constexpr std::array sizes = {
    Choice{"As the window", "As many pixels as the window has."},
    Choice{"1280x720", "For a web page."},
    Choice{"1920x1080", "For a screen."},
    Choice{"3840x2160", "For a large screen."},
    Choice{"2000x2000", "A square."},
    Choice{"Another size", "So many pixels wide and high, as 2400x1600."},
};

bool own(const PictureChoices& choices) { return choices.size + 1 == sizes.size(); }

void label(const Frame& frame, const char* name, float at) {
  ImGui::SameLine(at);
  ImGui::AlignTextToFramePadding();
  muted(frame, name);
}

}  // namespace

void picture_choices(Frame& frame, PictureChoices& choices) {
  ImGui::AlignTextToFramePadding();
  muted(frame, "Size");
  ImGui::SameLine(4.2f * em());
  ImGui::SetNextItemWidth(10 * em());
  if (const auto chosen = choice_control("##size", sizes, choices.size)) choices.size = *chosen;
  if (own(choices)) {
    ImGui::SameLine();
    ImGui::SetNextItemWidth(9 * em());
    static_cast<void>(text_input("##own", choices.own_size, "2400x1600"));
    tooltip("Pixels, wide and high, as 2400x1600.");
  }
  ImGui::Checkbox("Panels", &choices.panels);
  tooltip("With menus and panels around the picture, as the window has them.");
  ImGui::SameLine(8 * em());
  ImGui::Checkbox("Transparent", &choices.transparent);
  tooltip("Nothing behind the mesh: for a picture that is put on a page.");
  label(frame, "Scale", 18 * em());
  ImGui::SameLine();
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  static_cast<void>(number_control(
      "scale", choices.scale,
      {0.5, 4, "%.2f \u00d7", true, "How many times as large text, lines and dots are."}));
}

std::string picture_problem(const PictureChoices& choices) {
  glm::ivec2 size{0};
  return own(choices) ? scene::read_picture_size(choices.own_size, size) : std::string();
}

std::string picture_words(const PictureChoices& choices) {
  std::string words;
  if (choices.size > 0) words += " " + (own(choices) ? choices.own_size : sizes[choices.size].name);
  if (choices.transparent) words += " transparent";
  if (!choices.panels) words += " no-ui";
  if (choices.scale != 1) words += " scale " + scene::short_number(choices.scale, 2);
  return words;
}

}  // namespace aomd::ui
