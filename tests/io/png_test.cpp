#include "core/io/png.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/support/io_helpers.h"

namespace aomd::io::png_test {
namespace {

using test::bytes_of;

class Png : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file(const char* name) const { return folder_ / name; }

  const test::TemporaryFolder folder_;
};

Image pattern(int width, int height) {
  Image image(width, height);
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    image.rgba[i] = static_cast<std::uint8_t>(37 * i + i / 7);
  return image;
}

void write_bytes(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

TEST_F(Png, RoundTripKeepsEveryByte) {
  const Image image = pattern(17, 5);
  write_png(file("a.png"), image);
  EXPECT_EQ(read_png(file("a.png")), image);
}

TEST_F(Png, SamePictureGivesTheSameBytes) {
  write_png(file("a.png"), pattern(40, 30));
  write_png(file("b.png"), pattern(40, 30));
  EXPECT_EQ(bytes_of(file("a.png")), bytes_of(file("b.png")));
}

TEST_F(Png, PixelAddressesRowsFromTheTop) {
  Image image(3, 2);
  image.pixel(2, 1)[0] = 9;
  EXPECT_EQ(image.rgba[4 * 5], 9);
}

TEST_F(Png, MissingFileAndFolderAreReadErrors) {
  EXPECT_THROW((void)read_png(file("none.png")), ReadError);
  EXPECT_THROW((void)read_png(file("")), ReadError);
}

TEST_F(Png, OtherContentIsAReadError) {
  write_bytes(file("text.png"), "this is no picture");
  EXPECT_THROW((void)read_png(file("text.png")), ReadError);
  write_bytes(file("empty.png"), "");
  EXPECT_THROW((void)read_png(file("empty.png")), ReadError);
}

TEST_F(Png, EveryTruncationIsAnErrorAndNotACrash) {
  write_png(file("a.png"), pattern(9, 9));
  const std::string whole = bytes_of(file("a.png"));
  for (std::size_t length = 0; length + 16 < whole.size(); length += 5) {
    write_bytes(file("cut.png"), whole.substr(0, length));
    EXPECT_THROW((void)read_png(file("cut.png")), ReadError) << length;
  }
}

TEST_F(Png, ForgedHeaderIsAnError) {
  write_png(file("a.png"), pattern(2, 2));
  std::string bytes = bytes_of(file("a.png"));
  // Width and height of the header; its checksum no longer fits.
  bytes.replace(16, 8, std::string("\x00\x01\x00\x00\x00\x01\x00\x00", 8));
  write_bytes(file("huge.png"), bytes);
  EXPECT_THROW((void)read_png(file("huge.png")), FileError);
}

TEST_F(Png, WritingAnEmptyPictureOrIntoNoFolderIsAWriteError) {
  EXPECT_THROW(write_png(file("a.png"), Image()), WriteError);
  EXPECT_THROW(write_png(file("no/such/folder/a.png"), pattern(2, 2)), WriteError);
}

}  // namespace
}  // namespace aomd::io::png_test
