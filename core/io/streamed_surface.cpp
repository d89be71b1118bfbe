#include "core/io/streamed_surface.h"

#include <algorithm>
#include <utility>

#include "core/base/box.h"
#include "core/base/text.h"
#include "core/base/vertex_ranks.h"
#include "core/io/pvtu.h"
#include "core/io/streamed_file.h"
#include "core/io/tile_borders.h"
#include "core/mesh/handle.h"

namespace aomd::io {

using detail::StreamedFile;
using detail::TileBorders;

struct StreamedSurface::Tiles {
  std::string name;
  detail::StreamedFiles files;
  std::vector<std::uint32_t> first_vertex{0};  ///< of each, and the number of all
  std::uint32_t faces = 0;
  TileBorders borders;

  Tiles(const std::filesystem::path& path, const Weld& weld);
  void add(const std::filesystem::path& path);
  [[nodiscard]] double length_of(const Weld& weld) const;
};

namespace {

/// The tiles of a folder by name: its PLY files; where it has none its STL files, else VTU.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const char* extension : {".ply", ".stl", ".vtu"}) {
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.is_regular_file() && entry.path().extension() == extension)
        files.push_back(entry.path());
    if (!files.empty()) break;
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::filesystem::path> files_of(const std::filesystem::path& path) {
  std::error_code problem;
  if (std::filesystem::is_directory(path, problem)) return files_in(path);
  if (lower(path.extension().string()) != ".pvtu") return {path};
  const detail::FileBytes list(path);
  return detail::pvtu_pieces({path.string(), list.view()});
}

}  // namespace

StreamedSurface::Tiles::Tiles(const std::filesystem::path& path, const Weld& weld)
    : name(path.string()) {
  const std::vector<std::filesystem::path> paths = files_of(path);
  if (paths.empty()) throw ReadError(name, {}, "has no .ply, .stl or .vtu files");
  for (const auto& file : paths) add(file);
  if (files.empty()) throw ReadError(name, {}, "has no vertices or no faces");
  if (files.size() == 1) return;
  try {
    borders = TileBorders(files, first_vertex, length_of(weld));
  } catch (const detail::WeldTooWide&) {
    throw LimitError(name, {}, "dozens of border vertices lie within the tolerance of each other");
  }
}

double StreamedSurface::Tiles::length_of(const Weld& weld) const {
  if (!weld.of_diagonal || weld.tolerance == 0) return weld.tolerance;
  Box box;
  for (const auto& file : files)
    file->each_vertices([&](std::span<const glm::dvec3> positions, std::string_view) {
      for (const glm::dvec3& p : positions) box.add(p);
    });
  return weld.tolerance * box.diagonal();
}

void StreamedSurface::Tiles::add(const std::filesystem::path& path) {
  auto opened = detail::open_streamed(path);
  if (opened->vertices() == 0) return;  // a part of a list may be empty
  files.push_back(std::move(opened));
  const StreamedFile& file = *files.back();
  if (file.kind_of_records() != files.front()->kind_of_records())
    throw ReadError(file.name(), {}, "has other properties than " + files.front()->name());
  const std::uint64_t vertices = std::uint64_t{first_vertex.back()} + file.vertices();
  if (std::max(vertices, std::uint64_t{faces} + file.faces()) >= no_index)
    throw LimitError(name, {}, "has more than 4294967294 vertices or faces");
  first_vertex.push_back(static_cast<std::uint32_t>(vertices));
  faces += file.faces();
}

StreamedSurface::StreamedSurface(const std::filesystem::path& path, const Weld& weld)
    : tiles_(std::make_unique<const Tiles>(path, weld)) {}
StreamedSurface::~StreamedSurface() = default;
StreamedSurface::StreamedSurface(StreamedSurface&&) noexcept = default;
StreamedSurface& StreamedSurface::operator=(StreamedSurface&&) noexcept = default;

const std::string& StreamedSurface::name() const { return tiles_->name; }
std::uint32_t StreamedSurface::vertices() const { return tiles_->first_vertex.back(); }
std::uint32_t StreamedSurface::faces() const { return tiles_->faces; }
std::vector<std::string> StreamedSurface::left_out() const {
  return tiles_->files.front()->left_out();
}

void StreamedSurface::each_vertex_records(const VisitVertices& visit) const {
  std::uint32_t first = 0;
  for (const auto& file : tiles_->files)
    file->each_vertices([&](std::span<const glm::dvec3> positions, std::string_view records) {
      visit(first, positions, records);
      first += static_cast<std::uint32_t>(positions.size());
    });
}

void StreamedSurface::each_face_records(const VisitFaces& visit) const {
  std::uint32_t first = 0;
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < tiles_->files.size(); ++i)
    tiles_->files[i]->each_faces([&](std::span<const Triangle> own, std::string_view records) {
      triangles.assign(own.begin(), own.end());
      for (Triangle& t : triangles)
        for (std::uint32_t& v : t) v = tiles_->borders.of(tiles_->first_vertex[i] + v);
      visit(first, triangles, records);
      first += static_cast<std::uint32_t>(own.size());
    });
}

void StreamedSurface::each_vertices(
    const std::function<void(std::uint32_t, std::span<const glm::dvec3>)>& visit) const {
  each_vertex_records([&](std::uint32_t first, std::span<const glm::dvec3> positions,
                          std::string_view) { visit(first, positions); });
}

void StreamedSurface::each_faces(
    const std::function<void(std::uint32_t, std::span<const Triangle>)>& visit) const {
  each_face_records([&](std::uint32_t first, std::span<const Triangle> triangles,
                        std::string_view) { visit(first, triangles); });
}

StreamedSurface::Part StreamedSurface::part(
    const std::function<bool(const Triangle&)>& wanted) const {
  const StreamedFile& kind = *tiles_->files.front();
  std::string vertex_records, face_records;
  std::vector<Triangle> triangles;
  VertexRanks used(vertices());
  each_face_records([&](std::uint32_t, std::span<const Triangle> some, std::string_view records) {
    for (std::size_t i = 0; i < some.size(); ++i) {
      if (!wanted(some[i])) continue;
      triangles.push_back(some[i]);
      face_records += kind.face_record(records, i);
      for (const std::uint32_t v : some[i]) used.add(v);
    }
  });
  used.finish();
  Part part;
  each_vertex_records(
      [&](std::uint32_t first, std::span<const glm::dvec3> positions, std::string_view records) {
        for (std::uint32_t i = 0; i < positions.size(); ++i) {
          if (!used.has(first + i)) continue;
          part.ids.push_back(first + i);
          vertex_records += kind.vertex_record(records, i);
        }
      });
  for (Triangle& t : triangles)
    for (std::uint32_t& v : t) v = used.rank(v);
  part.mesh = kind.mesh_of(vertex_records, std::move(face_records), triangles);
  part.mesh.faces.classes.clear();
  part.mesh.vertex_classes.clear();
  return part;
}

}  // namespace aomd::io
