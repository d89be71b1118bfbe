// Reads a surface, classifies, decimates, verifies and measures it, writes the result and reads
// that back. Exit code 0 where all of it comes out as it must.

#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

#include "core/decimate/decimation.h"
#include "core/io/io.h"
#include "core/measure/distance.h"
#include "core/measure/intersections.h"
#include "core/measure/normals.h"
#include "core/measure/statistics.h"
#include "core/mesh/derive.h"
#include "core/mesh/geometry.h"
#include "core/mesh/journal.h"
#include "core/mesh/mesh.h"
#include "core/mesh/verify.h"
#include "core/model/analytic_model.h"
#include "core/model/classify.h"
#include "core/model/discrete_model.h"
#include "core/model/gmsh_model.h"
#include "core/model/model.h"
#include "core/paper/paper.h"

namespace {

void expect(bool holds, const char* what) {
  if (!holds) throw std::runtime_error(what);
}

// The six sides of a cube, each cut into n by n squares of two triangles; rims are not shared.
void write_box(const std::filesystem::path& file, int n) {
  std::ofstream out(file);
  out << "OFF\n" << 6 * (n + 1) * (n + 1) << ' ' << 12 * n * n << " 0\n";
  for (int side = 0; side < 6; ++side)
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) {
        int at[3];
        at[side % 3] = side < 3 ? n : 0;
        at[(side + 1) % 3] = side < 3 ? i : j;
        at[(side + 2) % 3] = side < 3 ? j : i;
        out << at[0] << ' ' << at[1] << ' ' << at[2] << '\n';
      }
  for (int side = 0; side < 6; ++side)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const int a = (side * (n + 1) + i) * (n + 1) + j, b = a + n + 1;
        out << "3 " << a << ' ' << b << ' ' << b + 1 << "\n3 " << a << ' ' << b + 1 << ' ' << a + 1
            << '\n';
      }
}

void run(const std::filesystem::path& folder) {
  using namespace aomd;
  write_box(folder / "box.off", 10);
  const Mesh original(io::read(folder / "box.off").mesh);
  expect(original.count(2) == 1200, "1200 faces are read");

  Mesh mesh(to_data(original));
  const ClassifyResult found = classify(mesh, {.feature_angle_deg = 20});
  expect(found.model_faces == 6 && found.model_edges == 24, "6 sides with 4 borders each");
  Journal journal;
  mesh.attach(&journal);
  Decimation decimation(mesh, {.strategy = Strategy::Quality, .target_faces = 100});
  expect(decimation.run() == Decimation::Stop::Done, "the decimation ends");
  const std::size_t left = mesh.count(2);
  expect(left == 99 || left == 100, "100 faces are left, or one less");
  expect(verify(mesh).empty(), "the result is sound");
  expect(journal.size() > 400, "the journal has every step");

  const auto apart =
      measure::mutual_distance(measure::Surface(original), measure::Surface(mesh), 1000);
  expect(apart.max() < 1e-5, "plane sides stay where they are");
  io::write(folder / "coarse.ply", to_data(mesh));
  expect(io::read(folder / "coarse.ply").mesh.faces.size() == left, "they are read back");
}

}  // namespace

int main(int, char** argv) try {
  run(argv[1]);
  return 0;
} catch (const std::exception& e) {
  std::cerr << "consumer: " << e.what() << '\n';
  return 1;
}
