#pragma once
// Runs on several threads, which must come to the same as on one.

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <vector>

#include "core/decimate/decimation.h"
#include "tests/support/quality_helpers.h"
#include "tests/support/zoo.h"

namespace aomd::test {

/// What a run makes of a mesh: the mesh itself, id stacks included, and what the sweeps did.
struct RunResult {
  std::string mesh;
  std::vector<SweepStatistics> sweeps;
  friend bool operator==(const RunResult&, const RunResult&) = default;
};

inline RunResult run(const MeshData& data, const DecimationOptions& options,
                     Edges edges = Edges::OnModelEdges) {
  Mesh mesh = classified(data, edges);
  Decimation decimation(mesh, options);
  decimation.run();
  EXPECT_EQ(finding(mesh), "");
  return {zoo::fingerprint(mesh), decimation.sweeps()};
}

inline void expect_the_same(const zoo::Animal& animal, DecimationOptions options,
                            std::initializer_list<int> threads = {2, 3, 8},
                            Edges edges = Edges::OnModelEdges) {
  options.threads = 1;
  const RunResult one = run(animal.data, options, edges);
  for (const int n : threads) {
    options.threads = n;
    EXPECT_EQ(run(animal.data, options, edges), one)
        << animal.name << " to " << options.target_faces << ", " << n << " threads, regularity "
        << options.regularity;
  }
}

inline DecimationOptions in_parts(std::uint32_t target, int parts, int threads,
                                  double regularity = 0.5) {
  DecimationOptions options = quality(target, regularity);
  options.parts = parts;
  options.threads = threads;
  return options;
}

inline std::vector<zoo::Animal> samples_for_parts() {
  return samples(
      {{"scan", 9000}, {"torus", 90}, {"terrain", 70}, {"nonmanifold", 40}, {"bracket", 6}});
}

}  // namespace aomd::test
