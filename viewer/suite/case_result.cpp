#include "viewer/suite/case_result.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

namespace aomd::suite {
namespace {

using measure::PictureLimits;
using measure::PixelArea;
using nlohmann::json;

/// The four rectangles around an area.
std::vector<PixelArea> around(const PixelArea& area, glm::ivec2 size) {
  const int right = area.x + area.width, bottom = area.y + area.height;
  return {{0, 0, size.x, area.y},
          {0, bottom, size.x, size.y - bottom},
          {0, area.y, area.x, area.height},
          {right, area.y, size.x - right, area.height}};
}

PictureLimits with_masks(PictureLimits limits, const std::vector<PixelArea>& more) {
  limits.masks.insert(limits.masks.end(), more.begin(), more.end());
  return limits;
}

json to_json(const Judged& judged) {
  const measure::PictureVerdict& v = judged.verdict;
  return {{"part", judged.part},
          {"same", v.same},
          {"same_size", v.same_size},
          {"worst_tile", v.worst_tile},
          {"tile", {v.tile.x, v.tile.y, v.tile.width, v.tile.height}},
          {"largest", v.largest},
          {"differing", v.differing},
          {"judged", v.judged},
          {"why", v.why}};
}

Judged judged_from(const json& from) {
  Judged judged{from.at("part"), {}};
  measure::PictureVerdict& v = judged.verdict;
  from.at("same").get_to(v.same);
  from.at("same_size").get_to(v.same_size);
  from.at("worst_tile").get_to(v.worst_tile);
  const auto tile = from.at("tile").get<std::array<int, 4>>();
  v.tile = {tile[0], tile[1], tile[2], tile[3]};
  from.at("largest").get_to(v.largest);
  from.at("differing").get_to(v.differing);
  from.at("judged").get_to(v.judged);
  from.at("why").get_to(v.why);
  return judged;
}

}  // namespace

std::string_view outcome_word(Outcome outcome) {
  constexpr std::array<std::string_view, 7> words = {"same",   "new",     "updated", "differs",
                                                     "missed", "missing", "broken"};
  return words[static_cast<std::size_t>(outcome)];
}

double CaseResult::worst_tile() const {
  double least = 1;
  for (const Judged& each : judged) least = std::min(least, each.verdict.worst_tile);
  return least;
}

int CaseResult::largest() const {
  int most = 0;
  for (const Judged& each : judged) most = std::max(most, each.verdict.largest);
  return most;
}

double CaseResult::share() const {
  std::size_t differing = 0, pixels = 0;
  for (const Judged& each : judged) {
    differing += each.verdict.differing;
    pixels += each.verdict.judged;
  }
  return pixels == 0 ? 0 : static_cast<double>(differing) / static_cast<double>(pixels);
}

std::vector<Judged> judge(const Case& each, const io::Image& baseline, const io::Image& picture,
                          const PixelArea& scene) {
  if (!each.panels) return {{"", judge_pictures(baseline, picture, each.limits)}};
  const PictureLimits in_scene = with_masks(each.limits, around(scene, each.size));
  PictureLimits in_panels = with_masks(each.limits, {scene});
  in_panels.threshold = each.panels_threshold;
  return {{"scene", judge_pictures(baseline, picture, in_scene)},
          {"panels", judge_pictures(baseline, picture, in_panels)}};
}

std::string why_differs(const std::vector<Judged>& judged) {
  std::string text;
  for (const Judged& each : judged) {
    if (each.verdict.same) continue;
    text += text.empty() ? "" : "; ";
    text += each.part.empty() ? each.verdict.why : "in the " + each.part + ", " + each.verdict.why;
  }
  return text;
}

std::string to_json(const CaseResult& result) {
  json judged = json::array();
  for (const Judged& each : result.judged) judged.push_back(to_json(each));
  return json{{"outcome", static_cast<int>(result.outcome)},
              {"exit_code", result.exit_code},
              {"why", result.why},
              {"judged", judged},
              {"seconds", result.seconds},
              {"picture", result.picture.string()},
              {"difference", result.difference.string()}}
      .dump(-1, ' ', true);
}

CaseResult from_json(const std::string& text) {
  const json from = json::parse(text);
  CaseResult result;
  result.outcome = static_cast<Outcome>(from.at("outcome").get<int>());
  from.at("exit_code").get_to(result.exit_code);
  from.at("why").get_to(result.why);
  for (const json& each : from.at("judged")) result.judged.push_back(judged_from(each));
  from.at("seconds").get_to(result.seconds);
  result.picture = from.at("picture").get<std::string>();
  result.difference = from.at("difference").get<std::string>();
  return result;
}

}  // namespace aomd::suite
