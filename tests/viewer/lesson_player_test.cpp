// The lessons of the program from page to page, and what opening and leaving one does to a session.

#include <gtest/gtest.h>

#include <set>

#include "core/io/journal_file.h"
#include "tests/support/session_helpers.h"
#include "viewer/lessons/lesson_texts.h"

namespace aomd::scene::lesson_player_test {
namespace {

using test::drive;

/// All that a page sets and a user may change.
struct State {
  explicit State(Session& s)
      : mesh(io::fingerprint(s.document().mesh())),
        options(s.document().options()),
        cursor(s.document().journal().cursor()),
        selected(s.sheet().selection.entities().begin(), s.sheet().selection.entities().end()),
        coloring(s.view.coloring),
        labels(s.view.labels),
        side_by_side(s.view.side_by_side),
        page(s.view.panels.page),
        eye(s.view.camera.azimuth_deg, s.view.camera.elevation_deg, s.view.camera.distance) {
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        if (i != j && s.document().mesh().stored(i, j)) stored.emplace(i, j);
  }
  bool operator==(const State&) const = default;

  io::MeshFingerprint mesh;
  DecimationOptions options;
  std::size_t cursor;
  std::vector<EntityRef> selected;
  Coloring coloring;
  bool labels, side_by_side;
  Page page;
  glm::dvec3 eye;
  std::set<std::pair<int, int>> stored;
};

class EachLesson : public testing::TestWithParam<EmbeddedText> {};

/// Page after page: what its text says holds (its own expectations), its task is not done before
/// its solution and is afterwards, and it begins in the same way when one comes back to it.
TEST_P(EachLesson, HoldsFromPageToPage) {
  const Lesson lesson = parse_lesson(std::string(GetParam().name), GetParam().text, is_command);
  EXPECT_TRUE(std::any_of(lesson.pages.begin(), lesson.pages.end(), [](const LessonPage& p) {
    return !p.checks.empty();
  })) << "something to try";
  Session s;
  drive(s, {"lesson " + lesson.name});
  for (std::size_t i = 0; i < lesson.pages.size(); ++i) {
    const LessonPage& page = lesson.pages[i];
    ASSERT_EQ(s.lesson.page_number(), i);
    const State begin(s);
    for (const bool met : s.lesson.met()) EXPECT_TRUE(page.checks.size() > 1 || !met) << page.title;
    EXPECT_EQ(s.lesson.done(), page.checks.empty()) << page.title << ": done before anything was";
    for (const LessonLine& line : page.solution) drive(s, {line.text});
    EXPECT_TRUE(s.lesson.done()) << page.title << ": its solution leaves it undone";
    drive(s, {"theme toggle", "color quality", "lesson restart"});
    EXPECT_EQ(State(s), begin) << page.title;
    if (i > 0) {
      drive(s, {"lesson back", "lesson next"});
      EXPECT_EQ(State(s), begin) << page.title << ": come back to";
    }
    drive(s, {"lesson solve"});
    EXPECT_TRUE(s.lesson.done()) << page.title;
    if (i + 1 < lesson.pages.size()) drive(s, {"lesson next"});
  }
  EXPECT_TRUE(s.lesson.completed.contains(lesson.name));
  drive(s, {"lesson next"});
  EXPECT_TRUE(s.lesson.last_page());
}

void follow_links(Session& s, const std::vector<Paragraph>& text) {
  for (const Paragraph& paragraph : text)
    for (const TextSpan& span : paragraph)
      if (span.kind == TextSpan::Kind::Link) {
        EXPECT_NO_THROW(drive(s, {span.line})) << span.line;
      }
}

TEST_P(EachLesson, EveryLinkAndKeyDoesSomething) {
  const Lesson& lesson =
      *find_lesson(parse_lesson(std::string(GetParam().name), GetParam().text).name);
  Session s;
  for (std::size_t i = 0; i < lesson.pages.size(); ++i) {
    const LessonPage& page = lesson.pages[i];
    drive(s, {"lesson " + lesson.name + " " + std::to_string(i + 1)});
    follow_links(s, page.text);
    follow_links(s, page.task);
    std::vector<Paragraph> all = page.text;
    all.insert(all.end(), page.task.begin(), page.task.end());
    all.push_back(page.hint);
    for (const Paragraph& paragraph : all)
      for (const TextSpan& span : paragraph)
        if (span.kind == TextSpan::Kind::Key) {
          EXPECT_FALSE(line_of_chord(span.text).empty()) << span.text;
        }
  }
}

std::string lesson_name(const testing::TestParamInfo<EmbeddedText>& info) {
  std::string name(info.param.name);
  name = name.substr(name.find('-') + 1);
  return name.substr(0, name.find('.'));
}
INSTANTIATE_TEST_SUITE_P(Lessons, EachLesson,
                         testing::ValuesIn(embedded_texts().begin(), embedded_texts().end()),
                         lesson_name);

TEST(LessonPlayer, ThereAreAtLeastEight) {
  std::set<std::string> names;
  for (const Lesson& each : lessons()) names.insert(each.name);
  EXPECT_GE(names.size(), 8u);
  EXPECT_EQ(names.size(), lessons().size());
  EXPECT_EQ(find_lesson("nothing"), nullptr);
}

TEST(LessonPlayer, LeavingPutsBackWhatWasThere) {
  Session s;
  drive(s, {"sample sphere 8", "factor 7", "angle 33", "color quality", "panel histograms on",
            "lesson stored", "lesson next"});
  EXPECT_EQ(s.document().options().factor, 4);
  EXPECT_EQ(s.view.coloring, Coloring::Classification);
  drive(s, {"lesson off"});
  EXPECT_EQ(s.lesson.lesson(), nullptr);
  EXPECT_EQ(s.document().content().name, "sphere");
  EXPECT_EQ(s.document().options().factor, 7);
  EXPECT_EQ(s.document().options().angle_deg, 33);
  EXPECT_EQ(s.view.coloring, Coloring::Quality);
  EXPECT_EQ(s.view.panels.page, Page::Histograms);
}

TEST(LessonPlayer, AnotherMeshEndsIt) {
  Session s;
  drive(s, {"sample sphere 8", "factor 7", "lesson directions", "sample torus 8"});
  EXPECT_EQ(s.lesson.lesson(), nullptr);
  EXPECT_EQ(s.document().content().name, "torus");
  EXPECT_EQ(s.document().options().factor, 7);
}

TEST(LessonPlayer, UnsavedWorkIsAskedAboutAndPracticeIsNone) {
  Session s;
  drive(s, {"sample sphere 8", "promote edge 0", "coarsest on", "step"});
  EXPECT_TRUE(asks_first(s, "lesson stored"));
  EXPECT_EQ(s.view.dialog, Dialog::Unsaved);
  drive(s, {"lesson collapses", "coarsest on", "step"});
  EXPECT_FALSE(s.document().unsaved());
  EXPECT_FALSE(asks_first(s, "lesson next"));
  EXPECT_FALSE(asks_first(s, "quit"));
}

TEST(LessonPlayer, ARuinedScanIsNotDone) {
  Session s;
  drive(s, {"lesson scan 6", "coarsest on", "angle 30", "run", "expect faces < 300",
            "expect euler = 2", "expect lesson-done = 0"});
  drive(s, {"lesson restart", "coarsest on", "angle 11", "run", "expect lesson-done = 1"});
}

TEST(LessonPlayer, TheUsualResultIsNoBetterOne) {
  Session s;
  drive(s, {"lesson judge 5", "run", "expect faces = 456", "expect lesson-done = 0"});
}

TEST(LessonPlayer, ChecksAreLive) {
  Session s;
  drive(s, {"lesson stored 6", "expect lesson-done = 0", "adjacency 0 1 on", "adjacency 1 2 on",
            "adjacency 2 3 on", "adjacency 3 2 on", "expect lesson-done = 1", "adjacency 0 1 off"});
  EXPECT_TRUE(s.lesson.done()) << "what was done stays done";
  drive(s, {"lesson restart", "expect lesson-done = 0"});
}

TEST(LessonPlayer, WrongLinesSayWhatWouldBeRight) {
  Session s;
  drive(s, {"lesson next"});
  EXPECT_EQ(s.status, "No lesson is open: F2 lists them") << "a key may come at any time";
  EXPECT_THROW(execute(s, "lesson restart"), CommandError);
  EXPECT_THROW(execute(s, "lesson"), CommandError);
  EXPECT_THROW(execute(s, "lesson mesh two.mesh"), CommandError);
  EXPECT_THROW(execute(s, "lesson stored 99"), CommandError);
  drive(s, {"lesson stored"});
  EXPECT_THROW(execute(s, "lesson mesh none.off"), CommandError);
  drive(s, {"lesson back"});
  EXPECT_EQ(s.status, "This is the lesson's first page");
  EXPECT_THROW(execute(s, "expect verdict = topology"), ExpectationMissed);
  EXPECT_THROW(execute(s, "expect class edge 9999 = face:1"), ExpectationMissed);
  EXPECT_THROW(execute(s, "expect around vertex 0 3 < 1"), CommandError);
}

}  // namespace
}  // namespace aomd::scene::lesson_player_test
