// Thousands of damaged small files through every reader: no crash, no hang, no large allocation. The
// mutations are the same on every run.

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

#include "core/io/io.h"
#include "core/samples/numeric.h"
#include "core/samples/samples.h"
#include "tests/fuzz/counted_new.h"
#include "tests/io_helpers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace aomd {
namespace {

constexpr std::size_t largest_allocation = 64u << 20;

class Random {
 public:
  std::uint64_t below(std::uint64_t n) {
    return static_cast<std::uint64_t>((sample::hashed(state_++) + 1) / 2 * static_cast<double>(n));
  }

 private:
  std::uint64_t state_ = 0;
};

std::vector<std::string> seeds() {
  const test::TemporaryFolder folder;
  std::vector<std::string> files;
  for (const auto& [name, binary] : {std::pair{"a.ply", false},
                                     {"a.ply", true},
                                     {"a.obj", false},
                                     {"a.off", false},
                                     {"a.off", true},
                                     {"a.stl", false},
                                     {"a.stl", true}}) {
    io::write(folder / name, make_sample("box", 1), {.binary = binary});
    files.push_back(test::bytes_of(folder / name));
  }
  files.emplace_back("OFF\n6 1 0\n0 0 0\n2 0 0\n2 2 0\n1 1 0\n0 2 0\n0 1 0\n6 0 1 2 3 4 5\n");
  files.emplace_back(
      "mtllib m\ng a b\nusemtl x\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nf 1/1/1 2//2 3/3 -1\nl 1 2 "
      "3\nt x 9/9/9\n");
  files.emplace_back(
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n5 "
      "0 1 2 -1 3\n");
  return files;
}

/// Pieces that tend to hurt.
const std::string tokens[] = {"4294967295",
                              "-1",
                              "99999999999999999999",
                              "nan",
                              "1e999",
                              "\n",
                              " ",
                              "\\\n",
                              "#",
                              std::string(4, '\xff'),
                              std::string(4, '\0'),
                              "\x7f\xff\xff\xff",
                              "list",
                              "OFF BINARY\n",
                              "ply\n"};

std::string mutated(std::string bytes, Random& random) {
  for (std::uint64_t edits = 1 + random.below(4); edits > 0 && !bytes.empty(); --edits) {
    const std::size_t at = random.below(bytes.size());
    const std::size_t length = std::min<std::size_t>(random.below(16), bytes.size() - at);
    switch (random.below(6)) {
      case 0:
        bytes[at] = static_cast<char>(random.below(256));
        break;
      case 1:
        bytes.resize(at);
        break;
      case 2:
        bytes.insert(at, tokens[random.below(std::size(tokens))]);
        break;
      case 3:
        bytes.erase(at, length);
        break;
      case 4:
        bytes.insert(random.below(bytes.size()), bytes.substr(at, length));
        break;
      default:
        bytes.replace(at, std::min<std::size_t>(4, bytes.size() - at),
                      tokens[random.below(std::size(tokens))]);
        break;
    }
  }
  return bytes;
}

TEST(Fuzz, DamagedFilesAreRefusedOrRead) {
  const std::vector<std::string> files = seeds();
  Random random;
  const auto start = std::chrono::steady_clock::now();
  for (int round = 0; round < 20'000; ++round) {
    const std::string file =
        static_cast<char>(random.below(5)) + mutated(files[random.below(files.size())], random);
    const std::size_t before = test::live_bytes;
    test::peak_bytes = before;
    const auto begin = std::chrono::steady_clock::now();
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(file.data()), file.size());
    EXPECT_LT(test::peak_bytes - before, largest_allocation) << "round " << round;
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2)) << "round " << round;
  }
  RecordProperty(
      "seconds",
      std::to_string(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()));
}

TEST(Fuzz, EveryPrefixIsRefusedOrRead) {
  for (const std::string& file : seeds()) {
    for (std::size_t size = 0; size <= file.size(); ++size) {
      const std::string prefix = '\4' + file.substr(0, size);
      LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(prefix.data()), prefix.size());
    }
  }
}

}  // namespace
}  // namespace aomd
