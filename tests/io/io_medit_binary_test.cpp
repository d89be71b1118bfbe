// Binary Medit: every version and byte order, and what is wrong with damaged files.

#include "tests/support/volume_helpers.h"

namespace aomd::io_medit_binary_test {
namespace {

using test::Indices;
using test::raw;

/// A file of one version and byte order, section by section.
class Binary {
 public:
  Binary(int version, bool swapped) : version_(version), swapped_(swapped) {
    bytes_ = word(1) + word(version);
    section(3, word(3));
  }

  [[nodiscard]] std::string word(std::int32_t value) const { return raw(value, swapped_); }
  [[nodiscard]] std::string integer(std::int64_t value) const {
    return version_ == 4 ? raw(value, swapped_) : word(static_cast<std::int32_t>(value));
  }
  [[nodiscard]] std::string real(double value) const {
    return version_ == 1 ? raw(static_cast<float>(value), swapped_) : raw(value, swapped_);
  }
  [[nodiscard]] std::string integers(std::initializer_list<int> values) const {
    std::string bytes;
    for (const int value : values) bytes += integer(value);
    return bytes;
  }

  void section(int code, const std::string& content) {
    const std::size_t size = version_ < 3 ? 4 : 8;
    bytes_ += word(code) + position(bytes_.size() + 4 + size + content.size()) + content;
  }
  [[nodiscard]] std::string finish() const { return bytes_ + word(54) + position(0); }

 private:
  [[nodiscard]] std::string position(std::size_t at) const {
    return version_ < 3 ? word(static_cast<std::int32_t>(at))
                        : raw(static_cast<std::int64_t>(at), swapped_);
  }

  int version_;
  bool swapped_;
  std::string bytes_;
};

/// A tetrahedron with a triangle of reference 7, a section that nobody knows, and marks.
std::string tetrahedron(int version, bool swapped) {
  Binary file(version, swapped);
  std::string vertices = file.integer(4);
  for (int v = 0; v < 4; ++v) {
    for (int axis = 0; axis < 3; ++axis) vertices += file.real(v == axis + 1 ? 0.5 : 0);
    vertices += file.integer(v);
  }
  file.section(4, vertices);
  file.section(82, file.integers({1, 1, 2}));
  file.section(6, file.integers({1, 1, 3, 2, 7}));
  file.section(8, file.integers({1, 1, 2, 3, 4, 0}));
  file.section(13, file.integers({1, 4}));
  file.section(17, file.integers({1, 1}));
  return file.finish();
}

TEST(MeditBinary, ReadsEveryVersionAndByteOrder) {
  for (int version = 1; version <= 4; ++version) {
    for (const bool swapped : {false, true}) {
      SCOPED_TRACE(version);
      const io::ReadResult result = io::read_bytes("a.meshb", tetrahedron(version, swapped));
      const MeshData& mesh = result.mesh;
      EXPECT_EQ(mesh.positions,
                (std::vector<glm::dvec3>{{0, 0, 0}, {.5, 0, 0}, {0, .5, 0}, {0, 0, .5}}));
      EXPECT_EQ(mesh.faces.vertices, (Indices{0, 2, 1}));
      EXPECT_EQ(mesh.faces.classes, (std::vector<ModelRef>{{2, 7}}));
      EXPECT_EQ(mesh.regions.vertices, (Indices{0, 1, 2, 3}));
      EXPECT_EQ(mesh.vertex_classes[3], ModelRef(0, 1));
      EXPECT_EQ(mesh.attributes,
                (std::vector<Attribute>{{"medit:reference", 0, 1, true, {0, 1, 2, 3}},
                                        {"medit:required", 2, 1, true, {1}}}));
      EXPECT_EQ(result.notes, std::vector<std::string>{"passed over: \"keyword 82\""});
    }
  }
}

TEST(MeditBinary, WritesWhatTextHolds) {
  MeshData mesh = test::one_of_each();
  mesh.attributes = {{"medit:reference", 0, 1, true, {5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -3}},
                     {"medit:normal", 0, 3, false, std::vector<double>(36, 0.1)},
                     {"medit:ridge", 1, 1, true, {0, 1}},
                     {"medit:required", 2, 1, true, {0, 1}}};
  test::expect_same(test::written_and_read("a.meshb", mesh).mesh, mesh);
  test::expect_same(test::written_and_read("a.mesh", mesh).mesh, mesh);
  // The extension alone decides: others tell the two from each other by it.
  const test::TemporaryFolder folder;
  io::write(folder / "a.mesh", mesh, {.binary = true});
  EXPECT_TRUE(
      test::bytes_of(folder / "a.mesh").starts_with("MeshVersionFormatted 2\nDimension 3\n"));
  io::write(folder / "a.meshb", mesh, {.binary = false});
  EXPECT_TRUE(test::bytes_of(folder / "a.meshb").starts_with(std::string("\1\0\0\0\2\0\0\0", 8)));
}

TEST(MeditBinary, DamagedFilesSayTheByte) {
  const std::string good = tetrahedron(2, false);
  for (std::size_t size = 4; size < good.size() - 8; ++size) {
    if (size == 84) continue;  // by its size an STL without facets
    SCOPED_TRACE(size);
    test::expect_error("a.meshb", good.substr(0, size), {"byte "});
  }
  Binary many(2, false);
  many.section(4, many.integer(1'000'000'000));
  test::expect_error("a.meshb", many.finish(), {"byte 28:", "too short for 1000000000 Vertices"});
  Binary back(2, false);
  test::expect_error("a.meshb", back.finish().substr(0, 20) + back.word(4) + back.word(8),
                     {"byte 24:", "a section that ends at byte 8"});
  Binary nan(2, false);
  nan.section(4,
              nan.integer(1) + nan.real(1) + nan.real(std::nan("")) + nan.real(1) + nan.integer(0));
  test::expect_error("a.meshb", nan.finish(), {"byte 40:", "y is not a finite number"});
}

}  // namespace
}  // namespace aomd::io_medit_binary_test
