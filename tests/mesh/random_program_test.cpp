// Random programs of a million operations: the database answers what its plain model answers,
// whatever T stores, and history takes it back and forth.

#include <gtest/gtest.h>

#include <csignal>
#include <cstdio>

#include "core/samples/samples.h"
#include "tests/support/program.h"
#include "tests/support/zoo.h"

namespace aomd::random_program_test {
namespace {

using oracle::Liberties;
using oracle::Program;
using oracle::Twin;

#ifdef __SANITIZE_ADDRESS__
constexpr int effort = 1;
#else
constexpr int effort = 50;
#endif

struct Subject {
  zoo::Animal animal;
  bool regions;
};

std::vector<Subject> subjects() {
  std::vector<Subject> list;
  list.push_back({{"nothing", MeshData()}, true});
  for (zoo::Animal& animal : zoo::all()) list.push_back({std::move(animal), false});
  list.push_back({{"tetrahedron to be filled", zoo::tetrahedron()}, true});
  for (zoo::Animal& animal : zoo::volumes()) list.push_back({std::move(animal), true});
  for (const char* name : {"tet-box", "hex-box", "mixed", "tet-drilled", "tet-ball"})
    list.push_back({{name, make_sample(name, 2)}, true});
  for (const char* name : {"plane-hole", "nonmanifold"})
    list.push_back({{name, make_sample(name, 4)}, false});
  return list;
}

// Where the running program is, for AOMD_CHECK ends the process.
std::string running;
int running_operation = 0;

void say_where(int signal) {
  std::signal(signal, SIG_DFL);
  std::fprintf(stderr, "%s, operation %d: aborted\n", running.c_str(), running_operation);
  std::raise(signal);
}

/// Runs a program; a failure names the operation that it can be stopped before.
void run(Twin& twin, Program& program, int operations, int check_every, const std::string& label) {
  running = label;
  for (const int signal : {SIGABRT, SIGSEGV}) std::signal(signal, say_where);
  for (int i = 0; i < operations; ++i) {
    running_operation = i;
    try {
      program.operation();
      if (i % check_every == 0) twin.check_all();
    } catch (const std::exception& error) {
      FAIL() << label << ", operation " << i << ": " << error.what();
    }
  }
}

TEST(RandomProgramTest, TheDatabaseAnswersWhatThePlainModelAnswers) {
  // Many short programs, for a mesh edited at random soon looks like no mesh.
  long total = 0;
  for (const Subject& subject : subjects())
    for (std::uint64_t seed = 0; seed < 16; ++seed) {
      const std::string label = subject.animal.name + ", seed " + std::to_string(seed);
      const int operations = (subject.animal.data.positions.size() < 14 ? 70 : 28) * effort;
      Twin twin(subject.animal.data);
      Program program(twin, seed, {true, true, true, subject.regions});
      run(twin, program, operations, 400, label);
      if (HasFatalFailure()) return;
      ASSERT_NO_THROW(twin.check_all()) << label;
      total += operations;
    }
  std::printf("%ld operations\n", total);
  EXPECT_GE(total, effort > 1 ? 1'000'000 : 0);
}

/// What T stores, as one bit a relation; all levels are complete under each.
struct Cells {
  unsigned bits;
  void apply(Mesh& mesh) const {
    for (int j = 1; j <= 3; ++j) mesh.set(0, j);
    for (unsigned cell = 0; cell < 16; ++cell)
      if (bits >> cell & 1u && cell / 4 != cell % 4)
        mesh.set(static_cast<int>(cell / 4), static_cast<int>(cell % 4));
    for (unsigned cell = 0; cell < 16; ++cell)
      if (!(bits >> cell & 1u) && cell / 4 != cell % 4) try {
          mesh.unset(static_cast<int>(cell / 4), static_cast<int>(cell % 4));
        } catch (const std::logic_error&) {  // one has to stay
        }
  }
};

std::vector<Cells> representations() {
  std::vector<Cells> list{{0u}, {0xffffu}};
  std::mt19937_64 random(4711);
  while (list.size() < 24) list.push_back({static_cast<unsigned>(random() & 0xffffu)});
  return list;
}

std::vector<Subject> some_of_each_kind() {
  return {{{"torus", zoo::torus(6, 5)}, false},
          {{"dirty", zoo::dirty()}, false},
          {{"tet-box", make_sample("tet-box", 2)}, true},
          {{"mixed", make_sample("mixed", 2)}, true},
          {{"fan", zoo::fan()}, true},
          {{"glued", zoo::glued()}, true}};
}

TEST(RandomProgramTest, TheSameEditsGiveTheSameMeshUnderEveryRepresentation) {
  for (const Subject& subject : some_of_each_kind()) {
    std::string expected;
    for (const Cells& cells : representations()) {
      const std::string label = subject.animal.name + ", T " + std::to_string(cells.bits);
      Twin twin(subject.animal.data, [&](Mesh& mesh) { cells.apply(mesh); });
      Program program(twin, 17, {false, false, false, subject.regions});
      run(twin, program, 12 * effort, 100, label);
      if (HasFatalFailure()) return;
      if (expected.empty()) expected = zoo::fingerprint(twin.mesh());
      ASSERT_EQ(zoo::fingerprint(twin.mesh()), expected) << label;
    }
  }
}

TEST(RandomProgramTest, AllBackIsTheStartAndAllForwardTheEnd) {
  for (const Subject& subject : some_of_each_kind())
    for (const Cells& cells : representations()) {
      const std::string label = subject.animal.name + ", T " + std::to_string(cells.bits);
      Twin twin(subject.animal.data, [&](Mesh& mesh) { cells.apply(mesh); });
      const std::string start = zoo::fingerprint(twin.mesh());
      twin.attach();
      Program program(twin, 99, {false, false, false, subject.regions});
      run(twin, program, 4 * effort, 1000, label);
      if (HasFatalFailure()) return;
      const std::string end = zoo::fingerprint(twin.mesh());
      for (const bool forward : {false, true, false}) {
        twin.seek(twin.journal().size() / 2);
        ASSERT_NO_THROW(twin.check_all()) << label;
        twin.seek(forward ? twin.journal().size() : 0);
        ASSERT_NO_THROW(twin.check_all()) << label;
        ASSERT_EQ(zoo::fingerprint(twin.mesh()), forward ? end : start) << label;
      }
    }
}

}  // namespace
}  // namespace aomd::random_program_test
