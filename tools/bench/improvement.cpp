// aomd-improvement-bench FILE [ROUNDS]: what passes of swaps and moves make of the tetrahedra of a
// file, with CPU times. Nothing is written.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <map>
#include <numbers>
#include <vector>

#include "core/decimate/volume/improvement.h"
#include "core/io/io.h"
#include "core/mesh/tet_geometry.h"
#include "core/model/classify.h"

namespace {

using namespace aomd;

using Volumes = std::map<ModelRef, double>;

double now() { return double(std::clock()) / CLOCKS_PER_SEC; }

Volumes volumes_of(const Mesh& mesh) {
  Volumes six;
  for (const Region r : mesh.regions()) {
    const auto t = mesh.tetrahedron(r);
    six[mesh.classification(r)] += six_volumes(mesh.position(t[0]), mesh.position(t[1]),
                                               mesh.position(t[2]), mesh.position(t[3]));
  }
  return six;
}

// The largest change of a model region's volume, in %.
double largest_change(const Volumes& before, const Volumes& now) {
  double largest = 0;
  for (const auto& [region, volume] : before)
    largest = std::max(largest, 100 * std::abs(now.at(region) / volume - 1));
  return largest;
}

void print_row(const Mesh& mesh, const char* pass, std::uint32_t made, double seconds) {
  std::vector<double> angles;
  double worst_shape = 1;
  for (const Region r : mesh.regions()) {
    const auto t = mesh.tetrahedron(r);
    const auto at = [&](std::size_t k) { return mesh.position(t[k]); };
    worst_shape = std::min(worst_shape, tet_shape(at(0), at(1), at(2), at(3)));
    angles.push_back(std::acos(smallest_dihedral_cosine(at(0), at(1), at(2), at(3))) * 180 /
                     std::numbers::pi);
  }
  std::sort(angles.begin(), angles.end());
  double sum = 0;
  for (const double a : angles) sum += a;
  const auto below = [&](double limit) {
    return 100.0 * double(std::lower_bound(angles.begin(), angles.end(), limit) - angles.begin()) /
           double(angles.size());
  };
  std::printf("%-14s %8u %8u  %6.2f / %5.2f / %5.2f  %7.3f  %7.4f  %8.3f  %6.2f\n", pass,
              mesh.count(3), made, angles[0], angles[angles.size() / 20],
              sum / double(angles.size()), below(10), worst_shape, seconds,
              1e6 * seconds / double(angles.size()));
}

template <typename Pass>
std::uint32_t timed(const Mesh& mesh, const char* name, Pass&& pass) {
  const double start = now();
  const std::uint32_t made = pass();
  print_row(mesh, name, made, now() - start);
  return made;
}

void run(const char* file, int rounds) {
  Mesh mesh(io::read(file).mesh);
  classify(mesh);
  mesh.keep_model_faces_only();
  mesh.keep_model_edges_only();
  const Request balls = mesh.request(0, 3), faces = mesh.request_listed(0, 2),
                edges = mesh.request_listed(0, 1);
  const Volumes volumes = volumes_of(mesh);
  ImprovementWatch nobody;
  VolumeImprovement improvement(mesh, {}, nobody);
  std::printf(
      "pass               tets     made  dihedral min / p5 / mean  < 10 %%  worst q   seconds  "
      "us/tet\n");
  print_row(mesh, "input", 0, 0);
  for (int i = 0; i < rounds; ++i) {
    timed(mesh, "swaps", [&] { return improvement.swap_pass(); });
    timed(mesh, "moves", [&] { return improvement.smooth_pass(); });
  }
  timed(mesh, "mend below 0.3", [&] { return improvement.mend(0.3); });
  std::printf("largest change of a region's volume: %.2g %%\n",
              largest_change(volumes, volumes_of(mesh)));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: aomd-improvement-bench FILE [ROUNDS]\n");
    return 2;
  }
  try {
    run(argv[1], argc > 2 ? std::max(1, std::atoi(argv[2])) : 3);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "aomd-improvement-bench: %s\n", error.what());
    return 3;
  }
}
