// Nothing that was done is lost: branches, bookmarks, and that going back and forth changes no bit.

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <map>
#include <random>
#include <set>

#include "core/io/journal_file.h"
#include "core/mesh/verify.h"
#include "tests/support/session_helpers.h"
#include "tests/support/zoo.h"
#include "viewer/drawing/step_before.h"

namespace aomd::scene::branches_test {
namespace {

using test::drive;
using test::labels;

std::size_t cursor(const Session& s) { return s.document().journal().cursor(); }
std::size_t size(const Session& s) { return s.document().journal().size(); }
std::uint64_t hash(const Session& s) { return io::fingerprint(s.document().mesh()).hash; }

TEST(Branches, WhatWasAheadIsKeptAndComesBackBitByBit) {
  Session s;
  drive(s, {"sample sphere 12", "step 6", "step 4"});
  const std::uint64_t first = hash(s);
  const auto first_labels = labels(s.document());
  drive(s, {"seek 8", "angle 30", "swap", "expect branches = 1"});
  const std::uint64_t second = hash(s);
  const auto second_labels = labels(s.document());
  const std::size_t second_size = size(s);
  EXPECT_EQ(s.document().tree().present(), 2u);
  EXPECT_EQ(s.document().tree().find(1)->fork, 8u);
  EXPECT_EQ(s.document().tree().find(1)->part.steps.size(), 2u);
  drive(s, {"branch switch 1"});
  EXPECT_EQ(hash(s), first);
  EXPECT_EQ(size(s), 10u);
  EXPECT_EQ(labels(s.document()), first_labels);
  drive(s, {"branch switch 2"});
  EXPECT_EQ(hash(s), second);
  EXPECT_EQ(size(s), second_size);
  EXPECT_EQ(labels(s.document()), second_labels);
  EXPECT_TRUE(verify(s.document().mesh()).empty());
}

TEST(Branches, OfBranchesKnowWhatTheyLeave) {
  Session s;
  drive(s, {"sample sphere 12", "step 10", "seek 7", "factor 6", "smooth", "seek 3", "swap"});
  const HistoryTree& tree = s.document().tree();
  ASSERT_EQ(tree.branches().size(), 2u);
  EXPECT_EQ(tree.find(1)->from, 2u);  // it leaves at 7, which the present one has no longer
  EXPECT_EQ(tree.find(2)->from, 0u);
  drive(s, {"branch switch 1"});
  EXPECT_EQ(cursor(s), 10u);
  EXPECT_EQ(tree.find(2)->from, 0u);
  EXPECT_EQ(tree.find(2)->fork, 7u);
  EXPECT_EQ(tree.find(3)->fork, 3u);
  drive(s, {"branch remove 3", "expect branches = 1"});
  EXPECT_THROW(execute(s, "branch switch 3"), CommandError);
  EXPECT_THROW(execute(s, "branch remove 1"), CommandError);
}

TEST(Branches, ACommandThatDoesNothingMakesNone) {
  Session s;
  drive(s, {"sample sphere 12", "improve-passes 0", "factor 8", "step 4", "undo", "factor 1",
            "step", "expect branches = 0"});
  EXPECT_EQ(size(s), 4u);
}

TEST(Branches, ARunFromThePastKeepsWhatWasAhead) {
  Session s;
  drive(s, {"sample sphere 12", "step 10"});
  const std::uint64_t first = hash(s);
  drive(s, {"seek 5", "angle 25"});
  execute(s, "run");
  s.document().tick(std::chrono::microseconds(1));
  EXPECT_EQ(s.document().tree().branches().size(), 1u);
  drive(s, {"wait-idle", "branch switch 1"});
  EXPECT_EQ(hash(s), first);
}

TEST(Branches, TheSavedPlaceGoesWithItsBranch) {
  const std::string file = std::filesystem::temp_directory_path() / "aomd_branches_test.ply";
  Session s;
  drive(s, {"sample sphere 8", "step 9", "save " + file});
  EXPECT_FALSE(s.document().unsaved());
  drive(s, {"seek 4", "smooth"});
  EXPECT_TRUE(s.document().unsaved());
  drive(s, {"branch switch 1"});
  EXPECT_FALSE(s.document().unsaved());
  std::filesystem::remove(file);
}

TEST(Bookmarks, StayWithTheirBranch) {
  Session s;
  drive(s, {"sample sphere 12", "step 10", "bookmark the end", "seek 4", "bookmark early", "seek 6",
            "swap", "undo", "expect bookmarks = 2"});
  EXPECT_EQ(s.document().tree().find_bookmark("the end")->branch, 1u);
  EXPECT_EQ(s.document().tree().find_bookmark("early")->branch, 0u);
  drive(s, {"seek bookmark the end"});
  EXPECT_EQ(cursor(s), 10u);
  EXPECT_EQ(s.document().tree().present(), 1u);
  drive(s, {"seek bookmark early"});
  EXPECT_EQ(cursor(s), 4u);
  drive(s, {"bookmark", "bookmark early", "bookmark remove early", "expect bookmarks = 2"});
  EXPECT_THROW(execute(s, "seek bookmark early"), CommandError);
  EXPECT_THROW(execute(s, "bookmark remove early"), CommandError);
  drive(s, {"seek bookmark Place 3"});
  EXPECT_EQ(cursor(s), 4u);
}

/// Whatever is done in whatever order: each place that was seen once looks the same ever after, the
/// drawing follows, and the way to each branch's end, made anew, ends there too.
TEST(Branches, RandomProgramsLoseNothing) {
  const std::vector<std::string> edits = {"step", "step 7", "sweep",
                                          "swap", "smooth", "feature-angle 30"};
  for (unsigned seed = 1; seed <= 12; ++seed) {
    std::mt19937 random(seed);
    const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
    Session s;
    drive(s, {seed % 2 == 0 ? "sample sphere 6" : "sample bracket 4", "strategy paper"});
    std::map<std::pair<unsigned, std::size_t>, std::uint64_t> seen;  // ends of branches
    std::map<std::string, std::uint64_t> marked;
    for (int i = 0; i < 40; ++i) {
      const auto choice = below(10);
      if (choice < 3) drive(s, {edits[below(edits.size())]});
      if (choice == 3) drive(s, {"undo"});
      if (choice >= 4 && choice < 7) drive(s, {"seek " + std::to_string(below(size(s) + 1))});
      if (choice == 7) {
        const std::string name = "m" + std::to_string(i);
        drive(s, {"bookmark " + name});
        marked[name] = hash(s);
      }
      if (const auto& all = s.document().tree().branches(); choice == 8 && !all.empty()) {
        drive(s, {"branch switch " + std::to_string(all[below(all.size())].id)});
        const auto known = seen.find({s.document().tree().present(), size(s)});
        if (known != seen.end()) {
          EXPECT_EQ(hash(s), known->second) << seed << " " << i;
        }
      }
      if (choice == 9 && !marked.empty()) {
        const auto at =
            std::next(marked.begin(), static_cast<std::ptrdiff_t>(below(marked.size())));
        drive(s, {"seek bookmark " + at->first});
        EXPECT_EQ(hash(s), at->second) << seed << " " << i;
      }
      if (cursor(s) == size(s)) seen[{s.document().tree().present(), size(s)}] = hash(s);
      ASSERT_TRUE(verify(s.document().mesh()).empty()) << seed << " " << i;
      for (const HistoryBranch& b : s.document().tree().branches())
        ASSERT_GT(b.part.steps.size(), 0u);
    }
    // The present way, replayed on a fresh mesh, comes to the same bits.
    drive(s, {"seek end"});
    Session fresh;
    drive(fresh, {seed % 2 == 0 ? "sample sphere 6" : "sample bracket 4"});
    Mesh mesh(to_data(fresh.document().mesh()));
    const std::array needs = {mesh.request(2, 0), mesh.request(0, 1), mesh.request(0, 2)};
    Journal replay;
    const auto words = s.document().journal().words();
    const auto steps = s.document().journal().steps();
    replay.restore({words.begin(), words.end()}, {steps.begin(), steps.end()});
    replay.seek(mesh, replay.size());
    EXPECT_EQ(io::fingerprint(mesh).hash, hash(s)) << seed;
  }
}

TEST(StepBefore, OfEveryOperationIsWhatUndoBringsBack) {
  Session s;
  drive(s, {"sample bracket 4", "strategy paper", "run", "seek 0"});
  std::map<StepKind, int> kinds;
  for (std::size_t i = 0; i < size(s); ++i) {
    std::map<std::uint32_t, std::array<glm::dvec3, 3>> faces;
    const Mesh& mesh = s.document().mesh();
    for (const Face f : mesh.faces())
      for (std::size_t k = 0; k < 3; ++k) faces[f.index][k] = mesh.position(mesh.triangle(f)[k]);
    s.document().seek(i + 1);
    // The faces that are gone or look different now.
    std::set<std::array<std::array<double, 3>, 3>> expected, found;
    const auto plain = [](const std::array<glm::dvec3, 3>& t) {
      std::array<std::array<double, 3>, 3> p;
      for (std::size_t k = 0; k < 3; ++k) p[k] = {t[k].x, t[k].y, t[k].z};
      return p;
    };
    for (const auto& [id, before] : faces) {
      std::array<glm::dvec3, 3> now{};
      if (mesh.alive(Face(id)))
        for (std::size_t k = 0; k < 3; ++k) now[k] = mesh.position(mesh.triangle(Face(id))[k]);
      if (!mesh.alive(Face(id)) || now != before) expected.insert(plain(before));
    }
    const StepBefore before = step_before(mesh, s.document().journal(), i);
    for (const auto& t : before.faces)
      found.insert(plain(
          {before.position(mesh, t[0]), before.position(mesh, t[1]), before.position(mesh, t[2])}));
    if (s.document().journal().step(i).kind != StepKind::Classify) {
      EXPECT_EQ(found, expected) << step_name(s.document().journal().step(i).kind) << " " << i;
      ++kinds[s.document().journal().step(i).kind];
    }
  }
  EXPECT_GT(kinds[StepKind::Collapse], 3);
  EXPECT_GT(kinds[StepKind::Smooth], 3);
}

}  // namespace
}  // namespace aomd::scene::branches_test
