// Pictures of materials: JPEG and PNG in memory.

#include "core/io/picture.h"

#include "core/io/base64.h"
#include "tests/support/io_helpers.h"

namespace aomd::test::picture_test {
namespace {

/// 8 by 4 pixels of one orange.
const std::string orange_jpeg =
    "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDAAMCAgMCAgMDAwMEAwMEBQgFBQQEBQoHBwYIDAoMDAsKCwsNDhIQDQ4RDgsLEB"
    "YQERMUFRUVDA8XGBYUGBIUFRT/2wBDAQMEBAUEBQkFBQkUDQsNFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQU"
    "FBQUFBQUFBQUFBQUFBQUFBT/wAARCAAEAAgDAREAAhEBAxEB/8QAFAABAAAAAAAAAAAAAAAAAAAAB//EABQQAQAAAAAAAA"
    "AAAAAAAAAAAAD/xAAVAQEBAAAAAAAAAAAAAAAAAAAICf/EABQRAQAAAAAAAAAAAAAAAAAAAAD/2gAMAwEAAhEDEQA/AHhP"
    "om3/2Q==";

std::string error_of_picture(const std::string& bytes) {
  try {
    (void)io::decode_picture("p", bytes);
    return "";
  } catch (const io::FileError& error) {
    return error.what();
  }
}

TEST(Picture, AJpegIsDecoded) {
  const io::Image image = io::decode_picture("p.jpg", io::detail::from_base64(orange_jpeg));
  ASSERT_EQ(image.width, 8);
  ASSERT_EQ(image.height, 4);
  for (const auto& [x, y] : {std::pair(0, 0), std::pair(7, 3)}) {
    const std::uint8_t* const pixel = image.pixel(x, y);
    EXPECT_NEAR(pixel[0], 255, 3);
    EXPECT_NEAR(pixel[1], 165, 3);
    EXPECT_NEAR(pixel[2], 0, 3);
    EXPECT_EQ(pixel[3], 255);
  }
}

TEST(Picture, APngIsDecoded) {
  io::Image image(3, 2);
  for (std::size_t i = 0; i < image.rgba.size(); ++i) image.rgba[i] = static_cast<std::uint8_t>(i);
  EXPECT_EQ(io::decode_picture("p.png", io::to_png(image)), image);
}

TEST(Picture, WhatIsNoPictureIsRefused) {
  EXPECT_EQ(error_of_picture("GIF89a"), "p: is neither a PNG nor a JPEG");
  EXPECT_TRUE(error_of_picture("\xff\xd8\xff").starts_with("p: is damaged: "));
  EXPECT_TRUE(error_of_picture("\x89PNG\r\n").starts_with("p: is not a PNG picture: "));
}

/// A jump out of the library may not leave anything behind, whatever the bytes are.
TEST(Picture, EveryDamagedJpegIsRefusedOrRead) {
  const std::string good = io::detail::from_base64(orange_jpeg);
  for (std::size_t size = 3; size < good.size(); ++size)
    (void)error_of_picture(good.substr(0, size));
  for (std::size_t at = 3; at < good.size(); ++at)
    for (const char byte : {'\0', '\xff', '\x7f'}) {
      std::string other = good;
      other[at] = byte;
      (void)error_of_picture(other);
    }
}

}  // namespace
}  // namespace aomd::test::picture_test
