#include "viewer/document/saved_work.h"

#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "core/io/error.h"

namespace aomd::scene {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr int schema = 1;
constexpr double most_steps = 1e15;
constexpr double any = std::numeric_limits<double>::max();

/// File names need not be UTF-8, which JSON must: such a text is kept as its bytes.
Json text_json(const std::string& text) {
  try {
    Json json = text;
    static_cast<void>(json.dump());
    return json;
  } catch (const Json::type_error&) {
    return std::vector<std::uint8_t>(text.begin(), text.end());
  }
}

std::string text_from(const Json& json) {
  if (!json.is_array()) return json.get<std::string>();
  std::string text;
  for (const Json& byte : json) text += static_cast<char>(byte.get<std::uint8_t>());
  return text;
}

/// A number in [low, high], as a command would have taken it.
double number_from(const Json& json, const char* name, double low, double high) {
  const double value = json.at(name).get<double>();
  if (!(value >= low && value <= high))
    throw std::range_error(std::string(name) + " is out of range");
  return value;
}

std::size_t whole_from(const Json& json, std::size_t high) {
  const double value = json.get<double>();
  if (!(value >= 0 && value <= static_cast<double>(high)) || value != std::trunc(value))
    throw std::range_error("a place beyond the history");
  return static_cast<std::size_t>(value);
}

template <typename T>
T whole_from(const Json& json, const char* name, double high) {
  const double value = number_from(json, name, 0, high);
  if (value != std::trunc(value)) throw std::range_error(std::string(name) + " is not whole");
  return static_cast<T>(value);
}

Json classify_json(const ClassifyOptions& c) {
  return {{"feature_angle", c.feature_angle_deg ? Json(*c.feature_angle_deg) : Json()},
          {"corner_angle", c.corner_angle_deg},
          {"nonmanifold_edges", c.nonmanifold_edges},
          {"keep_present", c.keep_present}};
}

ClassifyOptions classify_from(const Json& json) {
  ClassifyOptions c;
  c.feature_angle_deg.reset();
  if (!json.at("feature_angle").is_null())
    c.feature_angle_deg = number_from(json, "feature_angle", 0, 180);
  c.corner_angle_deg = number_from(json, "corner_angle", 0, 180);
  c.nonmanifold_edges = json.at("nonmanifold_edges");
  c.keep_present = json.at("keep_present");
  return c;
}

Json options_json(const DecimationOptions& o) {
  return {{"quality", o.strategy == Strategy::Quality},
          {"factor", o.factor},
          {"coarsest", o.coarsest},
          {"target_faces", o.target_faces},
          {"angle", o.angle_deg},
          {"min_angle", o.min_angle_deg},
          {"min_dihedral", o.min_dihedral_deg},
          {"regularity", o.regularity},
          {"without", o.without},
          {"max_distance", o.max_distance},
          {"keep_volumes", o.keep_volumes},
          {"no_intersections", o.no_intersections},
          {"paper_topology", o.topology == TopologyRule::Paper},
          {"improve_passes", o.improve_passes},
          {"swap", o.swap},
          {"smooth", o.smooth}};
}

DecimationOptions options_from(const Json& json) {
  DecimationOptions o;
  o.strategy = json.at("quality") ? Strategy::Quality : Strategy::Paper;
  o.factor = number_from(json, "factor", 1, 1e6);
  o.coarsest = json.at("coarsest");
  o.target_faces = whole_from<std::uint32_t>(json, "target_faces", 1e9);
  o.angle_deg = number_from(json, "angle", 0, 180);
  o.min_angle_deg = number_from(json, "min_angle", 0, 60);
  if (json.contains("min_dihedral")) o.min_dihedral_deg = number_from(json, "min_dihedral", 0, 70);
  o.regularity = number_from(json, "regularity", 0, 1);
  o.without = whole_from<std::uint32_t>(json, "without", (1 << idea_count) - 1);
  o.max_distance = number_from(json, "max_distance", 0, any);
  o.keep_volumes = json.value("keep_volumes", true);
  o.no_intersections = json.at("no_intersections");
  o.topology = json.at("paper_topology") ? TopologyRule::Paper : TopologyRule::Safe;
  o.improve_passes = whole_from<int>(json, "improve_passes", 1000);
  o.swap = json.at("swap");
  o.smooth = json.at("smooth");
  return o;
}

std::vector<HistoryMark> marks_from(const Json& json, std::size_t steps) {
  std::vector<HistoryMark> marks;
  for (const Json& mark : json) {
    marks.push_back({whole_from(mark.at(0), steps), text_from(mark.at(1))});
    const std::size_t least = marks.size() > 1 ? marks[marks.size() - 2].begin : 0;
    if (marks.back().begin < least || marks.back().begin >= steps)
      throw std::range_error("marks out of order");
  }
  if (steps > 0 && (marks.empty() || marks.front().begin != 0))
    throw std::range_error("steps without a mark");
  return marks;
}

/// The name of a file beside NAME.json, that begins with NAME: work never leads to another file.
fs::path journal_from(const Json& json, const fs::path& file) {
  const fs::path journal = text_from(json.at("journal"));
  const bool its = journal.filename() == journal && journal.extension() == ".journal" &&
                   journal.string().rfind(file.stem().string(), 0) == 0;
  if (!its) throw std::range_error("a journal that is not its own");
  return file.parent_path() / journal;
}

LoadRequest source_from(const Json& json) {
  LoadRequest source;
  source.file = text_from(json.at("file"));
  source.sample = text_from(json.at("sample"));
  source.sample_size = whole_from<int>(json, "size", 1e9);
  source.classify = classify_from(json.at("classify"));
  return source;
}

SavedWork parse(const Json& json, const fs::path& file) {
  const int version = json.at("schema");
  if (version > schema) throw std::range_error("it is of a newer version of the program");
  if (version < schema) throw std::range_error("there is no such version");
  SavedWork work;
  work.file = file;
  work.journal = journal_from(json, file);
  work.source = source_from(json.at("source"));
  work.steps = whole_from<std::size_t>(json, "steps", most_steps);
  work.cursor = whole_from(json.at("cursor"), work.steps);
  work.marks = marks_from(json.at("marks"), work.steps);
  for (const Json& mark : json.value("bookmarks", Json::array()))
    work.bookmarks.emplace_back(text_from(mark.at(0)), whole_from(mark.at(1), work.steps));
  work.options = options_from(json.at("options"));
  work.spacing = text_from(json.at("spacing"));
  work.classify = classify_from(json.at("classify"));
  work.snaps = json.at("snap");
  work.model = text_from(json.at("model"));
  work.seconds = json.at("seconds");
  return work;
}

}  // namespace

std::string SavedWork::name() const {
  return source.file.empty() ? source.sample : source.file.filename().string();
}

std::string saved_work_text(const SavedWork& work) {
  Json marks = Json::array();
  for (const HistoryMark& mark : work.marks) marks.push_back({mark.begin, text_json(mark.label)});
  Json bookmarks = Json::array();
  for (const auto& [name, step] : work.bookmarks) bookmarks.push_back({text_json(name), step});
  const Json json = {{"schema", schema},
                     {"source",
                      {{"file", text_json(work.source.file.string())},
                       {"sample", text_json(work.source.sample)},
                       {"size", work.source.sample_size},
                       {"classify", classify_json(work.source.classify)}}},
                     {"journal", text_json(work.journal.filename().string())},
                     {"cursor", work.cursor},
                     {"steps", work.steps},
                     {"marks", marks},
                     {"bookmarks", bookmarks},
                     {"options", options_json(work.options)},
                     {"spacing", text_json(work.spacing)},
                     {"classify", classify_json(work.classify)},
                     {"snap", work.snaps},
                     {"model", text_json(work.model.string())},
                     {"seconds", work.seconds}};
  return json.dump(1) + "\n";
}

SavedWork read_saved_work(const fs::path& file) {
  std::ifstream in(file);
  if (!in) throw io::ReadError(file.string(), {}, "cannot be read");
  try {
    return parse(Json::parse(in), file);
  } catch (const std::exception& error) {
    throw io::ReadError(file.string(), {}, std::string("is no saved work: ") + error.what());
  }
}

}  // namespace aomd::scene
