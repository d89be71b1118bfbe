#include "core/io/streamed_file.h"

#include <algorithm>
#include <fstream>

#include "core/base/text.h"
#include "core/io/error.h"
#include "core/io/streamed_ply.h"
#include "core/io/streamed_stl.h"
#include "core/io/streamed_vtu.h"

namespace aomd::io::detail {
namespace {

constexpr std::size_t bytes_a_piece = 1 << 20;

[[noreturn]] void refuse_in_blocks(const std::string& name, const std::string& what) {
  throw ReadError(name, {},
                  what +
                      " cannot be read in blocks, only as a whole: aomd convert makes a binary "
                      "PLY of it");
}

}  // namespace

void StreamedFile::refuse(const std::string& what) const { refuse_in_blocks(name_, what); }

void StreamedFile::each_piece(std::uint64_t begin, std::size_t size, std::uint64_t count,
                              const VisitPiece& visit) const {
  std::ifstream file(path_, std::ios::binary);
  if (!file) throw ReadError(name_, {}, "cannot be opened");
  const std::uint64_t a_piece = std::max<std::uint64_t>(1, bytes_a_piece / size);
  std::string bytes;
  file.seekg(static_cast<std::streamoff>(begin));
  for (std::uint64_t first = 0; first < count; first += a_piece) {
    const std::uint64_t some = std::min(a_piece, count - first);
    bytes.resize(some * size);
    if (!file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
      throw ReadError(name_, {}, "has become shorter while it was read");
    visit(Source{name_, bytes, begin + first * size}, some);
  }
}

std::unique_ptr<const StreamedFile> open_streamed(const std::filesystem::path& path) {
  const std::string name = path.string();
  std::error_code problem;
  if (!std::filesystem::is_regular_file(path, problem)) throw ReadError(name, {}, "is no file");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw ReadError(name, {}, "cannot be opened");
  std::string head(1024, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  if (head.empty()) throw ReadError(name, {}, "is empty");
  if (head.starts_with("ply")) return std::make_unique<StreamedPly>(path);
  if (head.starts_with("<VTKFile") || head.starts_with("<?xml"))
    return std::make_unique<StreamedVtu>(path);
  if (StreamedStl::is_binary(head, std::filesystem::file_size(path)))
    return std::make_unique<StreamedStl>(path);
  if (lower(path.extension().string()) != ".stl")
    refuse_in_blocks(name, "what is no PLY, STL or VTU");
  if (lower(head.substr(0, 5)) == "solid" && head.find('\0') == std::string::npos)
    refuse_in_blocks(name, "STL as text");
  return std::make_unique<StreamedStl>(path);
}

}  // namespace aomd::io::detail
