#include "core/io/io.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <new>
#include <optional>
#include <utility>

#include "core/base/text.h"
#include "core/io/formats.h"
#include "core/io/losses.h"
#include "core/io/material_files.h"
#include "core/io/medit_solution.h"
#include "core/io/notes.h"
#include "core/io/output_files.h"
#include "core/io/output_target.h"
#include "core/io/text_cursor.h"
#include "core/io/text_file.h"
#include "core/mesh/orient_regions.h"

namespace aomd::io {
namespace {

using detail::Source;

/// First those that name one format each, in its order.
constexpr std::array<std::pair<std::string_view, Format>, 13> extensions{{{".obj", Format::Obj},
                                                                          {".ply", Format::Ply},
                                                                          {".off", Format::Off},
                                                                          {".stl", Format::Stl},
                                                                          {".gltf", Format::Gltf},
                                                                          {".msh", Format::Msh},
                                                                          {".mesh", Format::Medit},
                                                                          {".vtk", Format::Vtk},
                                                                          {".vtu", Format::Vtu},
                                                                          {".su2", Format::Su2},
                                                                          {".pvtu", Format::Pvtu},
                                                                          {".meshb", Format::Medit},
                                                                          {".glb", Format::Gltf}}};

std::optional<Format> format_of_name(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  return extension.empty() ? std::nullopt : format_named(std::string_view(extension).substr(1));
}

std::string_view extension_of(Format format) {
  return extensions[static_cast<std::size_t>(format)].first;
}

/// The first word that is no comment; SU2's comments start with a percent sign, other formats' with
/// "#".
std::string_view first_word(const Source& source) {
  detail::TextCursor cursor(source, source.bytes, 0, '#');
  cursor.skip_to_content();
  detail::TextCursor other(source, source.bytes, cursor.offset(), '%');
  return other.skip_to_content() ? std::string_view() : other.word();
}

/// Whether the root of a VTK XML file says so.
bool is_list_of_pieces(const Source& source) {
  const std::size_t root = source.bytes.find("<VTKFile");
  const std::size_t end = source.bytes.find('>', root);
  return end != std::string_view::npos &&
         source.bytes.substr(root, end - root).find("PUnstructuredGrid") != std::string_view::npos;
}

/// What the content is beyond doubt, if anything.
std::optional<Format> format_of_content(const Source& source) {
  if (detail::is_vtk(source.bytes)) return Format::Vtk;
  if (detail::is_binary_stl(source.bytes)) return Format::Stl;
  if (detail::is_binary_medit(source.bytes)) return Format::Medit;
  if (source.bytes.starts_with("glTF")) return Format::Gltf;
  const std::string_view word = first_word(source);
  if (word.starts_with("{")) return Format::Gltf;
  if (lower(word.substr(0, 4)) == "ply") return Format::Ply;
  if (word.starts_with("$MeshFormat") || word == "$Comments" || word == "$NOD") return Format::Msh;
  if (word.starts_with("<VTKFile") || word.starts_with("<?xml"))
    return is_list_of_pieces(source) ? Format::Pvtu : Format::Vtu;
  if (lower(word.substr(0, 20)) == "meshversionformatted") return Format::Medit;
  if (const std::string key = lower(word.substr(0, 5)); key == "ndime" || key == "nzone")
    return Format::Su2;
  if (detail::is_off(word)) return Format::Off;
  if (lower(word.substr(0, 6)) == "solid") return Format::Stl;
  constexpr std::string_view obj_words[] = {"v", "vn", "vt", "f", "o", "g", "mtllib", "usemtl"};
  const std::string small = lower(word.substr(0, 8));
  if (std::find(std::begin(obj_words), std::end(obj_words), small) != std::end(obj_words))
    return Format::Obj;
  return {};
}

/// Text that calls itself "solid". Binary files may do so too, and with bytes too few or too many
/// their size does not tell: but zeros come in them before any facet is named.
bool is_text_stl(const Source& source) {
  if (detail::is_binary_stl(source.bytes)) return false;
  detail::TextCursor cursor(source, source.bytes);
  cursor.pass_comment_lines();
  cursor.skip_to_content();
  if (lower(cursor.word().substr(0, 6)) != "solid") return false;
  const std::size_t zero = source.bytes.find('\0');
  if (zero == std::string_view::npos) return true;
  const std::string start = lower(source.bytes.substr(0, std::min<std::size_t>(zero, 1000)));
  return start.find("facet") != std::string::npos;
}

ReadResult read_as(Format format, const Source& source) {
  switch (format) {
    case Format::Obj:
      return detail::read_obj(source);
    case Format::Ply:
      return detail::read_ply(source);
    case Format::Off:
      return detail::read_off(source);
    case Format::Msh:
      return detail::read_msh(source);
    case Format::Medit:
      return detail::read_medit(source);
    case Format::Vtk:
      return detail::read_vtk(source);
    case Format::Vtu:
      return detail::read_vtu(source);
    case Format::Pvtu:
      return detail::read_pvtu(source);
    case Format::Su2:
      return detail::read_su2(source);
    case Format::Gltf:
      return detail::read_gltf(source);
    case Format::Stl:
      break;
  }
  return detail::read_stl(source, !is_text_stl(source));
}

/// What people hand to a mesh program that no reader takes, by its first bytes, and what helps.
constexpr std::array<std::pair<std::string_view, std::string_view>, 11> foreign{
    {{std::string_view("\xff\xfe\0\0", 4), "is text in UTF-32: save it as UTF-8"},
     {std::string_view("\0\0\xfe\xff", 4), "is text in UTF-32: save it as UTF-8"},
     {"\xff\xfe", "is text in UTF-16: save it as UTF-8"},
     {"\xfe\xff", "is text in UTF-16: save it as UTF-8"},
     {"\x1f\x8b", "is compressed by gzip: unpack it first"},
     {"BZh", "is compressed by bzip2: unpack it first"},
     {"\xfd"
      "7zXZ",
      "is compressed by xz: unpack it first"},
     {"PK\x03\x04", "is a ZIP archive: unpack it first, or export .stl instead of .3mf"},
     {"ISO-10303-21", "is a STEP file, which holds surfaces but no mesh: mesh it first"},
     {"Kaydara FBX", "is an FBX file: export .ply or .obj"},
     {"\x89HDF", "is an HDF5 file: export .vtu or .msh"}}};

/// Text in UTF-16 that does not say so: every second byte is zero.
bool is_wide_text(std::string_view bytes) {
  if (bytes.size() < 4) return false;
  const auto zero = [&](std::size_t i) { return bytes[i] == '\0'; };
  return zero(0) != zero(1) && zero(0) == zero(2) && zero(1) == zero(3);
}

void refuse_foreign(const Source& source) {
  if (is_wide_text(source.bytes)) source.fail("is text in UTF-16: save it as UTF-8");
  for (const auto& [start, what] : foreign) {
    if (source.bytes.starts_with(start)) source.fail(std::string(what));
  }
}

/// Regions that the file lists inside out are listed the other way round; a note counts them.
void orient(ReadResult& result) {
  result.turned = orient_regions(result.mesh);
  std::array<std::size_t, builtin_shapes> counts{};
  for (const std::uint32_t region : result.turned)
    ++counts[static_cast<std::size_t>(result.mesh.regions.shapes[region])];
  std::vector<std::string> words;
  for (std::size_t shape = 0; shape < counts.size(); ++shape)
    if (counts[shape] > 0)
      words.push_back(counted(counts[shape], shape_template(static_cast<Shape>(shape)).name));
  if (!words.empty())
    result.notes.push_back(joined(words, " and ") + " listed inside out renumbered");
}

ReadResult read_source(const Source& source) {
  const auto named = format_of_name(source.name);
  const auto found = format_of_content(source);
  if (!found) refuse_foreign(source);
  if (!found && !named)
    source.fail(
        "is in no format that is known here: .obj, .ply, .off, .stl, .gltf, .glb, .msh, .mesh, "
        ".meshb, .vtk, .vtu, .pvtu or .su2");
  ReadResult result = read_as(found ? *found : *named, source);
  detail::rename_repeated(result.mesh.attributes, result.notes);
  if (found && named && *found != *named) {
    result.notes.push_back("read as " + std::string(extension_of(*found)) +
                           ", which is what the content is");
  }
  orient(result);
  result.notes = limited_lines(std::move(result.notes));
  return result;
}

/// The free header of a binary STL may begin with a byte order mark too.
Source source_of(const std::string& name, std::string_view bytes) {
  const Source whole{name, bytes};
  return detail::is_binary_stl(bytes) ? whole : detail::without_mark(whole);
}

bool writes_binary(const std::filesystem::path& path, Format format, const MeshData& mesh,
                   const WriteOptions& options) {
  // Programs tell binary Medit from text by the extension alone.
  const std::string extension = lower(path.extension().string());
  if (format == Format::Medit) return extension == ".meshb";
  if (format == Format::Gltf && (extension == ".glb" || extension == ".gltf"))
    return extension == ".glb";
  if (format == Format::Gltf) return options.binary.value_or(true);
  // Binary STL has no solids, and few programs read binary OFF.
  return options.binary.value_or(format == Format::Ply || format == Format::Pvtu ||
                                 (format == Format::Stl && mesh.faces.classes.empty()));
}

/// Why the format cannot hold what the mesh is made of, or an empty string.
std::string_view misfit(Format format, const MeshData& mesh, const WriteOptions& options) {
  if (format == Format::Pvtu && !options.beside)
    return "a .pvtu has its pieces in files beside it: it needs a place in a folder";
  constexpr std::size_t most_vtk_vertices = std::numeric_limits<std::int32_t>::max();
  for (int d = 1; d <= 3; ++d) {
    const std::vector<Shape>& shapes = mesh.list(d).shapes;
    if (std::any_of(shapes.begin(), shapes.end(),
                    [](Shape s) { return s >= Shape{builtin_shapes}; }))
      return "no format holds entities of shapes that a program adds";
  }
  if (!mesh.regions.empty() && format < Format::Msh)
    return "this format holds surfaces, and the mesh has regions: write .msh, .mesh, .vtk, .vtu or "
           ".su2";
  if (format == Format::Vtk && mesh.positions.size() > most_vtk_vertices)
    return "the format holds at most 2^31 - 1 vertices: write .vtu";
  if (format == Format::Su2 && mesh.regions.empty() &&
      std::any_of(mesh.positions.begin(), mesh.positions.end(),
                  [](const glm::dvec3& p) { return p.z != 0; }))
    return "this format holds regions, or faces in the plane z = 0, and the mesh is a surface in "
           "space";
  return {};
}

void check_writable(const std::filesystem::path& path, Format format, const MeshData& mesh,
                    const WriteOptions& options, bool single_precision) {
  const std::string_view why = misfit(format, mesh, options);
  if (!why.empty()) throw WriteError(path.string(), {}, std::string(why));
  const double limit =
      single_precision ? std::numeric_limits<float>::max() : std::numeric_limits<double>::max();
  for (const glm::dvec3& p : mesh.positions) {
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(p[axis]) <= limit) continue;
      throw WriteError(path.string(), {},
                       single_precision ? "a coordinate is too large for 32-bit floats: write " +
                                              std::string(detail::exact_form(format))
                                        : "a coordinate is not a finite number");
    }
  }
  const std::string lost =
      single_precision ? detail::rounding_defect(mesh, detail::exact_form(format)) : std::string();
  if (!lost.empty()) throw WriteError(path.string(), {}, lost);
}

std::string bytes_of(Format format, bool binary, const MeshData& mesh,
                     const WriteOptions& options) {
  switch (format) {
    case Format::Off:
      return detail::write_off(mesh, binary);
    case Format::Msh:
      return detail::write_msh(mesh, binary, options.msh2);
    case Format::Medit:
      return detail::write_medit(mesh, binary);
    case Format::Vtk:
      return detail::write_vtk(mesh, binary);
    case Format::Vtu:
      return detail::write_vtu(mesh, binary);
    case Format::Su2:
      return detail::write_su2(mesh);
    case Format::Stl:
    case Format::Gltf:
    case Format::Obj:
    case Format::Ply:
    case Format::Pvtu:
      break;
  }
  return detail::write_stl(mesh, binary);
}

/// Pipes and standard output have no place beside them. What is wrong with a path is said when it
/// is written.
bool has_place_beside(const std::filesystem::path& path) {
  try {
    return detail::find_output_target(path).kind == detail::OutputTarget::Kind::File;
  } catch (const WriteError&) {
    return true;
  }
}

/// Formats of one file, and those of several.
void encode(const std::filesystem::path& path, Format format, bool binary, const MeshData& mesh,
            const WriteOptions& options, EncodedMesh& encoded) {
  if (format == Format::Gltf)
    return detail::write_gltf(path, mesh, binary, options.beside, encoded);
  if (format == Format::Pvtu)
    return detail::write_pvtu(path, mesh, binary, options.pieces, encoded);
  if (format == Format::Obj)
    encoded.bytes =
        detail::write_obj(mesh, options.beside ? detail::libraries_for(path, mesh, encoded)
                                               : detail::named_libraries(mesh));
  else if (format == Format::Ply)
    encoded.bytes = detail::write_ply(
        mesh, binary, options.beside ? detail::ply_remarks_for(path, mesh, encoded) : mesh.remarks);
  else
    encoded.bytes = bytes_of(format, binary, mesh, options);
  const std::filesystem::path solution = solution_beside(path);
  if (format != Format::Medit || !options.beside || solution.empty()) return;
  if (std::string arrays = detail::write_solution(mesh, binary); !arrays.empty())
    encoded.beside.push_back({solution.filename().string(), std::move(arrays)});
}

void note_what_is_left(const std::filesystem::path& file, EncodedMesh& encoded) {
  encoded.notes.push_back(printable(file.filename().string()) +
                          " is there from before, and does not belong to the mesh");
}

/// The arrays that stand beside a Medit mesh.
void add_solution(const std::filesystem::path& path, ReadResult& result) {
  const std::filesystem::path beside = solution_beside(path);
  std::error_code ignored;
  if (beside.empty() || !std::filesystem::is_regular_file(beside, ignored)) return;
  if (!result.whole) {
    result.notes.push_back(printable(beside.filename().string()) +
                           " left out: the mesh is not as its file has it");
    return;
  }
  const detail::FileBytes bytes(beside);
  detail::read_solution({beside.string(), bytes.view()}, result.mesh);
  detail::rename_repeated(result.mesh.attributes, result.notes);
}

}  // namespace

ReadResult read(const std::filesystem::path& path) {
  const detail::FileBytes bytes(path);
  ReadResult result = read_bytes(path.string(), bytes.view());
  if (result.format == Format::Medit) add_solution(path, result);
  detail::add_materials(path, result);
  return result;
}

std::filesystem::path solution_beside(const std::filesystem::path& mesh) {
  const std::string extension = lower(mesh.extension().string());
  if (extension != ".mesh" && extension != ".meshb") return {};
  return std::filesystem::path(mesh).replace_extension(extension == ".mesh" ? ".sol" : ".solb");
}

std::filesystem::path piece_beside(const std::filesystem::path& list, std::size_t piece) {
  return list.parent_path() / (list.stem().string() + '_' + std::to_string(piece) + ".vtu");
}

void add_mesh(OutputFiles& files, const std::filesystem::path& path, EncodedMesh& encoded) {
  files.add(path, encoded.bytes);
  for (const EncodedMesh::Beside& file : encoded.beside)
    files.add(path.parent_path() / file.name, file.bytes);
  const std::filesystem::path arrays = solution_beside(path);
  std::error_code ignored;
  if (encoded.beside.empty() && !arrays.empty() && std::filesystem::exists(arrays, ignored))
    note_what_is_left(arrays, encoded);
  if (lower(path.extension().string()) != ".pvtu") return;
  if (const auto next = piece_beside(path, encoded.beside.size());
      std::filesystem::exists(next, ignored))
    note_what_is_left(next, encoded);
}

ReadResult read_bytes(const std::string& name, std::string_view bytes) {
  const Source source = source_of(name, bytes);
  if (source.bytes.empty()) source.fail("is empty");
  try {
    return read_source(source);
  } catch (const std::bad_alloc&) {
    throw LimitError(name, {}, "the mesh does not fit into memory");
  }
}

Format format_for_writing(const std::filesystem::path& path) {
  const auto format = format_of_name(path);
  if (format == Format::Gltf && !detail::has_gltf()) (void)to_bytes(path, *format, {});
  if (format) return *format;
  throw WriteError(
      path.string(), {},
      "the extension names no format: .obj, .ply, .off, .stl, .gltf, .glb, .msh, .mesh, .meshb, "
      ".vtk, .vtu, .pvtu or .su2");
}

std::optional<Format> format_named(std::string_view extension) {
  const std::string wanted = lower(extension);
  for (const auto& [name, format] : extensions)
    if (wanted == name.substr(1)) return format;
  return {};
}

EncodedMesh to_bytes(const std::filesystem::path& name, Format format, const MeshData& mesh,
                     const WriteOptions& options) {
  WriteOptions how = options;
  how.beside = options.beside && has_place_beside(name);
  const bool binary = writes_binary(name, format, mesh, how);
  const bool rounds =
      format == Format::Gltf || (binary && (format == Format::Stl || format == Format::Off));
  check_writable(name, format, mesh, how, rounds);
  EncodedMesh result;
  const bool beside = format == Format::Medit && how.beside && !solution_beside(name).empty();
  detail::note_losses(format, binary, beside, mesh, result.notes);
  if (rounds) detail::note_rounding(mesh, detail::exact_form(format), result.notes);
  encode(name, format, binary, mesh, how, result);
  result.notes = limited_lines(std::move(result.notes));
  return result;
}

std::vector<std::string> write(const std::filesystem::path& path, const MeshData& mesh,
                               const WriteOptions& options) {
  EncodedMesh encoded = to_bytes(path, format_for_writing(path), mesh, options);
  OutputFiles files;
  add_mesh(files, path, encoded);
  files.commit();
  return std::move(encoded.notes);
}

namespace detail {

bool fits_float(const MeshData& mesh) {
  const auto fits = [](double x) { return static_cast<double>(static_cast<float>(x)) == x; };
  return std::all_of(mesh.positions.begin(), mesh.positions.end(),
                     [&](const glm::dvec3& p) { return fits(p.x) && fits(p.y) && fits(p.z); });
}

}  // namespace detail
}  // namespace aomd::io
