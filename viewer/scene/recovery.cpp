#include "viewer/scene/recovery.h"

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
  return lock_ != nullptr;
}

bool RecoveryKeeper::due(const Document& document, const HistoryPlace& now) const {
  const bool same = now == place_ && document.tree().version() == bookmarks_;
  if (same || Clock::now() < not_before_) return false;
  const LoadedMesh& content = document.content();
  return !content.skin && content.start &&
         (!content.source.file.empty() || !content.source.sample.empty());
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
  io::JournalFile file{work.source.classify, *document.content().start, document.journal()};
  writing_ = std::async(std::launch::async, [work = std::move(work), file = std::move(file)] {
    const auto begin = Clock::now();
    try {
      io::write_journal(work.journal, file);
      io::write_file(work.file, saved_work_text(work));
    } catch (const io::FileError&) {
      std::error_code ignored;
      fs::remove(work.journal, ignored);
      return Written{};
    }
    return Written{work.journal, Clock::now() - begin};
  });
}

void RecoveryKeeper::take_written() {
  using namespace std::chrono_literals;
  if (!writing_.valid() || writing_.wait_for(0s) != std::future_status::ready) return;
  const Written written = writing_.get();
  not_before_ = std::max(not_before_, Clock::now() + rest_per_work * written.time);
  if (written.journal.empty()) return;
  std::error_code ignored;
  if (!journal_.empty()) fs::remove(journal_, ignored);
  journal_ = written.journal;
  if (const auto old = std::exchange(taken_over_, nullptr)) discard(*old);
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
