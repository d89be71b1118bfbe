// A binary STL file that is gone through piece by piece is the surface that a whole reader reads.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>

#include "core/io/facet_corners.h"
#include "core/io/io.h"
#include "core/io/streamed_surface.h"
#include "core/samples/samples.h"
#include "tests/support/io_helpers.h"

namespace aomd::streamed_stl_test {
namespace {

using io::StreamedSurface;
using io::detail::FacetCorners;
using io::detail::FacetPoint;

struct Facet {
  std::array<float, 9> corners{};
  std::uint16_t mark = 0;
};

std::string stl_of(const std::vector<Facet>& facets, const std::string& header = {}) {
  std::string bytes = header;
  bytes.resize(80, '\0');
  const auto put = [&](const auto& value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
  };
  put(static_cast<std::uint32_t>(facets.size()));
  for (const Facet& f : facets) {
    put(std::array<float, 3>{});
    put(f.corners);
    put(f.mark);
  }
  return bytes;
}

/// A square of two facets, and one without area between them.
std::vector<Facet> square() {
  return {{{0, 0, 0, 1, 0, 0, 0, 1, 0}},
          {{1, 0, 0, 1, 0, 0, 1, 1, 0}},
          {{1, 0, -0.0f, 1, 1, 0, -0.0f, 1, 0}}};
}

class StreamedStlTest : public testing::Test {
 protected:
  std::filesystem::path put(const std::string& bytes) const {
    std::ofstream(folder_ / "a.stl", std::ios::binary) << bytes;
    return folder_ / "a.stl";
  }

  /// The faces that have three corners, as a part, and what the whole reader has.
  void expect_as_read(const std::filesystem::path& path) const {
    const MeshData whole = io::read(path).mesh;
    const StreamedSurface surface(path);
    EXPECT_EQ(surface.vertices(), whole.positions.size());
    const StreamedSurface::Part part = surface.part([](const StreamedSurface::Triangle& t) {
      return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
    });
    EXPECT_TRUE(part.mesh == whole);
    for (std::uint32_t i = 0; i < part.ids.size(); ++i) EXPECT_EQ(part.ids[i], i);
  }

  template <typename Error = io::ReadError>
  void expect_refused(const std::string& bytes, const std::string& fragment) const {
    try {
      const StreamedSurface surface(put(bytes));
      ADD_FAILURE() << "read in spite of: " << fragment;
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find(fragment), std::string::npos) << e.what();
    }
  }

  test::TemporaryFolder folder_;
};

// More than one piece: they have a million bytes.
TEST_F(StreamedStlTest, IsWhatAWholeReaderReads) {
  io::write(folder_ / "a.stl", make_sample("scan", 60'000));
  expect_as_read(folder_ / "a.stl");
  expect_as_read(put(stl_of(square())));
}

TEST_F(StreamedStlTest, FacetsWithoutAreaAndNegativeZerosAreWelded) {
  const StreamedSurface surface(put(stl_of(square())));
  EXPECT_EQ(surface.vertices(), 4u);
  std::vector<StreamedSurface::Triangle> all;
  surface.each_faces([&](std::uint32_t, std::span<const StreamedSurface::Triangle> some) {
    all.insert(all.end(), some.begin(), some.end());
  });
  EXPECT_EQ(all, (std::vector<StreamedSurface::Triangle>{{0, 1, 2}, {1, 1, 3}, {1, 3, 2}}));
  surface.each_vertices([](std::uint32_t, std::span<const glm::dvec3> p) {
    EXPECT_EQ(std::vector(p.begin(), p.end()),
              (std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  });
}

// Those of facets without area do not count; colours need one on each of the others.
TEST_F(StreamedStlTest, MarksAreColoursOrNumbers) {
  const std::uint16_t none = 0, red = 0x8000u | 31u << 10, number = 7;
  for (const auto& marks : {std::array{none, none, none}, std::array{none, red, none},
                            std::array{red, none, red}, std::array{number, none, red}})
    for (const char* header : {"", "COLOR=rgba"}) {
      std::vector<Facet> facets = square();
      for (std::size_t i = 0; i < 3; ++i) facets[i].mark = marks[i];
      expect_as_read(put(stl_of(facets, header)));
    }
}

TEST_F(StreamedStlTest, TilesAreOneAtTheirBorders) {
  std::filesystem::create_directory(folder_ / "tiles");
  for (const int tile : {0, 1}) {
    std::vector<Facet> facets = square();
    facets.push_back({{1, 0, 0, 1, 0, 0, 1, 1, 0}});  // without area, at both borders
    facets.push_back({{0, 0, 0, 0, 0, 0, 0, 1, 0}});
    for (Facet& f : facets)
      for (std::size_t k = 0; k < 9; k += 3) f.corners[k] += float(tile);
    std::ofstream(folder_ / "tiles" / (std::to_string(tile) + ".stl"), std::ios::binary)
        << stl_of(facets);
  }
  const StreamedSurface surface(folder_ / "tiles");
  EXPECT_EQ(surface.part([](const auto&) { return true; }).mesh.positions.size(), 6u);
}

TEST_F(StreamedStlTest, SaysWhatIsWrong) {
  const std::string good = stl_of(square());
  expect_refused(good.substr(0, good.size() - 1), "byte 233: the file ends early: 3 facets need");
  std::string many = good;
  many.replace(80, 4, "\xff\xff\xff\xff");
  expect_refused(many, "the file ends early: 4294967295 facets");
  expect_refused("solid" + many.substr(5), "the file ends early: 4294967295 facets");
  expect_refused(good.substr(0, 83), "too short for an STL file");
  expect_refused("", "is empty");
  expect_refused(stl_of({}), "has no facets");
  expect_refused("solid a\n facet normal 0 0 0\n", "STL as text cannot be read in blocks");
  std::vector<Facet> facets = square();
  facets[1].corners[5] = std::numeric_limits<float>::infinity();
  expect_refused(stl_of(facets), "byte 166: a coordinate is not a finite number");
}

TEST_F(StreamedStlTest, NamesWhatFollowsTheLastFacet) {
  const StreamedSurface surface(put(stl_of(square()) + "rest"));
  EXPECT_EQ(surface.left_out(), (std::vector<std::string>{"4 bytes after the last facet"}));
}

TEST_F(StreamedStlTest, SaysThatTheFileHasBecomeShorter) {
  const auto path = put(stl_of(square()));
  const StreamedSurface surface(path);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 1);
  EXPECT_THROW(surface.each_faces([](auto, auto) {}), io::ReadError);
  EXPECT_THROW(surface.each_vertices([](auto, auto) {}), io::ReadError);
}

// So many that they are welded in several passes.
TEST(FacetCornersTest, NumbersByFirstAppearance) {
  constexpr std::uint32_t facets = 2'200'000;
  int passes = 0;
  std::vector<FacetPoint> points;
  for (std::uint64_t corner = 0; corner < 3 * std::uint64_t{facets}; ++corner) {
    const auto place = static_cast<float>(corner * 7919 % 1'000'003);
    points.push_back({place, place * 3, -place});
  }
  const FacetCorners corners(facets, [&](const FacetCorners::Take& take) {
    ++passes;
    const std::span all(points);
    take(all.first(1000));
    take(all.subspan(1000));
  });
  EXPECT_EQ(passes, 4);
  EXPECT_EQ(corners.vertices(), 1'000'003u);
  std::vector<std::uint32_t> number(1'000'003, 0xffffffffu);
  std::uint32_t next = 0;
  for (std::size_t c = 0; c < points.size(); ++c) {
    std::uint32_t& known = number[static_cast<std::size_t>(points[c][0])];
    if (known == 0xffffffffu) known = next++;
    ASSERT_EQ(corners[c], known) << c;
  }
}

}  // namespace
}  // namespace aomd::streamed_stl_test
