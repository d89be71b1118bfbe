// Reading lessons: what they may hold, and what is said about those that are wrong.

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "core/io/error.h"
#include "tests/support/message.h"
#include "viewer/commands/commands.h"
#include "viewer/lessons/lesson.h"

namespace aomd::scene::lesson_test {
namespace {

using aomd::test::message;

const std::string head = "@lesson A title\n@about One line\n@minutes 3\n";

std::string error_of(const std::string& text) {
  return message([&] { static_cast<void>(parse_lesson("01-x.lesson", text, is_command)); });
}

TEST(LessonText, MarksMakeSpans) {
  const Paragraph p = parse_paragraph("See *this* and `T(0,1)`, press {S} or [step](step 2).");
  ASSERT_EQ(p.size(), 9u);
  EXPECT_EQ(p[1].kind, TextSpan::Kind::Emphasis);
  EXPECT_EQ(p[3].kind, TextSpan::Kind::Code);
  EXPECT_EQ(p[5].kind, TextSpan::Kind::Key);
  EXPECT_EQ(p[7].kind, TextSpan::Kind::Link);
  EXPECT_EQ(p[7].line, "step 2");
  EXPECT_EQ(plain_text(p), "See this and T(0,1), press S or step.");
}

TEST(LessonText, WhatIsNotClosedOrNoCommandIsNamed) {
  EXPECT_EQ(message([] { static_cast<void>(parse_paragraph("a *b")); }),
            "an emphasis is not closed");
  EXPECT_EQ(message([] { static_cast<void>(parse_paragraph("a {}")); }), "a key is empty");
  EXPECT_EQ(message([] { static_cast<void>(parse_paragraph("[go] there")); }),
            "the link 'go' has no (command)");
  EXPECT_EQ(message([] { static_cast<void>(parse_paragraph("[go](stride 2)", is_command)); }),
            "there is no command 'stride 2'");
}

TEST(LessonFile, HasPagesWithTextCommandsAndTasks) {
  const Lesson lesson =
      parse_lesson("07-some-name.lesson", head +
                                              "@mesh one.off\nOFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 "
                                              "1 2\n@page First\nOne line\nand more.\n\nA second.\n"
                                              "@do\n# why\nlesson mesh one.off\n\n@task\nDo it.\n"
                                              "@hint\nSo.\n@check It is done\nexpect faces = 1\n"
                                              "@check And that\nexpect edges = 3\n@solution\nstep\n"
                                              "@page Last\nText.\n");
  EXPECT_EQ(lesson.name, "some-name");
  EXPECT_EQ(lesson.title, "A title");
  EXPECT_EQ(lesson.about, "One line");
  EXPECT_EQ(lesson.minutes, 3);
  ASSERT_EQ(lesson.meshes.count("one.off"), 1u);
  EXPECT_EQ(lesson.meshes.at("one.off")->faces.size(), 1u);
  ASSERT_EQ(lesson.pages.size(), 2u);
  const LessonPage& page = lesson.pages[0];
  ASSERT_EQ(page.text.size(), 2u);
  EXPECT_EQ(plain_text(page.text[0]), "One line and more.");
  ASSERT_EQ(page.commands.size(), 1u);
  EXPECT_EQ(page.commands[0].text, "lesson mesh one.off");
  EXPECT_EQ(page.commands[0].number, 18u);
  ASSERT_EQ(page.checks.size(), 2u);
  EXPECT_EQ(page.checks[1].expectations[0].text, "expect edges = 3");
  EXPECT_EQ(plain_text(page.hint), "So.");
  EXPECT_TRUE(lesson.pages[1].checks.empty());
}

TEST(LessonFile, ErrorsNameFileAndLine) {
  const std::string page = head + "@page P\nText.\n";
  EXPECT_EQ(error_of("@do\n"), "01-x.lesson:1: @do stands before the first @page");
  EXPECT_EQ(error_of(head + "text\n"), "01-x.lesson:4: this line belongs to no page");
  EXPECT_EQ(error_of("@minutes many\n"),
            "01-x.lesson:1: 'many' is not a number of minutes from 1 to 60");
  EXPECT_EQ(error_of("@lesson\n"), "01-x.lesson:1: @lesson says nothing");
  EXPECT_EQ(error_of(head), "01-x.lesson:4: there is no @page");
  EXPECT_EQ(error_of("@about x\n@minutes 1\n@page P\nText.\n"),
            "01-x.lesson:5: there is no @lesson");
  EXPECT_EQ(error_of(page + "@lesson again\n"),
            "01-x.lesson:6: @lesson stands above the first @page");
  EXPECT_EQ(error_of(page + "@do now\n"), "01-x.lesson:6: nothing may follow @do");
  EXPECT_EQ(error_of(page + "@do\nstride\n"), "01-x.lesson:7: there is no command 'stride'");
  EXPECT_EQ(error_of(page + "More *text\nin two lines\n"),
            "01-x.lesson:5: an emphasis is not closed");
  EXPECT_EQ(error_of(page + "@check C\nstep\n"), "01-x.lesson:7: a check consists of expect lines");
  EXPECT_EQ(error_of(page + "@check\n"), "01-x.lesson:6: @check has no label");
  EXPECT_EQ(error_of(page + "@hint\nOne.\n\nTwo.\n"), "01-x.lesson:9: a hint is one paragraph");
  EXPECT_EQ(error_of(page + "@task\nDo.\n"),
            "01-x.lesson:8: the page 'P' has a task without checks, or checks without a task");
  EXPECT_EQ(
      error_of(page + "@task\nDo.\n@check C\nexpect faces = 1\n"),
      "01-x.lesson:10: the page 'P' has checks without a solution, or a solution without checks");
  EXPECT_EQ(error_of(page + "@task\nDo.\n@check C\n@solution\nstep\n"),
            "01-x.lesson:11: the page 'P' has a check that expects nothing");
  EXPECT_EQ(error_of(head + "@page Empty\n@do\nstep\n"),
            "01-x.lesson:7: the page 'Empty' has no text");
  EXPECT_EQ(error_of(page + "@pages\n"),
            "01-x.lesson:6: '@pages' is none of @lesson, @about, @minutes, @mesh, @page, @do, "
            "@task, @hint, "
            "@check, @solution");
}

TEST(LessonFile, MeshesAreReadAtOnce) {
  EXPECT_EQ(error_of(head + "@mesh\n"), "01-x.lesson:4: @mesh has no name");
  const std::string bad =
      error_of(head + "@mesh m.off\nOFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n@page P\n");
  EXPECT_EQ(bad.rfind("01-x.lesson:4: m.off:", 0), 0u) << bad;
  const std::string two = "@mesh m.off\nOFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  EXPECT_EQ(error_of(head + two + two), "01-x.lesson:11: there is a mesh m.off already");
  EXPECT_EQ(error_of(head + "@mesh m.off\nOFF\n1 0 0\n0 0 0\n@page P\nText.\n"),
            "01-x.lesson:4: the mesh m.off has no faces or regions");
}

/// Any text is a lesson or a file error, whatever is cut out of it or put in.
TEST(LessonFile, DamageIsAnErrorAndNothingWorse) {
  std::string sound =
      head +
      "@mesh one.off\nOFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n@page A *b* {c}\nSee [x](step) "
      "`y`.\n@do\nstep\n@task\nT.\n@hint\nH.\n@check C\nexpect faces = 1\n@solution\nstep\n";
  ASSERT_NO_THROW(static_cast<void>(parse_lesson("s.lesson", sound, is_command)));
  std::mt19937 random(7);
  const std::string_view signs = "@*`{}[]()\n\r 0A\xff";
  for (int round = 0; round < 4000; ++round) {
    std::string text = sound;
    for (int edits = 0; edits < 3; ++edits) {
      const std::size_t at = random() % text.size();
      if (random() % 2 == 0)
        text.erase(at, random() % 6);
      else
        text.insert(at, 1, signs[random() % signs.size()]);
    }
    try {
      static_cast<void>(parse_lesson("s.lesson", text, is_command));
    } catch (const io::FileError& error) {
      EXPECT_EQ(std::string_view(error.what()).rfind("s.lesson:", 0), 0u) << error.what();
    }
  }
}

}  // namespace
}  // namespace aomd::scene::lesson_test
