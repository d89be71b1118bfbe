// glTF 2.0, as .gltf and as .glb: the meshes of a scene at their places.

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <unordered_map>

#include <glm/matrix.hpp>
#include <nlohmann/json.hpp>

#include "core/base/text.h"
#include "core/io/face_sink.h"
#include "core/io/formats.h"
#include "core/io/gltf_columns.h"
#include "core/io/gltf_materials.h"
#include "core/io/gltf_scene.h"
#include "core/io/named_faces.h"
#include "core/io/named_parts.h"
#include "core/io/weld.h"
#include "core/mesh/handle.h"

namespace aomd::io::detail {
namespace {

using Json = nlohmann::json;

/// A primitive by the rows of its accessors: triangles, line segments or points, one at the other.
struct Piece {
  const tinygltf::Primitive* primitive;
  std::size_t corners = 3;  ///< of each: 3, 2 or 1
  std::vector<std::uint32_t> list;
  std::vector<std::uint32_t> rows;  ///< that occur in the list, in ascending order
  int positions = 0;                ///< their accessor
};

void add_strip(std::span<const std::uint32_t> at, std::vector<std::uint32_t>& out) {
  for (std::size_t i = 2; i < at.size(); ++i) {
    const std::uint32_t a = at[i - 2], b = at[i - 1], c = at[i];
    if (a == b || b == c || c == a) continue;  // goes on elsewhere
    const std::array triangle = i % 2 == 0 ? std::array{a, b, c} : std::array{b, a, c};
    out.insert(out.end(), triangle.begin(), triangle.end());
  }
}

void add_fan(std::span<const std::uint32_t> at, std::vector<std::uint32_t>& out) {
  for (std::size_t i = 2; i < at.size(); ++i) {
    const std::array triangle{at[0], at[i - 1], at[i]};
    out.insert(out.end(), triangle.begin(), triangle.end());
  }
}

void add_path(std::span<const std::uint32_t> at, bool closed, std::vector<std::uint32_t>& out) {
  for (std::size_t i = 1; i < at.size(); ++i) out.insert(out.end(), {at[i - 1], at[i]});
  if (closed && at.size() > 2) out.insert(out.end(), {at.back(), at.front()});
}

/// The vertices of one mesh at one place: those at one point are one, unless the file numbers them.
class PointWelder {
 public:
  explicit PointWelder(std::vector<glm::dvec3>& positions) : positions_(positions) {}

  std::uint32_t add(const glm::dvec3& raw, const glm::dvec3& placed) {
    const std::uint32_t i = points_.add(raw);
    if (i == of_point_.size()) of_point_.push_back(put(placed));
    return of_point_[i];
  }

  std::uint32_t add_numbered(std::uint64_t number, const glm::dvec3& placed) {
    const auto [at, is_new] = numbered_.try_emplace(number, 0);
    if (is_new || positions_[at->second] != placed) at->second = put(placed);
    return at->second;
  }

 private:
  std::uint32_t put(const glm::dvec3& placed) {
    positions_.push_back(placed);
    return static_cast<std::uint32_t>(positions_.size() - 1);
  }

  std::vector<glm::dvec3>& positions_;
  Welder points_;
  std::vector<std::uint32_t> of_point_;
  std::unordered_map<std::uint64_t, std::uint32_t> numbered_;
};

class GltfReader {
 public:
  explicit GltfReader(const Source& source) : source_(source), file_(source) {}

  ReadResult read() {
    faces_.keep_origins();
    take_materials();
    for (const GltfInstance& instance : scene_of(file_)) {
      add(instance);
      numbers_.clear();
    }
    result_.format = Format::Gltf;
    MeshData& mesh = result_.mesh;
    faces_.finish(mesh, result_.notes);
    parts_.finish(result_);
    columns_.finish(mesh, use_of_corner_, faces_.origins());
    note_left_out(result_.notes, left_out_);
    drop_empty_classes(mesh);
    return std::move(result_);
  }

 private:
  void take_materials();
  [[nodiscard]] std::uint32_t picture_of(std::uint64_t texture);
  void add(const GltfInstance& instance);

  /// Numbers of the mesh at hand, each accessor once.
  const GltfNumbers& numbers(int accessor) {
    const auto known = numbers_.find(accessor);
    if (known != numbers_.end()) return known->second;
    const GltfNumbers& read =
        numbers_.emplace(accessor, read_accessor(file_, accessor)).first->second;
    count(read.values.size());
    return read;
  }

  /// Meshes at many places, and accessors of one view, are more than the file is long.
  void count(std::size_t n) {
    constexpr std::uint64_t usual = std::uint64_t{1} << 24, most_for_a_byte = 32;
    counted_ += n;
    if (counted_ > usual + most_for_a_byte * file_.size())
      throw LimitError(source_.name, {},
                       "the scene comes to more than " + counted(most_for_a_byte, "number") +
                           " for each byte of the file");
  }

  Piece piece_of(const tinygltf::Primitive& primitive) {
    if (primitive.extensions.contains("KHR_draco_mesh_compression"))
      source_.fail("is compressed by Draco, which cannot be read: export it without compression");
    const auto positions = primitive.attributes.find("POSITION");
    Piece piece{&primitive, 3, {}, {}, -1};
    if (positions == primitive.attributes.end()) {
      left_out_.add("primitives without positions");
      return piece;
    }
    piece.positions = positions->second;
    const GltfNumbers& points = numbers(piece.positions);
    if (points.components != 3)
      source_.fail("accessor " + std::to_string(piece.positions) + " is no list of positions");
    arrange(piece, indices_of(primitive, points.size()));
    count(2 * piece.list.size());
    piece.rows = piece.list;
    std::sort(piece.rows.begin(), piece.rows.end());
    piece.rows.erase(std::unique(piece.rows.begin(), piece.rows.end()), piece.rows.end());
    return piece;
  }

  std::vector<std::uint32_t> indices_of(const tinygltf::Primitive& primitive, std::size_t points) {
    std::vector<std::uint32_t> list;
    if (primitive.indices < 0) {
      for (std::size_t i = 0; i < points; ++i) list.push_back(static_cast<std::uint32_t>(i));
      return list;
    }
    list = read_indices(file_, primitive.indices);
    for (const std::uint32_t i : list)
      if (i >= points)
        source_.fail("accessor " + std::to_string(primitive.indices) + " names vertex " +
                     std::to_string(i) + ", and there are " + std::to_string(points));
    return list;
  }

  void arrange(Piece& piece, std::vector<std::uint32_t> at) {
    const int mode = piece.primitive->mode;
    piece.corners = mode == TINYGLTF_MODE_POINTS ? 1 : mode <= TINYGLTF_MODE_LINE_STRIP ? 2 : 3;
    switch (mode) {
      case TINYGLTF_MODE_LINE_LOOP:
      case TINYGLTF_MODE_LINE_STRIP:
        return add_path(at, mode == TINYGLTF_MODE_LINE_LOOP, piece.list);
      case TINYGLTF_MODE_TRIANGLE_STRIP:
        return add_strip(at, piece.list);
      case TINYGLTF_MODE_TRIANGLE_FAN:
        return add_fan(at, piece.list);
      case TINYGLTF_MODE_POINTS:
      case TINYGLTF_MODE_LINE:
      case TINYGLTF_MODE_TRIANGLES:
        break;
      default:
        source_.fail("a primitive has mode " + std::to_string(mode) + ", and there are 0 to 6");
    }
    if (at.size() % piece.corners != 0)
      source_.fail("a primitive of " + counted(at.size(), "vertex") + " ends within " +
                   (piece.corners == 3 ? "a triangle" : "a line"));
    piece.list = std::move(at);
  }

  std::vector<std::uint32_t> vertices_of(const std::vector<Piece>& pieces, int positions,
                                         PointWelder& welder);
  void add_piece(const Piece& piece, const std::vector<std::uint32_t>& vertex_of_row);
  void enter_names(const tinygltf::Primitive& primitive);

  const Source& source_;
  GltfFile file_;
  ReadResult result_;
  FaceSink faces_{no_index};
  NamedParts parts_;
  GltfColumns columns_;
  ItemList left_out_{file_.left_out()};
  std::map<int, GltfNumbers> numbers_;
  std::vector<std::uint32_t> use_of_corner_;
  std::uint64_t counted_ = 0;
  std::string object_;  ///< the name of the instance at hand
  glm::dmat4 place_{1};
  glm::dmat3 turn_{1};
  bool mirrored_ = false;
};

/// Names are made different: by them labels and materials belong together.
void GltfReader::take_materials() {
  const tinygltf::Model& model = file_.model();
  Appearance& looks = result_.mesh.appearance;
  looks.pictures = file_.pictures();
  Json texts = Json::parse(file_.materials(), nullptr, false);
  std::set<std::string> known{""};
  for (const tinygltf::Material& m : model.materials) {
    const auto& pbr = m.pbrMetallicRoughness;
    Material material;
    material.name = m.name.empty() ? "material" : m.name;
    for (int k = 2; !known.insert(material.name).second; ++k)
      material.name = (m.name.empty() ? "material" : m.name) + " (" + std::to_string(k) + ")";
    for (std::size_t k = 0; k < std::min<std::size_t>(4, pbr.baseColorFactor.size()); ++k)
      material.colour[k] = pbr.baseColorFactor[k];
    const int texture = pbr.baseColorTexture.index;
    if (texture >= 0) material.picture = picture_of(static_cast<std::uint64_t>(texture));
    material.metallic = pbr.metallicFactor, material.roughness = pbr.roughnessFactor;
    material.two_sided = m.doubleSided;
    const std::string rest =
        rest_of_material(texts[looks.materials.size()], material.name,
                         [this](std::uint64_t other) { return picture_of(other); });
    if (!rest.empty()) result_.mesh.remarks.push_back({gltf_material, rest});
    looks.materials.push_back(std::move(material));
  }
}

std::uint32_t GltfReader::picture_of(std::uint64_t texture) {
  const auto& textures = file_.model().textures;
  const auto picture = texture < textures.size()
                           ? static_cast<std::uint32_t>(textures[texture].source)
                           : Material::no_picture;
  if (picture < result_.mesh.appearance.pictures.size()) return picture;
  left_out_.add("pictures that are not there");
  return Material::no_picture;
}

void GltfReader::add(const GltfInstance& instance) {
  const tinygltf::Mesh& mesh = file_.model().meshes[static_cast<std::size_t>(instance.mesh)];
  place_ = instance.place;
  object_ = instance.name;
  const glm::dmat3 linear(place_);
  const double volume = glm::determinant(linear);
  mirrored_ = volume < 0;
  turn_ =
      linear == glm::dmat3(1) || volume == 0 ? glm::dmat3(1) : glm::transpose(glm::inverse(linear));
  std::vector<Piece> pieces;
  for (const tinygltf::Primitive& primitive : mesh.primitives)
    if (Piece piece = piece_of(primitive); !piece.list.empty()) pieces.push_back(std::move(piece));
  PointWelder welder(result_.mesh.positions);
  std::map<int, std::vector<std::uint32_t>> vertices;
  for (const Piece& piece : pieces)
    if (!vertices.contains(piece.positions))
      vertices[piece.positions] = vertices_of(pieces, piece.positions, welder);
  for (const Piece& piece : pieces) add_piece(piece, vertices[piece.positions]);
}

/// The vertices of the rows that pieces with these positions use, in the order of the rows.
std::vector<std::uint32_t> GltfReader::vertices_of(const std::vector<Piece>& pieces, int positions,
                                                   PointWelder& welder) {
  const GltfNumbers& points = numbers(positions);
  std::vector<std::uint32_t> vertex(points.size(), no_index);
  const GltfNumbers* tags = nullptr;
  for (const Piece& piece : pieces) {
    if (piece.positions != positions) continue;
    for (const std::uint32_t row : piece.rows) vertex[row] = 0;
    const auto found = piece.primitive->attributes.find(gltf_vertex);
    if (found != piece.primitive->attributes.end()) tags = &numbers(found->second);
  }
  if (tags &&
      (tags->components != 2 || tags->type != NumberType::UInt16 || tags->size() != points.size()))
    tags = nullptr;
  const auto tag = [&](std::size_t row) {
    return static_cast<std::uint64_t>(tags->values[2 * row] + 65536 * tags->values[2 * row + 1]);
  };
  for (std::size_t row = 0; row < vertex.size(); ++row) {
    if (vertex[row] == no_index) continue;
    const double* const x = &points.values[3 * row];
    const glm::dvec3 raw(x[0], x[1], x[2]);
    const glm::dvec3 placed =
        place_ == glm::dmat4(1) ? raw : glm::dvec3(place_ * glm::dvec4(raw, 1));
    if (!std::isfinite(placed.x) || !std::isfinite(placed.y) || !std::isfinite(placed.z))
      source_.fail("accessor " + std::to_string(positions) + " has a position that is no number");
    if (result_.mesh.positions.size() >= no_index)
      throw LimitError(source_.name, {}, "the scene has too many vertices");
    vertex[row] = tags ? welder.add_numbered(tag(row), placed) : welder.add(raw, placed);
  }
  return vertex;
}

/// Names of the parts of a mesh that other programs do not know are kept as extras.
void GltfReader::enter_names(const tinygltf::Primitive& primitive) {
  const auto text = [&](const char* key) {
    return primitive.extras.IsObject() && primitive.extras.Has(key) &&
                   primitive.extras.Get(key).IsString()
               ? primitive.extras.Get(key).Get<std::string>()
               : std::string();
  };
  parts_.enter(NamedParts::Groups, text("group"));
  parts_.enter(NamedParts::Smoothing, text("smoothing"));
  const std::string object = text("object");
  parts_.enter(NamedParts::Objects, object.empty() ? object_ : object);
  const auto material = static_cast<std::size_t>(primitive.material);
  const auto& all = result_.mesh.appearance.materials;
  if (primitive.material >= 0 && material >= all.size())
    source_.fail("there is no material " + std::to_string(primitive.material));
  parts_.enter(NamedParts::Materials, primitive.material < 0 ? "" : all[material].name);
}

void GltfReader::add_piece(const Piece& piece, const std::vector<std::uint32_t>& vertex_of_row) {
  std::vector<std::uint32_t> vertices;
  for (const std::uint32_t row : piece.rows) vertices.push_back(vertex_of_row[row]);
  columns_.begin(std::move(vertices));
  for (const auto& [semantic, accessor] : piece.primitive->attributes) {
    const bool known = semantic == "NORMAL" || semantic.starts_with("COLOR_") ||
                       semantic.starts_with("TEXCOORD_") || semantic.starts_with("_");
    if (semantic == "POSITION" || semantic == gltf_vertex) continue;
    if (!known) {
      left_out_.add("attribute " + shown(semantic));
      continue;
    }
    const GltfNumbers& given = numbers(accessor);
    if (given.size() != numbers(piece.positions).size())
      source_.fail("attribute " + shown(semantic) + " of a primitive has " +
                   counted(given.size(), "value") + " for " +
                   counted(numbers(piece.positions).size(), "vertex"));
    count(piece.rows.size() * static_cast<std::size_t>(given.components));
    columns_.add(semantic, given, piece.rows, turn_);
  }
  if (!piece.primitive->targets.empty()) left_out_.add("morph targets");
  enter_names(*piece.primitive);
  const auto use = [&](std::uint32_t row) {
    return columns_.first_use() +
           static_cast<std::uint32_t>(std::lower_bound(piece.rows.begin(), piece.rows.end(), row) -
                                      piece.rows.begin());
  };
  for (std::size_t i = 0; i < piece.list.size() && piece.corners > 1; i += piece.corners) {
    std::array<std::uint32_t, 3> rows{};
    std::copy_n(&piece.list[i], piece.corners, rows.begin());
    if (piece.corners == 2) {
      (void)faces_.add_edge(vertex_of_row[rows[0]], vertex_of_row[rows[1]]);
      continue;
    }
    if (mirrored_) std::swap(rows[1], rows[2]);
    const std::array<std::int64_t, 3> corners{vertex_of_row[rows[0]], vertex_of_row[rows[1]],
                                              vertex_of_row[rows[2]]};
    (void)faces_.add(corners, ModelRef(2, parts_.part()));
    for (const std::uint32_t row : rows) use_of_corner_.push_back(use(row));
  }
}

}  // namespace

bool has_gltf() { return true; }

ReadResult read_gltf(const Source& source) { return GltfReader(source).read(); }

}  // namespace aomd::io::detail
