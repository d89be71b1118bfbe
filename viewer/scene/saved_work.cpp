#include "viewer/scene/saved_work.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/io/error.h"
#include "core/io/journal_file.h"

namespace aomd::scene {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr int schema = 1;

Json classify_json(const ClassifyOptions& c) {
  return {{"feature_angle", c.feature_angle_deg ? Json(*c.feature_angle_deg) : Json()},
          {"corner_angle", c.corner_angle_deg},
          {"nonmanifold_edges", c.nonmanifold_edges},
          {"keep_present", c.keep_present}};
}

ClassifyOptions classify_from(const Json& json) {
  ClassifyOptions c;
  c.feature_angle_deg.reset();
  if (const Json& angle = json.at("feature_angle"); !angle.is_null()) c.feature_angle_deg = angle;
  c.corner_angle_deg = json.at("corner_angle");
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
          {"regularity", o.regularity},
          {"without", o.without},
          {"max_distance", o.max_distance},
          {"no_intersections", o.no_intersections},
          {"paper_topology", o.topology == TopologyRule::Paper},
          {"improve_passes", o.improve_passes},
          {"swap", o.swap},
          {"smooth", o.smooth}};
}

DecimationOptions options_from(const Json& json) {
  DecimationOptions o;
  o.strategy = json.at("quality") ? Strategy::Quality : Strategy::Paper;
  o.factor = json.at("factor");
  o.coarsest = json.at("coarsest");
  o.target_faces = json.at("target_faces");
  o.angle_deg = json.at("angle");
  o.min_angle_deg = json.at("min_angle");
  o.regularity = json.at("regularity");
  o.without = json.at("without");
  o.max_distance = json.at("max_distance");
  o.no_intersections = json.at("no_intersections");
  o.topology = json.at("paper_topology") ? TopologyRule::Paper : TopologyRule::Safe;
  o.improve_passes = json.at("improve_passes");
  o.swap = json.at("swap");
  o.smooth = json.at("smooth");
  return o;
}

std::vector<HistoryMark> marks_from(const Json& json, std::size_t steps) {
  std::vector<HistoryMark> marks;
  for (const Json& mark : json) {
    marks.push_back({mark.at(0), mark.at(1)});
    const std::size_t least = marks.size() > 1 ? marks[marks.size() - 2].begin : 0;
    if (marks.back().begin < least || marks.back().begin >= steps)
      throw std::range_error("marks out of order");
  }
  if (steps > 0 && (marks.empty() || marks.front().begin != 0))
    throw std::range_error("steps without a mark");
  return marks;
}

SavedWork parse(const Json& json, const fs::path& file) {
  if (json.at("schema") != schema) throw std::range_error("written by another version");
  SavedWork work;
  const Json& source = json.at("source");
  work.source.file = source.at("file").get<std::string>();
  work.source.sample = source.at("sample");
  work.source.sample_size = source.at("size");
  work.source.classify = classify_from(source.at("classify"));
  work.cursor = json.at("cursor");
  work.steps = json.at("steps");
  if (work.cursor > work.steps) throw std::range_error("a place beyond the history");
  work.marks = marks_from(json.at("marks"), work.steps);
  for (const Json& mark : json.value("bookmarks", Json::array())) {
    work.bookmarks.emplace_back(mark.at(0), mark.at(1));
    if (work.bookmarks.back().second > work.steps)
      throw std::range_error("a bookmark beyond the history");
  }
  work.options = options_from(json.at("options"));
  work.spacing = json.at("spacing");
  work.classify = classify_from(json.at("classify"));
  work.snaps = json.at("snap");
  work.model = json.at("model").get<std::string>();
  work.seconds = json.at("seconds");
  work.file = file;
  const fs::path journal = json.at("journal").get<std::string>();
  if (journal.has_parent_path()) throw std::range_error("a journal in another folder");
  work.journal = file.parent_path() / journal;
  return work;
}

/// What a process has left that its NAME.json does not name: journals, and files that it was about
/// to write.
void remove_strays(const fs::path& folder, const std::string& name, const fs::path& kept) {
  std::error_code error;
  for (fs::directory_iterator it(folder, error); !error && it != fs::directory_iterator();
       it.increment(error)) {
    const std::string each = it->path().filename().string();
    const bool its = each.rfind(name + "-", 0) == 0 || each.rfind(name + ".json.", 0) == 0;
    if (its && it->path() != kept) fs::remove(it->path(), error);
  }
}

std::shared_ptr<const SavedWork> take(const fs::path& lock_file) {
  auto lock = FileLock::take(lock_file);
  if (!lock) return {};
  const fs::path file = fs::path(lock_file).replace_extension(".json");
  std::error_code ignored;
  if (!fs::exists(file, ignored)) {  // it had nothing to lose
    remove_strays(lock_file.parent_path(), lock_file.stem().string(), {});
    fs::remove(lock_file, ignored);
    return {};
  }
  try {
    auto work = std::make_shared<SavedWork>(read_saved_work(file));
    remove_strays(lock_file.parent_path(), lock_file.stem().string(), work->journal);
    work->lock = std::move(lock);
    return work;
  } catch (const io::ReadError&) {
    return {};
  }
}

}  // namespace

std::shared_ptr<const FileLock> FileLock::take(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (descriptor < 0) return {};
  std::shared_ptr<const FileLock> lock(new FileLock(descriptor));
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) return {};
  // Whoever held it before may have removed the file in between: then this lock keeps nobody out.
  struct stat held {
  }, named{};
  const bool same = ::fstat(descriptor, &held) == 0 && ::stat(file.c_str(), &named) == 0 &&
                    held.st_ino == named.st_ino && held.st_dev == named.st_dev;
  return same ? lock : nullptr;
}

FileLock::~FileLock() { ::close(descriptor_); }

std::string SavedWork::name() const {
  return source.file.empty() ? source.sample : source.file.filename().string();
}

SavedWork work_of(const Document& document) {
  SavedWork work;
  work.source = document.content().source;
  std::error_code ignored;
  if (!work.source.file.empty()) work.source.file = fs::absolute(work.source.file, ignored);
  work.source.work.reset();
  work.cursor = document.journal().cursor();
  work.steps = document.journal().size();
  work.marks = document.marks();
  for (const Bookmark& mark : document.tree().bookmarks())
    if (mark.branch == 0) work.bookmarks.emplace_back(mark.name, mark.step);
  // A run that has not made its first operation yet.
  if (!work.marks.empty() && work.marks.back().begin >= work.steps) work.marks.pop_back();
  work.options = document.options();
  work.spacing = document.spacing_source();
  work.classify = document.classify_options();
  work.snaps = document.snaps();
  if (document.lies_on_model()) work.model = fs::absolute(document.model()->file, ignored);
  return work;
}

std::string saved_work_text(const SavedWork& work) {
  Json marks = Json::array();
  for (const HistoryMark& mark : work.marks) marks.push_back({mark.begin, mark.label});
  Json bookmarks = Json::array();
  for (const auto& [name, step] : work.bookmarks) bookmarks.push_back({name, step});
  const Json json = {{"schema", schema},
                     {"source",
                      {{"file", work.source.file.string()},
                       {"sample", work.source.sample},
                       {"size", work.source.sample_size},
                       {"classify", classify_json(work.source.classify)}}},
                     {"journal", work.journal.filename().string()},
                     {"cursor", work.cursor},
                     {"steps", work.steps},
                     {"marks", marks},
                     {"bookmarks", bookmarks},
                     {"options", options_json(work.options)},
                     {"spacing", work.spacing},
                     {"classify", classify_json(work.classify)},
                     {"snap", work.snaps},
                     {"model", work.model.string()},
                     {"seconds", work.seconds}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
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

void restore_history(LoadedMesh& loaded, const SavedWork& work) {
  io::JournalFile file = io::read_journal(work.journal);
  io::check_journal(file, work.journal.string(), loaded.mesh);
  if (file.journal.size() != work.steps)
    throw io::ReadError(work.journal.string(), {},
                        "the journal is not as long as " + work.file.string() + " says");
  const auto words = file.journal.words();
  const auto steps = file.journal.steps();
  loaded.journal.restore({words.begin(), words.end()}, {steps.begin(), steps.end()});
}

std::vector<std::shared_ptr<const SavedWork>> find_saved_work(const fs::path& folder) {
  std::vector<std::shared_ptr<const SavedWork>> found;
  std::vector<fs::path> locks;
  std::error_code error;
  for (fs::directory_iterator it(folder, error); !error && it != fs::directory_iterator();
       it.increment(error))
    if (it->path().extension() == ".lock") locks.push_back(it->path());
  std::sort(locks.begin(), locks.end());
  for (const fs::path& lock : locks)
    if (auto work = take(lock)) found.push_back(std::move(work));
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a->seconds > b->seconds; });
  return found;
}

void discard(const SavedWork& work) {
  std::error_code ignored;
  fs::remove(work.file, ignored);
  fs::remove(work.journal, ignored);
  fs::remove(fs::path(work.file).replace_extension(".lock"), ignored);
}

fs::path recovery_folder() {
  const char* state = std::getenv("XDG_STATE_HOME");
  const char* home = std::getenv("HOME");
  if (state != nullptr && *state == '/') return fs::path(state) / "aomd";
  if (home != nullptr && *home == '/') return fs::path(home) / ".local" / "state" / "aomd";
  return {};
}

}  // namespace aomd::scene
