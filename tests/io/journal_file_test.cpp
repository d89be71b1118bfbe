// Journals on disk: what is written reads back; what is damaged is refused before anything is
// applied.

#include <gtest/gtest.h>

#include <random>

#include "core/decimate/decimation.h"
#include "core/io/journal_file.h"
#include "core/samples/samples.h"
#include "tests/support/io_helpers.h"
#include "tests/support/zoo.h"

namespace aomd::test::journal_file_test {
namespace {

/// A torus that was decimated with a journal.
class JournalFileTest : public testing::Test {
 protected:
  JournalFileTest() : data_(make_sample("torus", 16)) {
    file_.classify.feature_angle_deg = {};  // so coarse a torus is all features otherwise
    Mesh mesh = start();
    file_.start = io::fingerprint(mesh);
    mesh.attach(&file_.journal);
    DecimationOptions options;
    options.angle_deg = 60;
    Decimation(mesh, options).run();
    mesh.attach(nullptr);
    result_ = to_data(mesh);
    io::write_journal(path(), file_);
  }

  Mesh start() const {
    Mesh mesh(data_);
    classify(mesh, file_.classify);
    return mesh;
  }
  std::filesystem::path path() const { return folder_ / "journal"; }
  void put(const std::string& bytes) const { io::write_file(path(), bytes); }

  /// Reads, checks and replays; says what was wrong, or "".
  std::string replay(Mesh& mesh) const {
    try {
      io::JournalFile file = io::read_journal(path());
      io::check_journal(file, "journal", mesh);
      file.journal.seek(mesh, file.journal.size());
      return "";
    } catch (const io::ReadError& e) {
      return e.what();
    }
  }

  /// Replaces the checksum by the right one, as someone who means harm would.
  static void seal(std::string& bytes) {
    std::uint64_t state = 0xcbf29ce484222325u;
    for (std::size_t at = 0; at + 4 <= bytes.size(); at += 4) {
      if (at == 80 || at == 84) continue;
      std::uint32_t word = 0;
      std::memcpy(&word, bytes.data() + at, 4);
      state = (state ^ word) * 0x100000001b3u ^ state >> 47;
    }
    state ^= state >> 29;
    std::memcpy(bytes.data() + 80, &state, 8);
  }

  MeshData data_, result_;
  io::JournalFile file_;
  TemporaryFolder folder_;
};

TEST_F(JournalFileTest, ReplaysToTheSameMesh) {
  ASSERT_GT(file_.journal.size(), 20u);
  Mesh mesh = start();
  ASSERT_EQ(replay(mesh), "");
  const MeshData again = to_data(mesh);
  EXPECT_EQ(again.positions, result_.positions);
  EXPECT_EQ(again.faces.vertices, result_.faces.vertices);
  EXPECT_EQ(again.faces.classes, result_.faces.classes);
}

TEST_F(JournalFileTest, KeepsHowTheMeshWasClassified) {
  io::JournalFile file;
  file.classify.feature_angle_deg = {};
  file.classify.corner_angle_deg = 33;
  file.classify.nonmanifold_edges = false;
  io::write_journal(path(), file);
  const io::JournalFile back = io::read_journal(path());
  EXPECT_FALSE(back.classify.feature_angle_deg.has_value());
  EXPECT_EQ(back.classify.corner_angle_deg, 33);
  EXPECT_FALSE(back.classify.nonmanifold_edges);
  EXPECT_TRUE(back.classify.keep_present);
  EXPECT_EQ(back.journal.size(), 0u);
}

TEST_F(JournalFileTest, FingerprintSeesEveryChange) {
  Mesh moved = start();
  moved.move(Vertex(3), moved.position(Vertex(3)) + glm::dvec3(1e-9, 0, 0));
  Mesh reclassified = start();
  reclassified.set_classification(Face(0), ModelRef(2, 77));
  for (Mesh* mesh : {&moved, &reclassified}) {
    EXPECT_NE(io::fingerprint(*mesh), file_.start);
    EXPECT_NE(replay(*mesh).find("another mesh"), std::string::npos);
  }
}

TEST_F(JournalFileTest, EveryTruncationIsRefused) {
  const std::string bytes = bytes_of(path());
  Mesh mesh = start();
  for (std::size_t n = 1; n < bytes.size(); n += n < 200 ? 1 : 997) {
    put(bytes.substr(0, n));
    EXPECT_NE(replay(mesh), "") << n;
  }
  put(bytes + "more");
  EXPECT_NE(replay(mesh), "");
}

TEST_F(JournalFileTest, EveryFlippedBitIsRefused) {
  const std::string bytes = bytes_of(path());
  Mesh mesh = start();
  for (std::size_t bit = 0; bit < bytes.size() * 8; bit += bit < 1600 ? 7 : 9973) {
    std::string broken = bytes;
    broken[bit / 8] = static_cast<char>(broken[bit / 8] ^ (1 << (bit % 8)));
    put(broken);
    EXPECT_NE(replay(mesh), "") << bit;
  }
}

// With a checksum that fits, a record may be anything: whatever happens, the program must not fall
// over.
TEST_F(JournalFileTest, SealedNonsenseDoesNoHarm) {
  const std::string bytes = bytes_of(path());
  std::mt19937 random(5);
  for (int i = 0; i < 400; ++i) {
    std::string broken = bytes;
    for (int k = 0; k <= i % 3; ++k) {
      const std::size_t at = 88 + random() % (bytes.size() - 88);
      broken[at] = static_cast<char>(random());
    }
    seal(broken);
    put(broken);
    Mesh mesh = start();
    (void)replay(mesh);
    (void)to_data(mesh);
  }
}

TEST_F(JournalFileTest, SealIsTheChecksum) {
  std::string bytes = bytes_of(path());
  const std::string before = bytes;
  seal(bytes);
  EXPECT_EQ(bytes, before);
}

TEST_F(JournalFileTest, OtherVersionsAreNamed) {
  std::string bytes = bytes_of(path());
  bytes[8] = 9;
  put(bytes);
  Mesh mesh = start();
  EXPECT_NE(replay(mesh).find("version 9"), std::string::npos);
}

}  // namespace
}  // namespace aomd::test::journal_file_test
