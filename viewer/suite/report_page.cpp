// The page: assets/suite/page.html with the cases and their pictures in it.

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "core/base/text.h"
#include "core/io/base64.h"
#include "viewer/suite/page_texts.h"
#include "viewer/suite/report.h"

namespace aomd::suite {
namespace {

using nlohmann::json;

/// A picture that needs no file beside the page; empty where there is none.
std::string embedded(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (file.empty() || !in) return {};
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  return "data:image/png;base64," + io::detail::to_base64(bytes);
}

json parts_of(const CaseResult& result) {
  json parts = json::array();
  for (const Judged& each : result.judged) {
    const measure::PixelArea& tile = each.verdict.tile;
    parts.push_back({{"part", each.part},
                     {"same", each.verdict.worst_tile >= 1},
                     {"tile", {tile.x, tile.y, tile.width, tile.height}}});
  }
  return parts;
}

/// What is its baseline pixel by pixel has no picture of its own.
json entry_of(const Suite& suite, const Finished& each) {
  const CaseResult& result = each.result;
  const bool compared = !result.judged.empty();
  const std::string baseline = embedded(suite.baseline_of(*each.what));
  const std::string picture = embedded(result.picture);
  return {{"name", each.what->name},
          {"place", printable(suite.place_of(*each.what))},
          {"outcome", outcome_word(result.outcome)},
          {"why", result.why},
          {"worst_tile", result.worst_tile()},
          {"largest", result.largest()},
          {"share", result.share()},
          {"seconds", result.seconds},
          {"size", {each.what->size.x, each.what->size.y}},
          {"same_size", !compared || result.judged.front().verdict.same_size},
          {"judged", parts_of(result)},
          {"baseline", baseline},
          {"result", picture.empty() && result.well() ? baseline : picture},
          {"difference", embedded(result.difference)}};
}

}  // namespace

std::string report_page(const Suite& suite, const std::vector<Finished>& finished) {
  json cases = json::array();
  for (const Finished& each : finished) cases.push_back(entry_of(suite, each));
  const json data = {{"suite", printable(suite.file.stem().string())},
                     {"summary", report_summary(finished)},
                     {"cases", cases}};
  constexpr std::string_view place = "{{data}}";
  const std::string_view page = embedded_texts().front().text;
  const std::size_t at = page.find(place);
  std::string text(page.substr(0, at));
  for (const char c : data.dump(-1, ' ', true))  // what ends a script would end this one
    text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text.append(page.substr(at + place.size()));
}

}  // namespace aomd::suite
