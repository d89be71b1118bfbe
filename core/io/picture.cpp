#include "core/io/picture.h"

#include <csetjmp>
#include <cstdio>
#include <memory>

#include <jpeglib.h>

#include "core/io/png_bytes.h"

namespace aomd::io {
namespace {

/// libjpeg ends by a jump where something is wrong: nothing with a destructor may live in between.
struct JpegFailure {
  jpeg_error_mgr manager;
  std::jmp_buf back;
  char words[JMSG_LENGTH_MAX];
};

void fail(j_common_ptr jpeg) {
  auto* const failure = reinterpret_cast<JpegFailure*>(jpeg->err);
  jpeg->err->format_message(jpeg, failure->words);
  std::longjmp(failure->back, 1);
}

void say_nothing(j_common_ptr, int) {}

/// What a decoder has in hand, freed on every way out.
class JpegReader {
 public:
  explicit JpegReader(std::string_view bytes) {
    jpeg_.err = jpeg_std_error(&failure_.manager);
    failure_.manager.error_exit = fail;
    failure_.manager.emit_message = say_nothing;
    created_ = setjmp(failure_.back) == 0 && begin(bytes);
  }
  ~JpegReader() { jpeg_destroy_decompress(&jpeg_); }
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;

  [[nodiscard]] bool good() const { return created_; }
  [[nodiscard]] const char* words() const { return failure_.words; }
  [[nodiscard]] unsigned width() const { return jpeg_.image_width; }
  [[nodiscard]] unsigned height() const { return jpeg_.image_height; }

  /// Rows of RGBA, as many as the picture has pixels.
  [[nodiscard]] bool read(std::uint8_t* rgba) {
    if (setjmp(failure_.back) != 0) return false;
    jpeg_.out_color_space = JCS_EXT_RGBA;
    jpeg_start_decompress(&jpeg_);
    while (jpeg_.output_scanline < jpeg_.output_height) {
      JSAMPROW row = rgba + std::size_t{4} * jpeg_.output_width * jpeg_.output_scanline;
      jpeg_read_scanlines(&jpeg_, &row, 1);
    }
    return true;
  }

 private:
  bool begin(std::string_view bytes) {
    jpeg_create_decompress(&jpeg_);
    jpeg_mem_src(&jpeg_, reinterpret_cast<const unsigned char*>(bytes.data()),
                 static_cast<unsigned long>(bytes.size()));
    jpeg_read_header(&jpeg_, TRUE);
    return true;
  }

  jpeg_decompress_struct jpeg_{};
  JpegFailure failure_{};
  bool created_ = false;
};

Image decode_jpeg(const std::string& name, std::string_view bytes) {
  JpegReader jpeg(bytes);
  if (!jpeg.good()) throw ReadError(name, {}, std::string("is damaged: ") + jpeg.words());
  if (std::uint64_t{jpeg.width()} * jpeg.height() > max_image_pixels)
    throw LimitError(name, {}, "the picture has more than 2^26 pixels");
  Image picture(static_cast<int>(jpeg.width()), static_cast<int>(jpeg.height()));
  if (!jpeg.read(picture.rgba.data()))
    throw ReadError(name, {}, std::string("is damaged: ") + jpeg.words());
  return picture;
}

}  // namespace

Image decode_picture(const std::string& name, std::string_view bytes) {
  if (bytes.starts_with("\xff\xd8\xff")) return decode_jpeg(name, bytes);
  if (!bytes.starts_with("\x89PNG")) throw ReadError(name, {}, "is neither a PNG nor a JPEG");
  return detail::decode_png(name, bytes);
}

}  // namespace aomd::io
