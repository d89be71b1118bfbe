#pragma once
// The lesson that is open: which page, what of its task is met, and what was there before.

#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "viewer/document/loaded_mesh.h"
#include "viewer/document/surface_changes.h"
#include "viewer/drawing/view.h"
#include "viewer/lessons/lesson.h"

namespace aomd::scene {

class Session;

/// A page always begins in the same way: the commands of the pages up to it are carried out from a
/// session without options, whatever the user has done. Its meshes are for practice: changing them
/// is no work that could be lost.
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

  /// Opens a page of a lesson. Blocks while it is made; throws CommandError naming the line that
  /// failed.
  void open(Session& session, const Lesson& lesson, std::size_t page);
  /// Loads one of its meshes.
  void load_mesh(Session& session, const std::string& name);
  /// Carries out what does the page's task.
  void solve(Session& session);
  /// Puts back options and view, and loads what was there before; another file's mesh may be there
  /// already.
  void leave(Session& session, bool reload);
  /// Looks whether the task is done, where something has happened since. Cheap.
  void update(Session& session);

  bool shown = true;                ///< its tab is in front of the mesh's
  bool hinted = false;              ///< the hint is open
  std::set<std::string> completed;  ///< names of lessons whose last page was done
  /// Whether a word about lessons is worth while: strong at the first start, quiet as long as some
  /// are left.
  enum class Hint { None, First, Again };
  Hint suggested = Hint::None;

 private:
  /// What the user had before the first page.
  struct Before {
    LoadRequest source;
    View view;
    DecimationOptions options;
    ClassifyOptions classify;
    bool snaps = false;
  };
  /// What checks can depend on.
  struct Stamp {
    std::uint64_t executed = 0;
    HistoryPlace place;
    bool idle = false;
    friend bool operator==(const Stamp&, const Stamp&) = default;
  };

  void carry_out(Session& session, const std::vector<LessonLine>& lines, bool to_the_end);
  [[nodiscard]] bool holds(Session& session, const LessonCheck& check) const;

  const Lesson* lesson_ = nullptr;
  std::size_t page_ = 0;
  std::vector<bool> met_;
  bool done_ = false;
  bool entering_ = false;
  std::optional<Stamp> looked_at_;
  std::unique_ptr<Before> before_;
};

}  // namespace aomd::scene
