// What commands do to a session: history by whole commands, expectations, and errors that keep the
// mesh.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/io/error.h"
#include "tests/support/session_helpers.h"
#include "tests/support/zoo.h"
#include "viewer/base/text.h"
#include "viewer/commands/arguments.h"
#include "viewer/commands/script.h"

namespace aomd::scene::document_test {
namespace {

using test::drive;

std::size_t cursor(const Session& s) { return s.document().journal().cursor(); }
std::size_t size(const Session& s) { return s.document().journal().size(); }

TEST(Document, UndoAndRedoMoveByWholeCommands) {
  Session s;
  drive(s, {"sample sphere 12", "step", "step 3", "sweep"});
  EXPECT_EQ(s.document().marks().size(), 3u);
  const std::size_t all = size(s);
  ASSERT_GT(all, 5u);
  drive(s, {"undo"});
  EXPECT_EQ(cursor(s), 4u);
  drive(s, {"undo"});
  EXPECT_EQ(cursor(s), 1u);
  drive(s, {"undo", "undo", "undo"});
  EXPECT_EQ(cursor(s), 0u);
  EXPECT_EQ(s.sheet().facts(), s.sheet().loaded_facts());
  drive(s, {"redo", "redo"});
  EXPECT_EQ(cursor(s), 4u);
  drive(s, {"redo"});
  EXPECT_EQ(cursor(s), all);
}

TEST(Document, AfterScrubbingUndoGoesToTheStartOfTheCommandAndRedoToItsEnd) {
  Session s;
  drive(s, {"sample sphere 12", "sweep", "swap"});
  const std::size_t sweep_end = s.document().marks().at(1).begin;
  drive(s, {"seek 5", "redo"});
  EXPECT_EQ(cursor(s), sweep_end);
  drive(s, {"seek 5", "undo"});
  EXPECT_EQ(cursor(s), 0u);
  EXPECT_EQ(s.document().mark_of(sweep_end).label, "swap");
}

TEST(Document, NewWorkAfterUndoCutsWhatWasUndone) {
  Session s;
  drive(s, {"sample sphere 12", "step 10", "undo", "angle 30", "step 2"});
  EXPECT_EQ(size(s), 2u);
  EXPECT_EQ(s.document().marks().size(), 1u);
}

TEST(Document, CommandsThatDoNothingKeepWhatCanBeRedone) {
  Session s;
  drive(s, {"sample sphere 12", "improve-passes 0", "factor 1", "run"});
  drive(s, {"factor 8", "step 4", "undo"});
  const std::size_t before = size(s);
  drive(s, {"factor 1", "step"});
  EXPECT_EQ(size(s), before);
  EXPECT_TRUE(s.document().can_redo());
  drive(s, {"redo"});
  EXPECT_EQ(cursor(s), before);
}

TEST(Document, SingleStepsGoBackAndForth) {
  Session s;
  drive(s, {"sample sphere 12", "step 10", "step -3"});
  EXPECT_EQ(cursor(s), 7u);
  EXPECT_EQ(s.document().focus(), 6u);
  drive(s, {"seek end"});
  EXPECT_EQ(cursor(s), 10u);
  drive(s, {"step -100"});
  EXPECT_EQ(cursor(s), 0u);
  EXPECT_FALSE(s.document().focus());
}

TEST(Document, ARunIsOneCommandAndCanBeResetAndRedone) {
  Session s;
  drive(s, {"sample sphere 12", "run"});
  const MeshFacts after = s.sheet().facts();
  EXPECT_LT(after.faces, s.sheet().loaded_facts().faces);
  EXPECT_EQ(s.document().marks().size(), 1u);
  EXPECT_DOUBLE_EQ(s.document().run_progress(), 1);
  drive(s, {"reset"});
  EXPECT_EQ(s.sheet().facts(), s.sheet().loaded_facts());
  drive(s, {"redo"});
  EXPECT_EQ(s.sheet().facts(), after);
}

TEST(Document, ACancelledRunKeepsWhatItDid) {
  Session s;
  drive(s, {"sample sphere 24"});
  execute(s, "run");
  EXPECT_TRUE(s.document().running());
  s.document().tick(std::chrono::microseconds(1));
  const std::size_t done = cursor(s);
  drive(s, {"cancel"});
  EXPECT_FALSE(s.document().running());
  EXPECT_EQ(cursor(s), done);
  drive(s, {"undo"});
  EXPECT_EQ(cursor(s), 0u);
}

TEST(Document, FeatureAngleIsOneCommandThatCanBeUndone) {
  Session s;
  s.show(make_loaded(zoo::tetrahedron(), "tetrahedron"));
  s.refresh();
  drive(s, {"expect model-faces = 4", "feature-angle off"});
  EXPECT_EQ(s.document().marks().size(), 1u);
  EXPECT_THROW(drive(s, {"expect model-faces = 4"}), ExpectationMissed);
  drive(s, {"expect model-faces = 1", "undo", "expect model-faces = 4"});
}

TEST(Document, WhatTheFileSaysWinsAgainWhenAnglesChange) {
  Session s;
  MeshData data = zoo::square();
  data.faces.classes = {ModelRef(2, 5), ModelRef(2, 9)};
  s.show(make_loaded(data, "two faces"));
  s.refresh();
  EXPECT_TRUE(s.document().content().classified_by_file());
  drive(s, {"feature-angle 1", "expect model-faces = 2", "feature-angle off",
            "expect model-faces = 2"});
  EXPECT_EQ(s.document().mesh().classification(Face(1)), ModelRef(2, 9));
}

TEST(Document, PlayGoesToTheEndAndStartsOverThere) {
  Session s;
  drive(s, {"sample sphere 12", "step 9", "seek 2", "play"});
  EXPECT_EQ(cursor(s), 9u);
  execute(s, "play");
  EXPECT_EQ(cursor(s), 0u);
  s.tick(std::chrono::microseconds(1), 0.5);
  EXPECT_GT(cursor(s), 0u);
  execute(s, "pause");
  EXPECT_TRUE(s.idle());
}

TEST(Adjacency, SettingStoresAndUnsettingFreesUnlessARequestHoldsIt) {
  Session s;
  drive(s, {"sample sphere 8", "expect adjacency 2 1 = off", "adjacency 2 1 on",
            "expect adjacency 2 1 = on"});
  EXPECT_EQ(s.status,
            "T(2,1) is stored: " + bytes_text(s.document().mesh().representation().bytes(2, 1)));
  drive(s, {"adjacency 2 1 off", "expect adjacency 2 1 = off"});
  EXPECT_EQ(s.status, "T(2,1) is freed");
  drive(s, {"adjacency 0 2 on", "adjacency 0 2 off", "expect adjacency 0 2 = on"});
  EXPECT_EQ(s.status, "T(0,2) is no longer set, but 1 request holds it");
  drive(s, {"adjacency 2 1", "expect adjacency 2 1 = on", "adjacency 2 1",
            "expect adjacency 2 1 = off"});
}

TEST(Adjacency, ARefusalIsAValueAndChangesNothing) {
  Session s;
  drive(s, {"sample sphere 8", "adjacency 1 0 on", "step 2"});
  const std::size_t bytes = s.document().mesh().adjacency_bytes();
  drive(s, {"adjacency 1 0 off"});
  ASSERT_NE(s.document().last_adjacency_change(), nullptr);
  EXPECT_EQ(s.document().last_adjacency_change()->refusal, s.status);
  EXPECT_NE(s.status.find("T(1,0) defines the edges"), std::string::npos) << s.status;
  EXPECT_TRUE(adjacency_cell(s.document().mesh(), 1, 0).set);
  EXPECT_EQ(s.document().mesh().adjacency_bytes(), bytes);
  EXPECT_EQ(cursor(s), 2u);
  drive(s, {"sample sphere 8"});
  EXPECT_EQ(s.document().last_adjacency_change(), nullptr);
}

TEST(Adjacency, CellsAndWordsOfASquare) {
  Mesh mesh(zoo::square());
  EXPECT_EQ(adjacency_words(mesh, 1, 2, false),
            "T(1,2): The faces around each edge, sorted.\nNot stored. Storing it creates the "
            "missing edges.");
  {
    const Request need = mesh.request(0, 2, "a test");
    const std::string bytes = bytes_text(mesh.representation().bytes(0, 2));
    EXPECT_EQ(adjacency_words(mesh, 0, 2, false),
              "T(0,2): The faces around each vertex, sorted.\nStored: " + bytes +
                  ", 4 rows of 1.5 on average.\nHeld by: a test.");
    EXPECT_NE(adjacency_words(mesh, 0, 2, true).find(", built in "), std::string::npos);
    const Request again = mesh.request(0, 2, "a test");
    EXPECT_EQ(askers(mesh, 0, 2), "a test (2)");
  }
  EXPECT_EQ(mesh.representation().record(0, 2).builds, 1u);
  EXPECT_NE(adjacency_words(mesh, 0, 2, false).find(" Freed once, last of "), std::string::npos);
  EXPECT_FALSE(adjacency_cell(mesh, 0, 2).stored);
  EXPECT_EQ(adjacency_words(mesh, 2, 0, false),
            "T(2,0): The vertices of each face, in template order.\nStored: 24 B, 2 rows of 3 on "
            "average.\n"
            "Held by: you or its source. It defines the faces: it stays until T(2,1) is stored.");
  static_cast<void>(mesh.request(0, 1));
  const AdjacencyCell ends = adjacency_cell(mesh, 1, 0);
  EXPECT_TRUE(ends.stored && ends.defines && !ends.set && ends.requests == 0 && ends.bytes > 0);
  EXPECT_DOUBLE_EQ(mean_row_length(mesh, 0, 1), 2.5);
}

TEST(Errors, AFileThatCannotBeReadKeepsThePresentMesh) {
  Session s;
  drive(s, {"sample sphere 8", "step 2"});
  execute(s, "open /no/such/file.ply");
  EXPECT_TRUE(s.loading());
  EXPECT_THROW(s.finish(), io::ReadError);
  EXPECT_TRUE(s.idle());
  EXPECT_EQ(s.document().content().name, "sphere");
  EXPECT_EQ(cursor(s), 2u);
}

TEST(Errors, CancelledLoadingIsDropped) {
  Session s;
  drive(s, {"sample sphere 8"});
  execute(s, "sample torus");
  execute(s, "cancel");
  s.finish();
  EXPECT_EQ(s.document().content().name, "sphere");
}

TEST(Errors, WrongCommandsSayWhatWouldBeRight) {
  Session s;
  for (const char* line : {"nonsense", "open", "sample", "sample cow", "step", "factor",
                           "color nonsense", "camera iso"})
    EXPECT_THROW(execute(s, line), CommandError) << line;
  drive(s, {"sample sphere 8"});
  for (const char* line : {"factor x",
                           "factor 0.5",
                           "factor 4 5",
                           "angle 181",
                           "step x",
                           "topology unsafe",
                           "undo 2",
                           "color nonsense",
                           "show ghosts on",
                           "show edges maybe",
                           "highlight face",
                           "hide blob:3",
                           "panel side on",
                           "theme blue",
                           "zoom 0",
                           "screenshot",
                           "screenshot a.png 10y10",
                           "expect faces",
                           "expect faces ~ 3",
                           "expect beauty = 3",
                           "expect faces = many",
                           "adjacency 0",
                           "adjacency 2 2 on",
                           "adjacency 0 4 on",
                           "adjacency 0 2 perhaps",
                           "expect adjacency 0 2 < on",
                           "expect adjacency 0 2 = off",
                           "panel adjacency perhaps"})
    EXPECT_THROW(execute(s, line), CommandError) << line;
  try {
    execute(s, "color nonsense");
  } catch (const CommandError& error) {
    EXPECT_EQ(std::string(error.what()),
              "color: 'nonsense' is none of classification, spacing, quality, distance, curvature, "
              "verdict, texture, none "
              "(usage: color "
              "classification|spacing|quality|distance|curvature|verdict|texture|none)");
  }
}

TEST(Panels, DecimationAndAdjacenciesShareThePanelOnTheRight) {
  Session s;
  const Panels& panels = s.view.panels;
  drive(s, {"panel adjacency on"});
  EXPECT_TRUE(panels.side && panels.page == Page::Adjacency);
  drive(s, {"panel decimation off"});
  EXPECT_TRUE(panels.side);
  drive(s, {"panel decimation toggle"});
  EXPECT_TRUE(panels.side && panels.page == Page::Decimation);
  drive(s, {"panel decimation toggle"});
  EXPECT_FALSE(panels.side);
  drive(s, {"panel adjacency on", "panel all toggle"});
  EXPECT_FALSE(panels.side || panels.mesh || panels.timeline);
  drive(s, {"panel all toggle"});
  EXPECT_TRUE(panels.side && panels.page == Page::Adjacency && panels.mesh && panels.timeline);
}

TEST(Arguments, ReadWordsQuotesNumbersAndModelEntities) {
  Arguments a("test", "", R"( "a b"  face:-3 2.5 on 640x480 "c d.ply" )");
  EXPECT_EQ(a.word("x"), "a b");
  EXPECT_EQ(a.model_entity(), ModelRef(2, -3));
  EXPECT_EQ(a.number("x"), 2.5);
  EXPECT_TRUE(a.flag(false));
  EXPECT_EQ(a.size(), glm::ivec2(640, 480));
  EXPECT_EQ(a.rest("x"), "c d.ply");
  EXPECT_TRUE(a.done());
  EXPECT_EQ(model_entity_text(ModelRef(1, 7)), "edge:7");
}

TEST(Script, NamesTheLineThatMissed) {
  const auto file = std::filesystem::temp_directory_path() / "aomd_script_test.aomd";
  std::ofstream(file) << "# a comment\nsample sphere 8\n\nexpect euler = 2\nexpect faces = 3\n";
  Session s;
  Script script(file);
  try {
    while (!script.done()) {
      script.advance(s, [&](const std::string& line) { execute(s, line); });
      s.finish();
    }
    FAIL();
  } catch (const ScriptError& error) {
    EXPECT_NE(std::string(error.what()).find(file.string() + ":5: expected faces = 3, but it is"),
              std::string::npos)
        << error.what();
  }
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace aomd::scene::document_test
