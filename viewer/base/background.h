#pragma once
// Work in a thread of its own, whose result somebody asks for later.

#include <atomic>
#include <exception>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

namespace aomd::scene {

template <typename Result>
class Background {
 public:
  /// Starts work(stop, progress), which returns the result, ends early when the token asks it to,
  /// and may say how far it is, 0..1.
  template <typename Work>
  explicit Background(Work work)
      : thread_([this, work = std::move(work)](const std::stop_token& stop) mutable {
          try {
            result_ = work(stop, progress_);
          } catch (...) {
            error_ = std::current_exception();
          }
          finished_ = true;
        }) {}
  /// Asks the work to stop, and waits until it does.
  ~Background() = default;
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  [[nodiscard]] bool finished() const { return finished_; }
  /// 0..1
  [[nodiscard]] double progress() const { return progress_; }
  /// Waits for it. Throws what the work threw.
  [[nodiscard]] Result take() {
    thread_.join();
    if (error_) std::rethrow_exception(error_);
    return std::move(result_);
  }

 private:
  std::atomic<bool> finished_ = false;
  std::atomic<double> progress_ = 0;
  Result result_{};
  std::exception_ptr error_;
  std::jthread thread_;  ///< last: stopped and joined before the rest goes
};

/// The result of work that has ended, or with `wait` that will; none while it goes on and where
/// there is none. The work is gone afterwards, also where it threw.
template <typename Result>
[[nodiscard]] std::optional<Result> take(std::unique_ptr<Background<Result>>& work, bool wait) {
  if (!work || (!wait && !work->finished())) return {};
  const std::unique_ptr<Background<Result>> ended = std::move(work);
  return ended->take();
}

}  // namespace aomd::scene
