#include "viewer/document/recovery.h"

#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <string>
#include <system_error>
#include <utility>

#include "core/io/io.h"
#include "core/io/journal_file.h"

namespace aomd::scene {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds between_writings_of_a_run{2};
constexpr int rest_per_work = 20;
constexpr int most_names = 8;  // one process number may live on two machines that share a home

/// A file is named so that it is found from wherever the program is started next.
std::string spacing_of(const Document& document) {
  const std::string source(document.spacing_source());
  std::error_code ignored;
  return fs::is_regular_file(source, ignored) ? fs::absolute(source, ignored).string() : source;
}

/// What of a document is to be kept now. The mesh must have come from a file or a sample.
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
  work.spacing = spacing_of(document);
  work.classify = document.classify_options();
  work.snaps = document.snaps();
  if (document.lies_on_model()) work.model = fs::absolute(document.model()->file, ignored);
  return work;
}

}  // namespace

RecoveryKeeper::RecoveryKeeper(fs::path folder) : folder_(std::move(folder)) {}

RecoveryKeeper::~RecoveryKeeper() {
  if (writing_.valid()) writing_.wait();
}

bool RecoveryKeeper::lock() {
  if (lock_) return true;
  std::error_code ignored;
  fs::create_directories(folder_, ignored);
  for (int i = 1; i <= most_names && !lock_; ++i) {
    const std::string name = std::to_string(::getpid()) + (i == 1 ? "" : "+" + std::to_string(i));
    file_ = folder_ / (name + ".json");
    lock_ = FileLock::take(folder_ / (name + ".lock"));
  }
  if (!lock_) report(folder_.string() + ": cannot be written");
  return lock_ != nullptr;
}

bool RecoveryKeeper::due(const Document& document, const HistoryPlace& now) const {
  const bool same = now == place_ && document.tree().version() == bookmarks_;
  if (same || Clock::now() < not_before_) return false;
  const LoadedMesh& content = document.content();
  return content.start && (!content.source.file.empty() || !content.source.sample.empty());
}

void RecoveryKeeper::update(const Document& document) {
  take_written();
  if (writing_.valid() || document.empty()) return;
  const HistoryPlace now = document.place();
  if (!document.unsaved()) {
    if (!journal_.empty()) remove_files();
    place_ = now;
  } else if (due(document, now) && lock()) {
    place_ = now;
    bookmarks_ = document.tree().version();
    start_writing(document);
    if (document.running()) not_before_ = Clock::now() + between_writings_of_a_run;
  }
}

void RecoveryKeeper::write_now(const Document& document) {
  if (writing_.valid()) writing_.wait();
  take_written();
  not_before_ = {};
  update(document);
  if (writing_.valid()) writing_.wait();
  take_written();
}

void RecoveryKeeper::start_writing(const Document& document) {
  SavedWork work = work_of(document);
  work.file = file_;
  work.journal = folder_ / (file_.stem().string() + "-" + std::to_string(++number_) + ".journal");
  work.seconds = std::time(nullptr);
  const bool seams = !document.content().classify_options.seams.empty();
  io::JournalFile file{work.source.classify, *document.content().start, document.journal(), seams};
  writing_ = std::async(std::launch::async, [work = std::move(work), file = std::move(file)] {
    const auto begin = Clock::now();
    try {
      io::write_journal(work.journal, file);
      io::write_file(work.file, saved_work_text(work));
    } catch (const std::exception& error) {
      std::error_code ignored;
      fs::remove(work.journal, ignored);
      return Written{{}, Clock::now() - begin, error.what()};
    }
    return Written{work.journal, Clock::now() - begin, {}};
  });
}

void RecoveryKeeper::take_written() {
  using namespace std::chrono_literals;
  if (!writing_.valid() || writing_.wait_for(0s) != std::future_status::ready) return;
  const Written written = writing_.get();
  not_before_ = std::max(not_before_, Clock::now() + rest_per_work * written.time);
  if (written.journal.empty()) return report(written.problem);
  reported_ = false;
  std::error_code ignored;
  if (!journal_.empty()) fs::remove(journal_, ignored);
  journal_ = written.journal;
  if (const auto old = std::exchange(taken_over_, nullptr)) discard(*old);
}

/// Says it once, until a writing succeeds.
void RecoveryKeeper::report(const std::string& problem) {
  if (!std::exchange(reported_, true)) problem_ = "Unsaved work is not kept: " + problem;
}

void RecoveryKeeper::remove_files() {
  std::error_code ignored;
  fs::remove(file_, ignored);
  fs::remove(journal_, ignored);
  journal_.clear();
  if (const auto old = std::exchange(taken_over_, nullptr)) discard(*old);
}

void RecoveryKeeper::finish() {
  if (writing_.valid()) writing_.wait();
  take_written();
  remove_files();
  if (!lock_) return;
  std::error_code ignored;
  fs::remove(fs::path(file_).replace_extension(".lock"), ignored);
  lock_.reset();
}

}  // namespace aomd::scene
