// Pictures on a surface: where they lie while it changes, what is said of seams and of corners.

#include <gtest/gtest.h>

#include "core/io/io.h"
#include "core/samples/samples.h"
#include "tests/support/io_helpers.h"
#include "tests/support/session_helpers.h"
#include "viewer/explain/entity_facts.h"

namespace aomd::scene::texture_test {
namespace {

using aomd::test::TemporaryFolder;
using test::drive;

/// The chart on which a place of the globe's picture lies.
int chart_of(glm::vec2 at) { return static_cast<int>(3 * at.x) + 3 * static_cast<int>(2 * at.y); }

/// All faces show their part of one chart, and so does what is drawn.
void expect_painted(const Mesh& mesh, const SurfaceDrawing& drawing) {
  const Drawable& drawn = drawing.drawable();
  ASSERT_EQ(drawn.places.size(), drawn.corners.size());
  for (const Face f : mesh.faces()) {
    const std::size_t first = 3 * std::size_t{f.index};
    ASSERT_EQ(drawn.corners[first].flags >> picture_shift, 1u) << f.index;
    for (std::size_t k = 1; k < 3; ++k)
      ASSERT_EQ(chart_of(drawn.places[first + k]), chart_of(drawn.places[first])) << f.index;
  }
}

TEST(Texture, FollowsWhatTheMeshBecomes) {
  Session s;
  drive(s, {"sample globe 6"});
  EXPECT_EQ(s.sheet().texture(), nullptr);
  EXPECT_TRUE(s.sheet().drawing().drawable().places.empty());
  drive(s, {"color texture"});
  ASSERT_NE(s.sheet().texture(), nullptr);
  EXPECT_EQ(s.sheet().texture()->pictures->images.size(), 1u);
  expect_painted(s.document().mesh(), s.sheet().drawing());
  drive(s, {"run"});
  EXPECT_LT(s.document().mesh().count(2), 432u);
  expect_painted(s.document().mesh(), s.sheet().drawing());
  drive(s, {"undo"});
  expect_painted(s.document().mesh(), s.sheet().drawing());
  drive(s, {"color none"});
  EXPECT_TRUE(s.sheet().drawing().drawable().places.empty());
}

TEST(Texture, TheReferenceHasItToo) {
  Session s;
  drive(s, {"sample globe 6", "color texture", "run", "compare side"});
  ASSERT_NE(s.sheet().reference_drawing(), nullptr);
  EXPECT_EQ(s.sheet().reference_drawing()->drawable().places.size(), 3u * 432);
  drive(s, {"runs keep before", "undo", "compare with 1"});
  const Drawable& kept = s.sheet().reference_drawing()->drawable();
  EXPECT_EQ(kept.places.size(), kept.corners.size());
}

TEST(Texture, WhereNothingChangedPlacesAreThoseOfTheFile) {
  const MeshData data = make_sample("globe", 3);
  Session s;
  drive(s, {"sample globe 3", "color texture"});
  for (std::size_t corner = 0; corner < data.faces.vertices.size(); ++corner) {
    const glm::vec2 at = s.sheet().drawing().drawable().places[corner];
    EXPECT_EQ(at.x, static_cast<float>(data.corners[0].values[2 * corner]));
    EXPECT_EQ(at.y, static_cast<float>(data.corners[0].values[2 * corner + 1]));
  }
}

TEST(Texture, AMissingPictureIsNamedAndTheColourOfItsMaterialShows) {
  const TemporaryFolder folder;
  io::write_file(folder / "m.mtl", "newmtl a\nKd 1 0 0\nmap_Kd gone.png\n");
  io::write_file(folder / "a.obj",
                 "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n");
  Session s;
  drive(s, {"open " + (folder / "a.obj").string(), "color texture"});
  EXPECT_EQ(s.document().content().notes,
            std::vector<std::string>{"not there: picture \"gone.png\""});
  EXPECT_EQ(s.sheet().texture()->of(0).color, rgb(0xff0000));
  EXPECT_TRUE(s.sheet().texture()->pictures->images[0].empty());
}

TEST(Texture, SeamsSayWhatWouldTear) {
  Session s;
  drive(s, {"sample globe 6"});
  const Mesh& mesh = s.document().mesh();
  const Vertex on_seam = s.document().content().seams.at(0).vertices.at(3);
  for (const Edge e : mesh.row<1>(on_seam)) {
    if (mesh.classification(e).dimension() != 2) continue;
    drive(s, {"select edge " + std::to_string(e.index)});
    const EntityVerdict* verdict = s.sheet().inquiry().verdict();
    ASSERT_NE(verdict, nullptr);
    for (const CollapseWay& way : verdict->ways)
      EXPECT_EQ(way.words.ends_with(" The seam of uv would tear."),
                way.outlook.contraction.deleted == on_seam)
          << way.words;
  }
}

TEST(Texture, TheInspectorShowsCorners) {
  Session s;
  drive(s, {"sample globe 2"});
  const auto facts_of = [&](EntityRef e) {
    std::string text;
    for (const auto& [name, value] : entity_facts(s.document(), e).facts)
      text += name + "=" + value + "; ";
    return text;
  };
  const std::string face = facts_of({2, 0});
  EXPECT_NE(face.find("material=globe; uv at vertex 0=0.007812, 0.011719; "), std::string::npos)
      << face;
  const std::string vertex = facts_of({0, 0});
  EXPECT_NE(vertex.find("uv in face "), vertex.rfind("uv in face ")) << vertex;
  EXPECT_NE(vertex.find("color="), std::string::npos) << vertex;
}

}  // namespace
}  // namespace aomd::scene::texture_test
