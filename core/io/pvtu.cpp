#include "core/io/pvtu.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <pugixml.hpp>

#include "core/base/text.h"
#include "core/io/formats.h"
#include "core/io/vtk_pieces.h"
#include "core/io/vtu_grid.h"

namespace aomd::io::detail {
namespace {

[[noreturn]] void fail_at(const Source& source, const pugi::xml_node& node,
                          const std::string& what) {
  source.fail_at_line(static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0)),
                      what);
}

std::filesystem::path piece_of(const Source& source, const pugi::xml_node& piece) {
  const std::string named = piece.attribute("Source").value();
  if (named.empty()) fail_at(source, piece, "a piece without a Source");
  const std::filesystem::path list = source.name;
  std::filesystem::path path = list.parent_path() / named;
  std::error_code problem;
  if (std::filesystem::equivalent(path, list, problem))
    fail_at(source, piece, "names itself as a piece: " + shown(named));
  return path;
}

}  // namespace

std::vector<std::filesystem::path> pvtu_pieces(const Source& source) {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed =
      document.load_buffer(source.bytes.data(), source.bytes.size());
  if (!parsed)
    source.fail_at_line(static_cast<std::size_t>(std::max<std::ptrdiff_t>(parsed.offset, 0)),
                        std::string("XML: ") + parsed.description());
  const pugi::xml_node root = document.document_element(), grid = root.child("PUnstructuredGrid");
  if (std::string_view(root.name()) != "VTKFile" || !grid)
    fail_at(source, root, "has no element PUnstructuredGrid");
  if (grid.attribute("GhostLevel").as_int() > 0)
    fail_at(source, grid, "has ghost cells, which are in several pieces: save it without");
  std::vector<std::filesystem::path> pieces;
  for (const pugi::xml_node piece : grid.children("Piece"))
    pieces.push_back(piece_of(source, piece));
  if (pieces.empty()) fail_at(source, grid, "names no pieces");
  return pieces;
}

ReadResult read_pvtu(const Source& source) {
  JoinedGrid joined;
  std::vector<std::string> notes;
  for (const std::filesystem::path& path : pvtu_pieces(source)) {
    const FileBytes bytes(path);
    VtuGrid piece = read_vtu_grid({path.string(), bytes.view()});
    if (piece.passed_over)
      notes.push_back(printable(path.filename().string()) + ": " + *piece.passed_over);
    joined.add(std::move(piece.grid), path);
  }
  const auto fail = [&](std::size_t cell, const std::string& what) {
    throw ReadError(joined.place_of(cell), {}, what);
  };
  ReadResult result = mesh_of(joined.finish(), source, fail);
  result.format = Format::Pvtu;
  result.notes.insert(result.notes.end(), notes.begin(), notes.end());
  return result;
}

}  // namespace aomd::io::detail
