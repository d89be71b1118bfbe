// Volumes measured and compared, on meshes with exact answers.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/io/io.h"
#include "core/measure/volume_comparison.h"
#include "core/measure/volume_statistics.h"
#include "core/samples/samples.h"
#include "tests/support/zoo.h"

namespace aomd::test::volume_measure_test {
namespace {

using measure::analyse_volume;
using measure::compare_volumes;
using measure::InterfaceChange;
using measure::Volume;
using measure::VolumeComparison;
using measure::VolumeComplex;

MeshData tetrahedra(std::vector<glm::dvec3> positions,
                    std::initializer_list<std::array<std::uint32_t, 4>> tets) {
  MeshData data;
  data.positions = std::move(positions);
  for (const auto& t : tets) data.regions.add(Shape::Tetrahedron, {t[0], t[1], t[2], t[3]});
  return data;
}

//    3
//   /|\        a corner of the cube with its twin behind the slanted face: 4
//  0-|-2
//   \|/
//    1
MeshData pair(ModelRef first, ModelRef second) {
  MeshData data = tetrahedra({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}},
                             {{0, 1, 2, 3}, {4, 2, 1, 3}});
  data.regions.classes = {first, second};
  return data;
}

TEST(VolumeComplex, OneMaterial) {
  const VolumeComplex c = analyse_volume(Mesh(pair({}, {})));
  ASSERT_EQ(c.regions.size(), 1u);
  EXPECT_FALSE(c.regions[0].model.valid());
  EXPECT_EQ(c.regions[0].regions, 2u);
  EXPECT_EQ(c.regions[0].euler, 5 - 9 + 7 - 2);
  EXPECT_EQ(c.regions[0].parts, 1u);
  EXPECT_NEAR(c.regions[0].volume, 1.0 / 6 + 1.0 / 3, 1e-15);
  EXPECT_EQ(c.skin.size(), 6u);
  EXPECT_TRUE(c.conforming());
}

TEST(VolumeComplex, TwoMaterials) {
  const VolumeComplex c = analyse_volume(Mesh(pair({3, 9}, {3, 4})));
  ASSERT_EQ(c.regions.size(), 2u);
  EXPECT_EQ(c.regions[0].model, ModelRef(3, 4));
  EXPECT_NEAR(c.regions[0].volume, 1.0 / 3, 1e-15);
  EXPECT_NEAR(c.regions[1].volume, 1.0 / 6, 1e-15);
  for (const auto& facts : c.regions) EXPECT_EQ(facts.euler, 1);
  EXPECT_EQ(c.skin.size(), 7u);
  const auto inner = std::find_if(c.skin.begin(), c.skin.end(),
                                  [](const measure::SkinFace& f) { return !f.on.boundary; });
  ASSERT_NE(inner, c.skin.end());
  EXPECT_EQ(inner->on, (measure::Interface{false, {3, 4}, {3, 9}, {}}));
  // out of model region 4, which is the second tetrahedron: towards the corner 0
  const auto v = inner->vertices.span();
  const Mesh mesh(pair({}, {}));
  const glm::dvec3 a = mesh.position(Vertex(v[0])), b = mesh.position(Vertex(v[1])),
                   d = mesh.position(Vertex(v[2]));
  EXPECT_LT(glm::dot(glm::cross(b - a, d - a), glm::dvec3(1)), 0);
}

// Parts hang together by faces: a common edge or vertex is not enough.
TEST(VolumeComplex, PartsAndEulerNumbers) {
  const VolumeComplex edge = analyse_volume(Mesh(zoo::tets_on_an_edge()));
  EXPECT_EQ(edge.regions[0].parts, 2u);
  EXPECT_EQ(edge.regions[0].euler, 1);
  const VolumeComplex vertex = analyse_volume(Mesh(zoo::tets_on_a_vertex()));
  EXPECT_EQ(vertex.regions[0].parts, 2u);
  EXPECT_EQ(vertex.regions[0].euler, 1);
  EXPECT_EQ(analyse_volume(Mesh(make_sample("tet-drilled", 3))).regions[0].euler, 0);
  const VolumeComplex ball = analyse_volume(Mesh(make_sample("ball-in-box", 2)), 2);
  EXPECT_EQ(ball.regions[0].euler, 1);
  EXPECT_EQ(ball.regions[1].euler, 2) << "a thick shell";
  EXPECT_EQ(ball.skin.size(), 6u * 2 * 64 + 24 * 4);
}

TEST(VolumeComplex, EveryShape) {
  const VolumeComplex c = analyse_volume(Mesh(zoo::hybrid()));
  ASSERT_EQ(c.regions.size(), 2u);
  EXPECT_EQ(c.regions[0].regions, 2u);
  EXPECT_EQ(c.regions[0].euler, 1);
  EXPECT_EQ(c.regions[1].parts, 2u);  // the tetrahedron on the pyramid hangs on by edges alone
  EXPECT_TRUE(c.conforming());
  const auto quads = std::count_if(c.skin.begin(), c.skin.end(), [](const measure::SkinFace& f) {
    return f.vertices.count == 4 && f.on.face == ModelRef(2, 7);
  });
  EXPECT_EQ(quads, 1);
  EXPECT_EQ(analyse_volume(Mesh(zoo::fan())).dangling_faces, 1u);
}

TEST(VolumeComplex, WhatDoesNotFit) {
  MeshData twice = pair({}, {});
  twice.regions.add(Shape::Tetrahedron, {2, 3, 0, 1});
  const VolumeComplex repeated = analyse_volume(Mesh(twice));
  EXPECT_EQ(repeated.repeated, (std::vector<Region>{Region(2)}));
  EXPECT_EQ(repeated.crowded.size(), 1u);  // the slanted face, of three
  EXPECT_EQ(repeated.folded.size(), 3u);   // the others, of the two copies
  MeshData folded = pair({}, {});
  folded.positions[4] = {0.1, 0.1, 0.1};
  folded.regions.vertices = {0, 1, 2, 3, 4, 1, 2, 3};
  EXPECT_EQ(analyse_volume(Mesh(folded)).folded.size(), 1u);
  EXPECT_FALSE(analyse_volume(Mesh(folded)).conforming());
}

// The faces and edges that a mesh stores change nothing.
TEST(VolumeComplex, StoredLevelsChangeNothing) {
  Mesh mesh(make_sample("mixed", 2));
  const VolumeComplex before = analyse_volume(mesh);
  mesh.set(3, 2);
  mesh.set(0, 1);
  const VolumeComplex after = analyse_volume(mesh, 3);
  EXPECT_EQ(after.skin.size(), before.skin.size());
  for (std::size_t i = 0; i < before.skin.size(); ++i)
    EXPECT_EQ(after.skin[i].on, before.skin[i].on);
  EXPECT_EQ(after.dangling_faces, 0u);
}

// Four faces of the boundary meet in the edge 0-1: a curve, though all lie on one interface.
TEST(VolumeCurves, WhereOtherThanTwoFacesMeet) {
  const Mesh mesh(zoo::tets_on_an_edge());
  const measure::VolumeCurves curves = measure::curves_of(mesh, analyse_volume(mesh));
  EXPECT_EQ(curves.edges, (std::vector<std::array<Vertex, 2>>{{Vertex(0), Vertex(1)}}));
  EXPECT_EQ(curves.ends, (std::vector<Vertex>{Vertex(0), Vertex(1)}));
}

TEST(VolumeQuality, OfACornerAndARegularTetrahedron) {
  const double flat = std::acos(1 / std::sqrt(3.0)) * 180 / std::acos(-1.0);  // 54.7
  const double regular = std::acos(1 / 3.0) * 180 / std::acos(-1.0);          // 70.5
  const auto q = measure::measure_volume(Mesh(pair({}, {})));
  EXPECT_NEAR(q.min_dihedral_deg, flat, 1e-12);
  EXPECT_EQ(q.worst, Region(0));
  EXPECT_NEAR(q.mean_dihedral_deg, (flat + regular) / 2, 1e-12);
  EXPECT_NEAR(q.p5_dihedral_deg, flat, 1e-12);
  EXPECT_EQ(q.regions_below_10deg_pct, 0);
  EXPECT_EQ(q.tetrahedra, 2u);
  EXPECT_NEAR(q.shape_mean, (1 + std::sqrt(2.0) / std::pow(1.5, 1.5)) / 2, 1e-12);
  EXPECT_NEAR(q.shape_min, std::sqrt(2.0) / std::pow(1.5, 1.5), 1e-12);
  EXPECT_TRUE(q.inverted.empty());
}

// Nineteen regular ones and a flat one, then one more of these.
TEST(VolumeQuality, PercentilesAndShares) {
  MeshData data = pair({}, {});
  data.positions.push_back({0.3, 0.3, 0.01});
  data.regions.vertices.clear();
  data.regions.shapes.clear();
  data.regions.classes.clear();
  for (int i = 0; i < 19; ++i) data.regions.add(Shape::Tetrahedron, {4, 2, 1, 3});
  data.regions.add(Shape::Tetrahedron, {0, 1, 2, 5});
  const auto one = measure::measure_volume(Mesh(data));
  EXPECT_EQ(one.regions_below_10deg_pct, 5);
  EXPECT_GT(one.p5_dihedral_deg, 70);
  data.regions.add(Shape::Tetrahedron, {0, 1, 2, 5});
  EXPECT_LT(measure::measure_volume(Mesh(data), 2).p5_dihedral_deg, 10);
  data.regions.vertices[0] = 2, data.regions.vertices[1] = 4;
  const auto turned = measure::measure_volume(Mesh(data));
  EXPECT_EQ(turned.inverted, (std::vector<Region>{Region(0)}));
  EXPECT_NEAR(turned.shape_min, -1, 1e-12);
}

TEST(CompareVolumes, AMeshWithItself) {
  for (const char* name : {"ball-in-box", "mixed", "tet-bracket", "hex-box"}) {
    const Mesh mesh(make_sample(name, 2));
    const VolumeComparison c = compare_volumes(Volume(mesh), Volume(mesh), 1000);
    for (const auto& region : c.regions) {
      EXPECT_TRUE(region.kept()) << name;
      EXPECT_EQ(region.volume_percent(), 0) << name;
    }
    EXPECT_FALSE(c.model_faces.empty()) << name;
    for (const auto* list : {&c.interfaces, &c.model_faces})
      for (const InterfaceChange& change : *list) {
        EXPECT_TRUE(change.kept()) << name;
        EXPECT_LT(change.distance().max, 1e-12) << name;
      }
    EXPECT_GT(c.curves.edges_before, 0u) << name;
    EXPECT_LT(c.curves.both.max, 1e-12) << name;
    EXPECT_GT(c.vertices.before, 7u) << name;
    EXPECT_EQ(c.vertices.kept, c.vertices.before) << name;
    EXPECT_EQ(c.vertices.near, c.vertices.before) << name;
  }
}

// Shifted along z, each side, each edge and each corner is as far away as the whole.
TEST(CompareVolumes, AShiftedBox) {
  const MeshData box = make_sample("tet-box", 3);
  MeshData shifted = make_sample("tet-box", 2);
  for (glm::dvec3& p : shifted.positions) p.z += 0.25;
  const Mesh a(box), b(shifted);
  const VolumeComparison c = compare_volumes(Volume(a), Volume(b), 10000, 2);
  EXPECT_NEAR(c.diagonal, std::sqrt(3.0), 1e-15);
  ASSERT_EQ(c.model_faces.size(), 6u);
  for (const InterfaceChange& change : c.model_faces) {
    EXPECT_NEAR(change.distance().max, 0.25, 1e-12);
    EXPECT_NEAR(change.before->area, 1, 1e-12);
    if (change.on.face.tag() < 5) continue;
    EXPECT_NEAR(change.to_result.rms, 0.25, 1e-12);
    EXPECT_NEAR(change.distance().rms, 0.25, 1e-12);
  }
  // over z in [0, 1/4] a side is up to 1/4 away: the mean of the squares is 1/4^3 / 3
  EXPECT_NEAR(c.model_faces[0].distance().rms, std::sqrt(1.0 / 192), 1e-3);
  const auto whole = measure::distance_over(c.model_faces, true);
  ASSERT_TRUE(whole.has_value());
  EXPECT_NEAR(whole->rms, std::sqrt((2.0 / 16 + 4.0 / 192) / 6), 1e-3);
  EXPECT_FALSE(measure::distance_over(c.model_faces, false).has_value());
  EXPECT_NEAR(c.curves.both.max, 0.25, 1e-12);
  EXPECT_NEAR(c.curves.length_before, 12, 1e-12);
  EXPECT_EQ(c.curves.edges_after, 24u);
  EXPECT_EQ(c.vertices.before, 8u);
  EXPECT_EQ(c.vertices.kept, 0u);
  EXPECT_EQ(c.vertices.lost.size(), 8u);
}

// The interface is compared with the interface: the box around it may be as near as it likes.
TEST(CompareVolumes, ABallThatShrinks) {
  const MeshData before = make_sample("ball-in-box", 2);
  MeshData after = before;
  for (std::size_t v = 0; v < after.positions.size(); ++v)
    if (after.vertex_classes[v] == ModelRef(2, 7)) after.positions[v] *= 0.9;
  const Mesh a(before), b(after);
  const VolumeComparison c = compare_volumes(Volume(a), Volume(b), 20000);
  ASSERT_EQ(c.regions.size(), 2u);
  EXPECT_NEAR(c.regions[0].volume_percent(), 100 * (0.9 * 0.9 * 0.9 - 1), 1e-9);
  EXPECT_NEAR(c.regions[1].volume_percent() * c.regions[1].before->volume,
              -c.regions[0].volume_percent() * c.regions[0].before->volume, 1e-9);
  const auto inner = measure::distance_over(c.interfaces, false);
  ASSERT_TRUE(inner.has_value());
  EXPECT_NEAR(inner->max, 0.045, 0.002);
  EXPECT_LT(measure::distance_over(c.interfaces, true)->max, 1e-12);
}

TEST(CompareVolumes, WhatIsLostAndNew) {
  const Mesh two(pair({3, 1}, {3, 2})), one(pair({3, 1}, {3, 1}));
  const VolumeComparison c = compare_volumes(Volume(two), Volume(one), 100);
  ASSERT_EQ(c.regions.size(), 2u);
  EXPECT_NEAR(c.regions[0].volume_percent(), 200, 1e-9);
  EXPECT_EQ(c.regions[1].volume_percent(), -100);
  EXPECT_FALSE(c.regions[1].kept());
  ASSERT_EQ(c.interfaces.size(), 3u);
  EXPECT_TRUE(c.interfaces[0].measured());
  EXPECT_FALSE(c.interfaces[1].measured());
  EXPECT_FALSE(c.interfaces[2].kept());
  EXPECT_TRUE(c.model_faces.empty());
  // the three edges around the interface, whose ends meet two each
  EXPECT_EQ(c.curves.edges_before, 3u);
  EXPECT_EQ(c.curves.edges_after, 0u);
  EXPECT_EQ(c.vertices.before, 0u);
  const VolumeComparison back = compare_volumes(Volume(one), Volume(two), 100);
  EXPECT_FALSE(back.regions[1].before.has_value());
  EXPECT_TRUE(std::isinf(back.regions[1].volume_percent()));
}

// A line inside a model face is a model edge only where both meshes list it.
TEST(CompareVolumes, ListedEdgesAndVerticesCount) {
  MeshData data = pair({}, {});
  data.edges.add(Shape::Line, {0, 1}, ModelRef(1, 1));
  data.vertex_classes.assign(5, ModelRef());
  data.vertex_classes[0] = ModelRef(0, 1);
  const Mesh listed(data), plain(pair({}, {}));
  const VolumeComparison both = compare_volumes(Volume(listed), Volume(listed), 10);
  EXPECT_EQ(both.curves.edges_before, 1u);
  EXPECT_EQ(both.vertices.before, 2u);
  const VolumeComparison c = compare_volumes(Volume(listed), Volume(plain), 10);
  EXPECT_EQ(c.curves.edges_before, 0u);
  EXPECT_EQ(c.vertices.before, 1u);
  EXPECT_EQ(c.vertices.kept, 1u);
}

TEST(CompareVolumes, ThreadsMakeNoDifference) {
  const Mesh a(make_sample("ball-in-box", 3)), b(make_sample("ball-in-box", 2));
  const VolumeComparison one = compare_volumes(Volume(a), Volume(b), 50000);
  for (const int threads : {2, 5}) {
    const VolumeComparison c =
        compare_volumes(Volume(a, threads), Volume(b, threads), 50000, threads);
    for (std::size_t i = 0; i < one.model_faces.size(); ++i) {
      EXPECT_EQ(c.model_faces[i].distance().rms, one.model_faces[i].distance().rms);
      EXPECT_EQ(c.model_faces[i].distance().max, one.model_faces[i].distance().max);
    }
    EXPECT_EQ(c.regions[0].after->volume, one.regions[0].after->volume);
  }
}

// Volumes, Euler numbers and parts as an independent program counts them.
TEST(VolumeComplex, SharedFiles) {
  const auto path = std::filesystem::path(AOMD_SHARED_DATA) / "t5_spheres_v41.msh";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "shared data is not here";
  const Mesh mesh(io::read(path).mesh);
  const VolumeComplex c = analyse_volume(mesh, 2);
  ASSERT_EQ(c.regions.size(), 6u);
  double volume = 0;
  for (const auto& facts : c.regions) {
    volume += facts.volume;
    EXPECT_EQ(facts.parts, 1u);
  }
  EXPECT_NEAR(volume, 0.875, 1e-9);
  EXPECT_EQ(c.skin.size(), 16492u);
  EXPECT_TRUE(c.conforming());
}

}  // namespace
}  // namespace aomd::test::volume_measure_test
