// How a line is read: comments, quotes, whole numbers; and scripts made of such lines.

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/io_helpers.h"
#include "tests/support/message.h"
#include "tests/support/session_helpers.h"
#include "viewer/commands/arguments.h"
#include "viewer/commands/script.h"

namespace aomd::scene::line_test {
namespace {

using aomd::test::TemporaryFolder;
using test::drive;

std::string refusal(Session& session, const std::string& line) {
  return aomd::test::message([&] { execute(session, line); });
}

TEST(Lines, ANumberOfThingsIsWhole) {
  Session s;
  drive(s, {"sample sphere 8"});
  EXPECT_EQ(refusal(s, "step 0.5"),
            "step: a number of steps is whole: 0.5 is not (usage: step [N])");
  for (const char* line :
       {"step -1.5", "sweep 1.5", "forward 1.5", "sample sphere 8.5", "improve-passes 1.5",
        "target-faces 10.5", "hash-sets build edge 1.5", "export turntable nowhere 2.5",
        "lesson stored 1.5", "seek 1.5", "undo 1.5"})
    EXPECT_THROW(execute(s, line), CommandError) << line;
  EXPECT_EQ(s.document().journal().size(), 0u);
  drive(s, {"step 1e1"});
  EXPECT_EQ(s.document().journal().cursor(), 10u);
}

TEST(Lines, AnIdThatIsTooLargeIsNoOther) {
  Session s;
  drive(s, {"sample sphere 8"});
  EXPECT_THROW(execute(s, "select vertex 4294967296"), CommandError);
  EXPECT_NO_THROW(execute(s, "expect direction 4294967296 0 = gone"));
  EXPECT_NO_THROW(execute(s, "expect alive vertex 4294967296 = off"));
}

TEST(Lines, ACommentBeginsWhereAWordCould) {
  EXPECT_EQ(without_comment("factor 3 # of the mean"), "factor 3 ");
  EXPECT_EQ(without_comment("\t# all of it"), "\t");
  EXPECT_EQ(without_comment("open part#2.ply"), "open part#2.ply");
  EXPECT_EQ(without_comment("open \"part #2.ply\" # the second"), "open \"part #2.ply\" ");
  EXPECT_EQ(without_comment(R"(open "a \" #2.ply" #)"), R"(open "a \" #2.ply" )");
  EXPECT_EQ(without_comment("log 5\" # a"), "log 5\" ");
  EXPECT_EQ(without_comment("log \"a # b"), "log \"a # b");
  Session s;
  drive(s, {"factor 3.5 # longer", "# open nothing", "sample sphere 8 # small", "step # one"});
  EXPECT_EQ(s.document().options().factor, 3.5);
  EXPECT_EQ(s.document().journal().cursor(), 1u);
}

TEST(Lines, QuotesGiveBackEveryText) {
  for (const std::string text : {"", " ", "plain", "two words", "a\"b", "\"a\"", "\\", "\\n",
                                 "a\nb", "# not a comment", "a \\\" b", "ends in \\", "b\xe9"}) {
    const std::string written = in_quotes(text);
    Arguments word("test", "", written);
    EXPECT_EQ(word.word("x"), text);
    EXPECT_TRUE(word.done());
    const std::string line = "command " + written + " # comment";
    EXPECT_EQ(without_comment(line), line.substr(0, line.size() - 9)) << text;
    Arguments rest("test", "", written);
    EXPECT_EQ(rest.rest("x"), text);
  }
  EXPECT_EQ(as_rest("3 * h"), "3 * h");
  EXPECT_EQ(as_rest("a #2"), "\"a #2\"");
  EXPECT_EQ(as_rest("\"a\""), R"("\"a\"")");
  Arguments other("test", "", R"("a" and "b")");
  EXPECT_EQ(other.rest("x"), "a\" and \"b");  // as before there was a way to write a quote
}

TEST(Lines, FilesOfAnyNameAreOpened) {
  const TemporaryFolder folder;
  for (const std::string name : {"a b.ply", "a\"b.ply", "\"ab.ply\".ply", "it's #1.ply",
                                 "b\xe9.ply", " a.ply", "a\\n.ply", "a\nb.ply"}) {
    const std::string file = (folder / "").string() + name;
    Session s;
    drive(s, {"sample sphere 8", "save " + in_quotes(file), "open " + in_quotes(file)});
    EXPECT_EQ(s.document().content().file, file);
  }
}

Script script_of(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
  return Script(file);
}

std::string factor_after(Script script) {
  Session s;
  while (!script.done())
    if (!script.advance(s, [&](const std::string& line) { execute(s, line); })) s.finish();
  return std::to_string(s.document().options().factor);
}

TEST(Script, AByteOrderMarkIsNoPartOfTheFirstLine) {
  const TemporaryFolder folder;
  EXPECT_EQ(factor_after(script_of(folder / "a",
                                   "\xef\xbb\xbf"
                                   "factor 3\r\n")),
            "3.000000");
  EXPECT_EQ(factor_after(script_of(folder / "b", "\xef\xbb\xbf# comment\nfactor 5")), "5.000000");
  EXPECT_EQ(factor_after(script_of(folder / "c", "")), "4.000000");
}

TEST(Script, WhatCannotBeReadToItsEndIsAnError) {
  const TemporaryFolder folder;
  const std::string name = (folder / "").string();
  EXPECT_EQ(aomd::test::message([&] { Script script{folder / ""}; }), name + ": is a folder");
  EXPECT_EQ(aomd::test::message([&] { Script script{folder / "none"}; }),
            name + "none: cannot be read");
  EXPECT_EQ(aomd::test::message([] { Script script{"/proc/self/mem"}; }),
            "/proc/self/mem: cannot be read to its end");
}

}  // namespace
}  // namespace aomd::scene::line_test
