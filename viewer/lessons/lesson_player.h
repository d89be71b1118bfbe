#pragma once
// The lesson that is open: which page, what of its task is met, and what was there before.

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "viewer/document/document_options.h"
#include "viewer/document/load_request.h"
#include "viewer/drawing/view.h"
#include "viewer/lessons/lesson.h"

namespace aomd::scene {

/// What the user had before the first page of a lesson.
struct BeforeLesson {
  LoadRequest source;
  View view;
  DecimationOptions options;
  ClassifyOptions classify;
  bool snaps = false;
};

/// The view with which a lesson begins: as after the start of the program, but for how the window
/// looks.
[[nodiscard]] View view_for_lesson(const View& present);
/// The view of before, but for the camera and for what the window looks like now.
[[nodiscard]] View view_after_lesson(const View& before, const View& present);

/// Knows where a lesson stands and changes nothing else: lesson_commands.h carries out its lines.
class LessonPlayer {
 public:
  /// Null: no lesson is open.
  [[nodiscard]] const Lesson* lesson() const { return lesson_; }
  [[nodiscard]] std::size_t page_number() const { return page_; }  ///< from 0
  [[nodiscard]] const LessonPage& page() const { return lesson_->pages[page_]; }
  [[nodiscard]] bool last_page() const { return page_ + 1 == lesson_->pages.size(); }
  /// For each check of the page: whether it is met now. All are once the task has been done.
  [[nodiscard]] const std::vector<bool>& met() const { return met_; }
  /// All checks were met at once since the page was entered; true where there are none.
  [[nodiscard]] bool done() const { return done_; }
  /// While its pages' commands are carried out: what they load is for practice.
  [[nodiscard]] bool entering() const { return entering_; }
  void set_entering(bool on) { entering_ = on; }

  /// Another page is being entered. `before` counts where no lesson was open.
  void begin(const Lesson& lesson, std::size_t page, BeforeLesson before);
  /// Its commands have been carried out.
  void begin_task();
  /// The result of looking at every check of the page.
  void take(std::vector<bool> met);
  /// Counts a lesson whose last page is done.
  void note_completion();
  /// What was there before; none where no lesson is open.
  [[nodiscard]] std::optional<BeforeLesson> end();

  bool shown = true;                ///< its tab is in front of the mesh's
  bool hinted = false;              ///< the hint is open
  std::set<std::string> completed;  ///< names of lessons whose last page was done
  /// Whether a word about lessons is worth while: strong at the first start, quiet as long as some
  /// are left.
  enum class Hint { None, First, Again };
  Hint suggested = Hint::None;

  /// What checks can depend on.
  struct Stamp {
    std::uint64_t executed = 0;
    std::size_t cursor = 0;
    std::uint64_t epoch = 0;
    friend bool operator==(const Stamp&, const Stamp&) = default;
  };
  /// False where the checks have been looked at with this stamp.
  [[nodiscard]] bool differs(const Stamp& now) const { return looked_at_ != now; }
  void set_looked_at(const Stamp& now) { looked_at_ = now; }

 private:
  const Lesson* lesson_ = nullptr;
  std::size_t page_ = 0;
  std::vector<bool> met_;
  bool done_ = false;
  bool entering_ = false;
  std::optional<Stamp> looked_at_;
  std::optional<BeforeLesson> before_;
};

}  // namespace aomd::scene
