// A surface that is gone through piece by piece is the one that a whole reader reads.

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <functional>
#include <limits>

#include "core/io/io.h"
#include "core/io/streamed_surface.h"
#include "core/io/tile_weld.h"
#include "core/samples/samples.h"
#include "tests/support/io_helpers.h"

namespace aomd::streamed_surface_test {
namespace {

using io::StreamedSurface;

class StreamedSurfaceTest : public testing::Test {
 protected:
  std::filesystem::path put(const std::string& bytes) const {
    std::ofstream(folder_ / "a.ply", std::ios::binary) << bytes;
    return folder_ / "a.ply";
  }

  void expect_refused(const std::string& bytes, const std::string& fragment) const {
    try {
      const StreamedSurface surface(put(bytes));
      surface.each_vertices([](auto, auto) {});
      surface.each_faces([](auto, auto) {});
      ADD_FAILURE() << "read in spite of: " << fragment;
    } catch (const io::ReadError& e) {
      EXPECT_NE(std::string(e.what()).find(fragment), std::string::npos) << e.what();
    }
  }

  test::TemporaryFolder folder_;
};

/// Bytes of numbers in one order.
class Numbers {
 public:
  explicit Numbers(std::endian order) : order_(order) {}
  template <typename Value>
  Numbers& put(Value value) {
    char bytes[sizeof(Value)];
    std::memcpy(bytes, &value, sizeof(Value));
    if (order_ != std::endian::native) std::reverse(std::begin(bytes), std::end(bytes));
    text_.append(bytes, sizeof(Value));
    return *this;
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::endian order_;
  std::string text_;
};

std::string header(const std::string& format, const std::string& elements) {
  return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n";
}

const std::string little = "binary_little_endian";
const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string three = "element vertex 3\n" + xyz;
const std::string one_face = "element face 1\nproperty list uchar int vertex_indices\n";

std::string corners(std::endian order, float last = 1) {
  Numbers n(order);
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, last, 0.f}) n.put(x);
  return n.text();
}

std::string face(std::endian order, std::uint8_t count, std::int32_t last) {
  return Numbers(order).put(count).put(std::int32_t{0}).put(std::int32_t{1}).put(last).text();
}

void expect_as_read(const std::filesystem::path& path) {
  const MeshData whole = io::read(path).mesh;
  const StreamedSurface surface(path);
  ASSERT_EQ(surface.vertices(), whole.positions.size());
  ASSERT_EQ(surface.faces(), whole.faces.size());
  std::vector<glm::dvec3> positions;
  surface.each_vertices([&](std::uint32_t first, std::span<const glm::dvec3> some) {
    EXPECT_EQ(first, positions.size());
    positions.insert(positions.end(), some.begin(), some.end());
  });
  EXPECT_EQ(positions, whole.positions);
  std::vector<std::uint32_t> vertices;
  surface.each_faces([&](std::uint32_t first, std::span<const StreamedSurface::Triangle> some) {
    EXPECT_EQ(3 * std::size_t{first}, vertices.size());
    for (const auto& t : some) vertices.insert(vertices.end(), t.begin(), t.end());
  });
  EXPECT_EQ(vertices, whole.faces.vertices);
}

// More than one piece of each: they have a million bytes.
TEST_F(StreamedSurfaceTest, IsWhatAWholeReaderReads) {
  io::write(folder_ / "a.ply", make_sample("scan", 250'000));
  expect_as_read(folder_ / "a.ply");
}

TEST_F(StreamedSurfaceTest, ReadsBothByteOrders) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const std::string format = order == std::endian::little ? little : "binary_big_endian";
    expect_as_read(put(header(format, three + one_face) + corners(order) + face(order, 3, 2)));
  }
}

TEST_F(StreamedSurfaceTest, PassesOverWhatStandsBetweenAndNamesIt) {
  const auto order = std::endian::little;
  const std::string elements =
      "element camera 2\nproperty double view\nelement vertex 3\nproperty uchar red\n" + xyz +
      "element face 1\nproperty short part\nproperty list uchar int vertex_index\n" +
      "element rest 5\nproperty list uchar int what\n";
  Numbers n(order);
  n.put(1.0).put(2.0);
  for (int i = 0; i < 3; ++i) n.put(std::uint8_t(9)).put(float(i == 1)).put(float(i == 2)).put(0.f);
  n.put(std::int16_t(7));
  const auto path = put(header(little, elements) + n.text() + face(order, 3, 2) + "rest");
  const StreamedSurface surface(path);
  surface.each_vertices([](std::uint32_t, std::span<const glm::dvec3> p) {
    EXPECT_EQ(std::vector(p.begin(), p.end()),
              (std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  });
  surface.each_faces([](std::uint32_t, std::span<const StreamedSurface::Triangle> t) {
    EXPECT_EQ(t.front(), (StreamedSurface::Triangle{0, 1, 2}));
  });
  EXPECT_EQ(surface.left_out(), (std::vector<std::string>{"camera \"view\""}));
}

/// Four vertices with a colour and three faces with a label, between other elements; faces first
/// where that is asked for.
std::string square_with_arrays(std::endian order, bool faces_first) {
  const std::string vertices =
      "element vertex 4\nproperty uchar red\n" + xyz +
      "property uchar model_dimension\nproperty int model_tag\nproperty double heat\n";
  const std::string faces =
      "element face 3\nproperty short part\nproperty list uchar ushort vertex_index\n";
  const std::string between = "element camera 2\nproperty double view\n";
  Numbers of_vertices(order), of_faces(order), rest(order);
  for (int i = 0; i < 4; ++i) {
    of_vertices.put(std::uint8_t(200 + i)).put(float(i % 2)).put(float(i / 2)).put(0.f);
    of_vertices.put(std::uint8_t(2)).put(std::int32_t(7)).put(0.5 + i);
  }
  const std::uint16_t corners[3][3] = {{0, 1, 3}, {0, 3, 2}, {3, 1, 2}};
  for (std::int16_t f = 0; f < 3; ++f) {
    of_faces.put(std::int16_t(10 * f)).put(std::uint8_t(3));
    for (const std::uint16_t v : corners[f]) of_faces.put(v);
  }
  rest.put(1.0).put(2.0);
  const std::string format = order == std::endian::little ? little : "binary_big_endian";
  return faces_first ? header(format, "comment kept\n" + faces + between + vertices) +
                           of_faces.text() + rest.text() + of_vertices.text()
                     : header(format, "comment kept\n" + vertices + between + faces) +
                           of_vertices.text() + rest.text() + of_faces.text();
}

// The two faces at the last vertex, which leave out the first one.
TEST_F(StreamedSurfaceTest, APartHasItsArraysAndItsOwnNumbers) {
  for (const std::endian order : {std::endian::little, std::endian::big})
    for (const bool faces_first : {false, true}) {
      const StreamedSurface surface(put(square_with_arrays(order, faces_first)));
      const StreamedSurface::Part part =
          surface.part([](const StreamedSurface::Triangle& t) { return t[0] == 3; });
      EXPECT_EQ(part.ids, (std::vector<std::uint32_t>{1, 2, 3}));
      EXPECT_EQ(part.mesh.positions, (std::vector<glm::dvec3>{{1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
      EXPECT_EQ(part.mesh.faces.vertices, (std::vector<std::uint32_t>{2, 0, 1}));
      ASSERT_EQ(part.mesh.attributes.size(), 3u);
      for (const Attribute& a : part.mesh.attributes)
        EXPECT_EQ(a.values, a.name == "red"    ? (std::vector<double>{201, 202, 203})
                            : a.name == "heat" ? (std::vector<double>{1.5, 2.5, 3.5})
                                               : (std::vector<double>{20}))
            << a.name;
      EXPECT_TRUE(part.mesh.vertex_classes.empty());
      EXPECT_EQ(part.mesh.remarks.size(), 1u);
      std::vector<std::string> left_out = surface.left_out();
      std::sort(left_out.begin(), left_out.end());
      EXPECT_EQ(left_out, (std::vector<std::string>{"camera \"view\"", "vertex \"model_dimension\"",
                                                    "vertex \"model_tag\""}));
      const auto all = [](const StreamedSurface::Triangle&) { return true; };
      MeshData whole = io::read(folder_ / "a.ply").mesh;
      EXPECT_FALSE(whole.vertex_classes.empty());
      whole.vertex_classes.clear();
      EXPECT_TRUE(surface.part(all).mesh == whole);
    }
}

/// The cells of a grid from one column to another, in numbers of their own, whole numbers apart.
///
///     2---5---8     left tile: columns 0 and 1 of the vertices
///     | \ | \ |     right tile: columns 1 and 2
///     1---4---7
///     | \ | \ |
///     0---3---6
MeshData columns(int from, int to) {
  MeshData mesh;
  for (int x = from; x <= to; ++x)
    for (int y = 0; y < 3; ++y) mesh.positions.emplace_back(x, y, 0);
  for (std::uint32_t x = 0; int(x) < to - from; ++x)
    for (std::uint32_t y = 0; y < 2; ++y) {
      const std::uint32_t v = 3 * x + y;
      for (const std::uint32_t corner : {v, v + 3, v + 1, v + 1, v + 3, v + 4})
        mesh.faces.vertices.push_back(corner);
      mesh.faces.shapes.resize(mesh.faces.shapes.size() + 2, Shape::Triangle);
    }
  Attribute x{.name = "x3", .values = {}};
  for (const glm::dvec3& p : mesh.positions) x.values.push_back(3 * p.x);
  mesh.attributes = {x};
  return mesh;
}

class TilesTest : public StreamedSurfaceTest {
 protected:
  TilesTest() { std::filesystem::create_directory(tiles()); }
  [[nodiscard]] std::filesystem::path tiles() const { return folder_ / "tiles"; }
  void put_tile(const std::string& name, const MeshData& mesh) const {
    io::write(tiles() / name, mesh);
  }
};

TEST_F(TilesTest, AreOneAtTheirBorders) {
  put_tile("b.ply", columns(1, 2));
  put_tile("a.ply", columns(0, 1));
  std::ofstream(tiles() / "notes.txt") << "no tile";
  const StreamedSurface surface(tiles());
  EXPECT_EQ(surface.vertices(), 12u);  // those of the right tile's left column are used by nothing
  EXPECT_EQ(surface.faces(), 8u);
  const StreamedSurface::Part part = surface.part([](const auto&) { return true; });
  const MeshData whole = columns(0, 2);
  EXPECT_EQ(part.mesh.positions, whole.positions);
  EXPECT_EQ(part.mesh.faces.vertices, whole.faces.vertices);
  EXPECT_EQ(part.mesh.attributes.at(0).values, whole.attributes[0].values);
  EXPECT_EQ(part.ids, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 9, 10, 11}));
}

// Four tiles around one vertex; the one in the middle of a tile's border is not at its end.
TEST_F(TilesTest, MeetInOneVertex) {
  const auto quarter = [](int x, int y) {
    MeshData mesh = columns(0, 1);
    for (glm::dvec3& p : mesh.positions) p += glm::dvec3(x, 2 * y, 0);
    return mesh;
  };
  for (const int i : {0, 1, 2, 3}) put_tile(std::to_string(i) + ".ply", quarter(i % 2, i / 2));
  const StreamedSurface::Part part =
      StreamedSurface(tiles()).part([](const auto&) { return true; });
  EXPECT_EQ(part.mesh.positions.size(), 15u);
  EXPECT_EQ(part.mesh.faces.size(), 16u);
}

// A slit along the border of the left tile: which side the right one belongs to is not known. And
// what lies inside of a tile is not on its border, whatever stands at the same place.
TEST_F(TilesTest, StayApartWhereOneHasTwoVerticesAtAPlace) {
  MeshData left = columns(0, 1);
  left.positions.push_back(left.positions[4]);
  for (std::uint32_t& v : left.faces.vertices)
    if (&v >= &left.faces.vertices[6] && v == 4) v = 6;
  left.attributes[0].values.push_back(3);
  put_tile("a.ply", left);
  put_tile("b.ply", columns(1, 2));
  const auto all = [](const auto&) { return true; };
  EXPECT_EQ(StreamedSurface(tiles()).part(all).mesh.positions.size(), 7u + 6u - 2u);
  put_tile("a.ply", columns(0, 2));  // its column 1 lies inside, but for the two ends
  EXPECT_EQ(StreamedSurface(tiles()).part(all).mesh.positions.size(), 9u + 6u - 5u);
}

/// How many vertices three tiles have, the second moved by an offset, and the third by twice that.
class NearTilesTest : public TilesTest {
 protected:
  [[nodiscard]] std::size_t vertices(double offset, const StreamedSurface::Weld& weld) const {
    for (const int i : {0, 1, 2}) {
      MeshData tile = columns(i, i + 1);
      for (glm::dvec3& p : tile.positions) p.y += offset * i;
      put_tile(std::to_string(i) + ".ply", tile);
    }
    const StreamedSurface surface(tiles(), weld);
    return surface.part([](const auto&) { return true; }).mesh.positions.size();
  }
};

TEST_F(NearTilesTest, AreWeldedWithinTheTolerance) {
  constexpr double d = 0.25;
  EXPECT_EQ(vertices(0, {0}), 12u);
  EXPECT_EQ(vertices(d, {0}), 18u);
  EXPECT_EQ(vertices(d, {d}), 12u);
  EXPECT_EQ(vertices(d, {0.99 * d}), 18u);
  EXPECT_EQ(vertices(0, {1e-300}), 12u);
  const double diagonal = std::sqrt(9 + 2.5 * 2.5);
  EXPECT_EQ(vertices(d, {1.01 * d / diagonal, true}), 12u);
  EXPECT_EQ(vertices(d, {0.99 * d / diagonal, true}), 18u);
}

// Both vertices of the right tile are near, and only the nearer one is joined; those of one tile
// never are, however wide the tolerance is.
TEST_F(NearTilesTest, TheNearestTwoAreOneAndNoTwoOfATile) {
  using io::detail::TilePlace;
  const std::vector<TilePlace> places = {{{0, 0, 0}, 10, 0},
                                         {{3, 0, 0}, 20, 1},
                                         {{2, 0, 0}, 21, 1},
                                         {{1, 0, 0}, 11, 0},
                                         {{2.5, 0, 0}, 30, 2}};
  using Joined = io::detail::TileReplacements;
  EXPECT_EQ(io::detail::weld_places(places, 0.4), Joined{});
  EXPECT_EQ(io::detail::weld_places(places, 0.5), (Joined{{30, 20}}));
  // 21 and 30 are as near, and come later; then 11 is nearest to 21, and 10 too far from the rest.
  EXPECT_EQ(io::detail::weld_places(places, 1), (Joined{{21, 11}, {30, 20}}));
  EXPECT_EQ(io::detail::weld_places(places, 2.9), (Joined{{21, 11}, {30, 20}}));
  EXPECT_EQ(io::detail::weld_places(places, 100), (Joined{{20, 10}, {21, 11}, {30, 10}}));
  std::vector<TilePlace> turned(places.rbegin(), places.rend());
  EXPECT_EQ(io::detail::weld_places(turned, 100), io::detail::weld_places(places, 100));
}

// What is joined to one that is joined to another must lie within the tolerance of that one.
TEST_F(NearTilesTest, NobodyMovesFurtherThanTheTolerance) {
  using io::detail::TilePlace;
  const std::vector<TilePlace> chain = {{{0, 0, 0}, 0, 0}, {{1, 0, 0}, 1, 1}, {{1.9, 0, 0}, 2, 2}};
  using Joined = io::detail::TileReplacements;
  EXPECT_EQ(io::detail::weld_places(chain, 1), (Joined{{2, 1}}));
  EXPECT_EQ(io::detail::weld_places(chain, 1.9), (Joined{{1, 0}, {2, 0}}));
}

TEST_F(NearTilesTest, AToleranceThatHoldsAllIsRefused) {
  MeshData dense = make_sample("terrain", 200);
  put_tile("0.ply", dense);
  put_tile("1.ply", dense);
  EXPECT_THROW(StreamedSurface(tiles(), {1e9}), io::LimitError);
  EXPECT_NO_THROW(StreamedSurface(tiles(), {0}));
}

TEST_F(TilesTest, SayWhatIsWrong) {
  const auto refused = [&](const std::string& fragment) {
    try {
      const StreamedSurface surface(tiles());
      ADD_FAILURE() << "read in spite of: " << fragment;
    } catch (const io::ReadError& e) {
      EXPECT_NE(std::string(e.what()).find(fragment), std::string::npos) << e.what();
    }
  };
  refused("tiles: has no .ply, .stl or .vtu files");
  put_tile("a.ply", columns(0, 1));
  MeshData other = columns(1, 2);
  other.attributes.clear();
  put_tile("b.ply", other);
  refused("b.ply: has other properties than");
  std::ofstream(tiles() / "b.ply") << "ply\n";
  refused("b.ply");
}

TEST_F(StreamedSurfaceTest, SaysWhatIsWrong) {
  const auto order = std::endian::little;
  const std::string good = header(little, three + one_face) + corners(order);
  const std::size_t body = header(little, three + one_face).size();
  const auto byte = [&](std::size_t of_body) { return "byte " + std::to_string(body + of_body); };
  expect_refused("OFF\n3 1 0\n", "cannot be read in blocks");
  expect_refused(header("ascii", three + one_face) + "0 0 0\n", "PLY as text");
  expect_refused(good, "ends within its data");
  expect_refused(good + face(order, 4, 2), byte(36) + ": only triangles");
  expect_refused(good + face(order, 3, 3), byte(45) + ": there is no vertex 3");
  expect_refused(good + face(order, 3, -1), byte(45) + ": there is no vertex -1");
  expect_refused(header(little, three + one_face) +
                     corners(order, std::numeric_limits<float>::quiet_NaN()) + face(order, 3, 2),
                 byte(28) + ": a coordinate is not a finite number");
  expect_refused(header(little, three) + corners(order), "no vertices or no faces");
  expect_refused(
      header(little, "element vertex 3\nproperty float x\nproperty float y\n" + one_face) +
          corners(order) + face(order, 3, 2),
      "needs x, y and z");
  expect_refused(header(little, three + "element face 1\nproperty int a\n") + corners(order) +
                     face(order, 3, 2),
                 "needs a list vertex_indices");
  expect_refused(header(little, three + one_face + "property list uchar float texcoord\n") +
                     corners(order) + face(order, 3, 2) + '\0',
                 "the list \"texcoord\"");
}

TEST_F(StreamedSurfaceTest, SaysThatTheFileHasBecomeShorter) {
  const auto order = std::endian::little;
  const auto path = put(header(little, three + one_face) + corners(order) + face(order, 3, 2));
  const StreamedSurface surface(path);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 1);
  EXPECT_THROW(surface.each_faces([](auto, auto) {}), io::ReadError);
  EXPECT_NO_THROW(surface.each_vertices([](auto, auto) {}));
}

}  // namespace
}  // namespace aomd::streamed_surface_test
