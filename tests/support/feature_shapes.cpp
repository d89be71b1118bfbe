#include "tests/support/feature_shapes.h"

#include "tests/support/shape_builder.h"

namespace aomd::test {
namespace {

using Shapes = std::vector<FeatureShape>;

std::string times(int n, int m) { return std::to_string(n) + " x " + std::to_string(m); }

MeshData scaled(const MeshData& mesh, Vector by) {
  return moved(mesh, [by](Vector p) { return p * by; });
}

MeshData torus(int sides, int around, double radius) {
  Profile ring = arc(2, 0, radius, 0, 360, around);
  ring.pop_back();
  return revolved(ring, sides, {1}, true);
}

MeshData egg() {
  return moved(sphere(12, 10), [](Vector p) {
    const double slim = 1 - 0.3 * p.z;
    return Vector(p.x * slim, p.y * slim, 1.4 * p.z);
  });
}

MeshData row_of_spheres() {
  std::vector<MeshData> all;
  for (int i = 0; i < 8; ++i)
    all.push_back(
        moved(sphere(12, 8), [i](Vector p) { return (1 + 0.1 * i) * p + Vector(3.0 * i, 0, 0); }));
  return together(all);
}

// All edges are steps.
void add_rounds(Shapes& all) {
  for (const auto& [n, m] : {std::pair{8, 4},
                             {8, 6},
                             {12, 6},
                             {12, 12},
                             {16, 8},
                             {16, 16},
                             {24, 12},
                             {32, 16},
                             {64, 32},
                             {12, 40},
                             {40, 8}})
    all.push_back({"sphere " + times(n, m), sphere(n, m)});
  for (const int levels : {1, 2, 3})
    all.push_back({"icosphere " + std::to_string(levels), icosphere(levels)});
  all.push_back({"icosahedron", icosahedron(true)});
  for (const auto& [n, m] : {std::pair{12, 8}, {16, 12}, {10, 16}, {24, 12}})
    all.push_back({"torus " + times(n, m), torus(n, m, 0.7)});
  for (const auto& [n, m] : {std::pair{8, 40}, {40, 9}})
    all.push_back({"thin torus " + times(n, m), torus(n, m, 0.65)});
  all.push_back({"ellipsoid 2:1:1", scaled(sphere(16, 10), {2, 1, 1})});
  all.push_back({"ellipsoid 1:1:3", scaled(sphere(14, 8), {1, 1, 3})});
  all.push_back({"ellipsoid 3:2:1", scaled(icosphere(2), {3, 2, 1})});
  all.push_back({"egg", egg()});
  all.push_back({"terrain 12", terrain(12, 0.9)});
  all.push_back({"terrain 20", terrain(20, 0.6)});
  all.push_back({"row of spheres", row_of_spheres()});
  all.push_back(
      {"capsule", revolved(joined(arc(0, 0, 1, -90, 0, 3), arc(0, 2, 1, 0, 90, 3)), 12, {1})});
  all.push_back(
      {"long capsule", revolved(joined(arc(0, 0, 1, -90, 0, 4), arc(0, 9, 1, 0, 90, 4)), 16, {1})});
  for (const int levels : {1, 2})
    all.push_back({"sphere, each face cut " + std::to_string(levels),
                   flat_subdivided(sphere(12, 8), levels)});
}

// All edges between plane faces are features.
void add_polyhedra(Shapes& all) {
  const Loop six = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const MeshData octahedron = polyhedron(
      six,
      {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}});
  const auto pyramid = [](double height) {
    return polyhedron({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, height}},
                      {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  };
  all.push_back({"tetrahedron", polyhedron({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                                           {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}})});
  all.push_back({"octahedron", octahedron});
  all.push_back({"octahedron, fine", flat_subdivided(octahedron, 3)});
  all.push_back({"dodecahedron", dodecahedron()});
  all.push_back({"pyramid", pyramid(1)});
  all.push_back({"low pyramid", pyramid(0.5)});
  all.push_back({"low pyramid, fine", flat_subdivided(pyramid(0.5), 3)});
  all.push_back(
      {"wedge", polyhedron({{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 2, 0}, {3, 0, 1}, {3, 2, 1}},
                           {{0, 3, 2, 1}, {0, 1, 4}, {3, 5, 2}, {1, 2, 5, 4}, {0, 4, 5, 3}})});
  all.push_back({"cube", cells({{0, 0, 0}}, {1, 1, 1})});
  all.push_back({"cube, fine", cells({{0, 0, 0}}, {1, 1, 1}, 6)});
  all.push_back({"long box", cells({{0, 0, 0}}, {10, 1, 0.2}, 2)});
  all.push_back({"chamfered box", chamfered_box({2, 1.5, 1}, 0.15)});
  all.push_back({"chamfered box, fine", flat_subdivided(chamfered_box({2, 1.5, 1}, 0.2), 2)});
  all.push_back({"prism 5", cylinder(5, 3, 4, true)});
  all.push_back({"prism 6", cylinder(6, 2, 1, true)});
  all.push_back({"flat prism 6", cylinder(6, 0.4, 1, true, true)});
  all.push_back({"prism 7", cylinder(7, 2, 2, true)});
  all.push_back({"L bracket", cells({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {1, 1, 1})});
  all.push_back(
      {"U bracket", cells({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}}, {1, 2, 1}, 2)});
  all.push_back(
      {"frame",
       cells(
           {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}, {0, 2, 0}, {1, 2, 0}, {2, 2, 0}},
           {1, 1, 0.5})});
  all.push_back({"stairs", cells({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 1}, {1, 0, 1}, {0, 0, 2}},
                                 {1, 3, 0.5})});
  const Profile gable = {{0, 0}, {4, 0}, {4, 1}, {2, 1.5}, {0, 1}};
  all.push_back({"house", extruded(gable, {2, 0.7}, 3, each_its_own(5))});
  all.push_back({"house, fine", flat_subdivided(extruded(gable, {2, 0.7}, 3, each_its_own(5)), 3)});
  all.push_back({"star 5", extruded(star(5, 2, 0.9), {0, 0}, 0.6, each_its_own(10))});
  all.push_back({"star 8", extruded(star(8, 2, 1.2), {0, 0}, 0.6, each_its_own(16), 3)});
  all.push_back({"gear 9", extruded(gear(9, 2, 1.6), {0, 0}, 0.5, each_its_own(36))});
}

// Cylinders, cones and plates with holes: rims, but no seams.
void add_cylinders(Shapes& all) {
  for (const int n : {8, 9, 12, 16, 24, 48})
    all.push_back({"cylinder " + std::to_string(n), cylinder(n, 2, 1, false)});
  all.push_back({"cylinder 12, caps in strips", cylinder(12, 1, 1, false, true)});
  for (const auto& [n, rows] : {std::pair{16, 5}, {16, 20}, {12, 40}})
    all.push_back({"cylinder " + times(n, rows), cylinder(n, 5, rows, false, rows < 40)});
  all.push_back({"cylinder 12, flat", cylinder(12, 0.1, 1, false)});
  all.push_back({"cylinder 12, long", cylinder(12, 30, 1, false)});
  all.push_back({"cylinder 12, each face cut 2", flat_subdivided(cylinder(12, 2, 1, false), 2)});
  for (const int n : {10, 14, 20})
    all.push_back({"cone " + std::to_string(n), revolved({{0, 0}, {1, 0}, {0, 2}}, n, {1, 2})});
  all.push_back({"two cones", revolved({{0, 0}, {1, 1}, {0, 2}}, 12, {1, 2})});
  all.push_back({"frustum", revolved({{0, 0}, {1, 0}, {0.6, 1}, {0, 1}}, 12, {1, 2, 3})});
  all.push_back({"frustum in rows",
                 revolved({{0, 0}, {1, 0}, {0.8, 1}, {0.6, 2}, {0, 2}}, 16, {1, 2, 2, 3})});
  for (const int n : {16, 24})
    all.push_back({"plate with hole " + std::to_string(n), plate(n, 1, 0.4)});
  all.push_back({"tube", revolved({{0.7, 0}, {1, 0}, {1, 3}, {0.7, 3}}, 14, {1, 2, 3, 4}, true)});
  all.push_back({"countersunk tube", revolved({{0.4, 0}, {2, 0}, {2, 1}, {0.8, 1}, {0.4, 0.6}}, 16,
                                              {1, 2, 3, 4, 5}, true)});
}

// Turned and milled parts, with rounds of few facets.
void add_parts(Shapes& all) {
  all.push_back({"stepped shaft",
                 revolved({{0, 0}, {1, 0}, {1, 2}, {0.6, 2}, {0.6, 4}, {1.3, 4}, {1.3, 5}, {0, 5}},
                          14, {1, 2, 3, 4, 5, 6, 7})});
  all.push_back(
      {"shaft with chamfers",
       revolved({{0, 0}, {0.9, 0}, {1, 0.1}, {1, 2.9}, {0.9, 3}, {0, 3}}, 16, {1, 2, 3, 4, 5})});
  all.push_back({"shaft to a cone", revolved({{0, 0}, {1, 0}, {1, 2}, {0.5, 3}, {0.5, 4}, {0, 4}},
                                             16, {1, 2, 3, 4, 5})});
  const MeshData pencil = revolved({{0, 0}, {1, 0}, {1, 2}, {0, 2.4}}, 16, {1, 2, 3});
  all.push_back({"shaft with a low cone", pencil});
  all.push_back({"shaft with a low cone, fine", flat_subdivided(pencil, 2)});
  all.push_back({"spool", revolved({{0, 0},
                                    {1, 0},
                                    {1, 0.4},
                                    {0.8, 0.7},
                                    {0.5, 0.8},
                                    {0.5, 2},
                                    {0.8, 2.1},
                                    {1, 2.4},
                                    {1, 2.8},
                                    {0, 2.8}},
                                   12, {1, 2, 3, 4, 5, 6, 7, 8, 9})});
  all.push_back({"rounded shaft",
                 revolved(joined(joined({{0, 0}}, arc(0.7, 0.3, 0.3, -90, 0, 4)), {{1, 3}, {0, 3}}),
                          24, {1, 1, 1, 1, 1, 1, 2})});
  all.push_back(
      {"barrel", revolved(joined(joined({{0, -1.4}}, arc(-1, 0, 2, -44, 44, 6)), {{0, 1.4}}), 16,
                          {1, 2, 2, 2, 2, 2, 2, 3})});
  all.push_back({"lens", revolved(joined(arc(0, 1, 2, -90, -40, 4),
                                         arc(0, 1 - 4 * std::sin(2 * M_PI / 9), 2, 40, 90, 4)),
                                  16, {1, 1, 1, 1, 2})});
  all.push_back(
      {"dome on a plate",
       revolved(joined({{0, -0.5}, {2, -0.5}, {2, 0}}, arc(0, 0, 1, 0, 90, 4)), 16, {1, 2, 3, 4})});
  all.push_back({"vase", revolved({{0, 0},
                                   {0.5, 0},
                                   {0.5, 0.12},
                                   {0.85, 0.4},
                                   {1, 0.7},
                                   {0.95, 1.1},
                                   {0.7, 1.5},
                                   {0.45, 1.8},
                                   {0.35, 2.1},
                                   {0.42, 2.4},
                                   {0.6, 2.65}},
                                  14, {1, 2, 3})});
  all.push_back({"pot", revolved(joined(joined({{0, 0.25}}, arc(0.6, 0.7, 0.7, -40, 60, 5)),
                                        {{0.8, 1.4}, {0.55, 1.65}, {0.25, 1.78}, {0, 1.8}}),
                                 12, {1, 2})});
  for (const int n : {2, 4, 6, 8})
    all.push_back({"rounded plate " + std::to_string(n), rounded_plate({3, 2, 0.5}, 0.6, n)});
  all.push_back({"rounded plate 4 in rows", rounded_plate({3, 2, 2}, 0.6, 4, 5)});
  all.push_back({"half disc", d_shape(6)});
  for (const int n : {4, 6}) all.push_back({"slot " + std::to_string(n), slot(n)});
}

// The same with noise of one or two per cent of their size.
void add_rough(Shapes& all) {
  all.push_back({"cube, rough", roughened(cells({{0, 0, 0}}, {1, 1, 1}, 8), 0.008)});
  all.push_back({"L bracket, rough",
                 roughened(cells({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {1, 1, 1}, 4), 0.01)});
  all.push_back({"cylinder 12, rough", roughened(cylinder(12, 3, 6, false), 0.02)});
  all.push_back({"cylinder 14, rough", roughened(cylinder(14, 4, 9, false), 0.015)});
  all.push_back({"cylinder 12, each face cut 2, rough",
                 roughened(flat_subdivided(cylinder(12, 2, 1, false), 2), 0.001)});
  all.push_back({"plate with hole, rough", roughened(plate(16, 1, 0.4), 0.01)});
  all.push_back({"sphere, rough", roughened(sphere(16, 8), 0.02)});
  all.push_back({"icosphere, rough", roughened(icosphere(2), 0.015)});
  all.push_back({"torus, rough", roughened(torus(16, 12, 0.7), 0.02)});
  all.push_back({"ellipsoid, rough", roughened(scaled(sphere(14, 9), {1, 1, 2.5}), 0.02)});
}

}  // namespace

std::vector<FeatureShape> feature_shapes() {
  Shapes all;
  for (const auto add : {add_rounds, add_polyhedra, add_cylinders, add_parts, add_rough}) add(all);
  return all;
}

}  // namespace aomd::test
