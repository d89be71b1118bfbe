// PLY: vertex, face, edge and tristrips elements, with their scalar properties as arrays;
// everything else is passed over.

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/text.h"
#include "core/io/face_sink.h"
#include "core/io/formats.h"
#include "core/io/notes.h"
#include "core/io/ply_arrays.h"
#include "core/io/ply_body.h"
#include "core/io/ply_header.h"
#include "core/io/stored_numbers.h"
#include "core/mesh/handle.h"

namespace aomd::io::detail {
namespace {

/// What a property means to us.
enum class Role : std::uint8_t {
  Skip,
  Value,
  X,
  Y,
  Z,
  Indices,
  Texcoord,
  Vertex1,
  Vertex2,
  ModelDimension,
  ModelTag
};

Role role_of(const PlyElement& element, const PlyProperty& p) {
  const std::string &e = element.name, n = lower(p.name);
  if (p.list && e == "face" && n == "texcoord") return Role::Texcoord;
  if (p.list) return is_corner_list(p) ? Role::Indices : Role::Skip;
  if (n == "model_dimension") return Role::ModelDimension;
  if (n == "model_tag") return Role::ModelTag;
  if (e == "vertex") {
    constexpr Role axes[] = {Role::X, Role::Y, Role::Z};
    const int axis = axis_of(p);
    return axis < 0 ? Role::Skip : axes[axis];
  }
  if (e == "edge")
    return n == "vertex1" ? Role::Vertex1 : n == "vertex2" ? Role::Vertex2 : Role::Skip;
  return Role::Skip;
}

/// A property that we pass over.
std::string words_for(const PlyElement& element, const PlyProperty& property) {
  return element.name + ' ' + property.name;
}

/// One element's values that we use.
struct Record {
  double position[3] = {};
  std::int64_t ends[2] = {};
  std::int64_t model_dimension = 7, model_tag = 0;
  std::vector<std::int64_t> indices;
  std::vector<double> texcoord;
};

template <class Body>
class PlyReader {
 public:
  PlyReader(const Source& source, const PlyHeader& header)
      : source_(source),
        header_(header),
        body_(source, header),
        vertex_count_(promised_vertices()),
        faces_(vertex_count_) {}

  ReadResult read() {
    for (const PlyElement& element : header_.elements) read_element(element);
    ReadResult result;
    result.format = Format::Ply;
    faces_.finish(mesh_, result.notes);
    for (Attribute& a : arrays_) add_array(std::move(a));
    if (!texture_.values.empty()) add_texture();
    mesh_.remarks = header_.remarks;
    if (!misfits_.empty())
      result.notes.push_back("numbers that their type does not hold, kept as doubles: " +
                             misfits_.text());
    note_left_out(result.notes, left_out_);
    note_rest(result.notes, body_.rest(), "element");
    drop_empty_classes(mesh_);
    result.mesh = std::move(mesh_);
    return result;
  }

 private:
  std::uint64_t promised_vertices() const {
    const PlyElement* element = header_.find("vertex");
    if (!element) source_.fail("the PLY header declares no vertices");
    return element->count;
  }

  void read_element(const PlyElement& element) {
    roles_.clear();
    for (const PlyProperty& p : element.properties) roles_.push_back(role_of(element, p));
    classified_ = has(Role::ModelDimension) && has(Role::ModelTag);
    if (header_.encoding != PlyEncoding::Ascii) check_room(element);
    const std::size_t expected = believable(element);
    if (element.name == "vertex") {
      need(element, {Role::X, Role::Y, Role::Z}, "x, y and z");
      mesh_.positions.reserve(expected);
      find_arrays(element, 0, expected);
      each(element, [&] { add_vertex(); });
    } else if (element.name == "face") {
      need(element, {Role::Indices}, "a list vertex_indices");
      faces_.reserve(expected);
      find_arrays(element, 2, expected);
      has_texture_ = has(Role::Texcoord);
      if (has_texture_) faces_.keep_origins();
      each(element, [&] { add_face(); });
    } else if (element.name == "edge" && has(Role::Vertex1) && has(Role::Vertex2)) {
      find_arrays(element, 1, expected);
      each(element, [&] { add_edge(); });
    } else if (element.name == "tristrips" && has(Role::Indices)) {
      strips_ = true;
      each(element, [&] { add_strip(); });
    } else {
      std::fill(roles_.begin(), roles_.end(), Role::Skip);
      each(element, [] {});
      if (element.count > 0) left_out_.add("element " + shown(element.name));
      return;
    }
    if (element.count > 0) name_unread(element);
    for (PlyGroup& group : groups_) arrays_.push_back(std::move(group.array));
    groups_.clear();
  }

  /// What of the element is neither a place nor a class is an array.
  void find_arrays(const PlyElement& element, int dimension, std::size_t expected) {
    std::vector<bool> free;
    for (std::size_t p = 0; p < roles_.size(); ++p)
      free.push_back(roles_[p] == Role::Skip && !element.properties[p].list);
    groups_ = arrays_of(element, dimension, free);
    if (groups_.empty()) return;
    if (dimension == 1) faces_.keep_edge_origins();
    if (dimension == 2) faces_.keep_origins();
    sinks_.assign(roles_.size(), nullptr);
    for (PlyGroup& group : groups_) {
      const auto n = static_cast<std::size_t>(group.array.components);
      group.array.values.reserve(n * expected);
      for (std::size_t p = group.first; p < group.first + n; ++p) {
        roles_[p] = Role::Value;
        sinks_[p] = &group.array.values;
      }
    }
  }

  void add_texture() {
    if (torn_) left_out_.add("face texture coordinates that do not fit the corners");
    if (header_.encoding == PlyEncoding::Ascii && !fit_values(texture_))
      misfits_.add(shown(texture_.name));
    spread_to_corners(texture_, faces_.origins());
    if (texture_.values.size() == 2 * mesh_.faces.vertices.size())
      mesh_.corners.push_back(std::move(texture_));
    else
      left_out_.add("face texture coordinates");
  }

  /// Once all faces are there. What goes with strips, or with a second element of one name, has no
  /// place.
  void add_array(Attribute&& a) {
    if (header_.encoding == PlyEncoding::Ascii && !fit_values(a)) misfits_.add(shown(a.name));
    const auto n = static_cast<std::size_t>(a.components);
    if (a.dimension == 2 && !strips_) spread_to_faces(a, faces_.origins());
    if (a.dimension == 1) take_values(a, faces_.edge_origins());
    const std::size_t entities =
        a.dimension == 0 ? mesh_.positions.size() : mesh_.list(a.dimension).size();
    if (a.values.size() == n * entities)
      mesh_.attributes.push_back(std::move(a));
    else
      left_out_.add(std::string(entity_name(a.dimension)) + ' ' + a.name);
  }

  void name_unread(const PlyElement& element) {
    for (std::size_t p = 0; p < roles_.size(); ++p) {
      if (roles_[p] == Role::Skip) left_out_.add(words_for(element, element.properties[p]));
    }
  }

  [[nodiscard]] bool has(Role role) const {
    return std::find(roles_.begin(), roles_.end(), role) != roles_.end();
  }

  void need(const PlyElement& element, std::initializer_list<Role> roles, const char* names) const {
    for (const Role role : roles) {
      if (!has(role))
        source_.fail_at_line(element.line_offset, "element " + element.name + " needs " + names);
    }
  }

  /// Refuses at once what the file is too short for.
  void check_room(const PlyElement& element) const {
    const std::size_t least = element.least_size(header_.encoding);
    if (least == 0 || element.count <= body_.left() / least) return;
    source_.fail_at_byte(source_.bytes.size(),
                         "the file ends early: " + std::to_string(element.count) + " of " +
                             shown(element.name) + " need " + std::to_string(least) +
                             " or more bytes each, " + std::to_string(body_.left()) + " are left");
  }

  /// How many elements the rest of the file can hold, at most.
  [[nodiscard]] std::size_t believable(const PlyElement& element) const {
    const std::size_t least = std::max<std::size_t>(element.least_size(header_.encoding), 1);
    const auto expected =
        static_cast<std::size_t>(std::min<std::uint64_t>(element.count, body_.left() / least + 1));
    if (expected >= no_index)
      throw LimitError(source_.name, {}, "more than 2^32 - 2 of " + shown(element.name));
    return expected;
  }

  template <class Use>
  void each(const PlyElement& element, Use&& use) {
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (body_.at_end()) {
        body_.fail("the file ends after " + std::to_string(i) + " of " +
                   std::to_string(element.count) + " of " + shown(element.name));
      }
      for (std::size_t p = 0; p < roles_.size(); ++p) take(element.properties[p], p);
      use();
      body_.end_element();
    }
  }

  void take(const PlyProperty& p, std::size_t number) {
    const Role role = roles_[number];
    switch (role) {
      case Role::X:
      case Role::Y:
      case Role::Z: {
        constexpr const char* names[] = {"x", "y", "z"};
        const auto axis = static_cast<std::size_t>(role) - static_cast<std::size_t>(Role::X);
        record_.position[axis] = body_.real(p.type, names[axis]);
        break;
      }
      case Role::Vertex1:
        record_.ends[0] = body_.integer(p.type, "vertex1");
        break;
      case Role::Vertex2:
        record_.ends[1] = body_.integer(p.type, "vertex2");
        break;
      case Role::ModelDimension:
        record_.model_dimension = body_.integer(p.type, "model_dimension");
        break;
      case Role::ModelTag:
        record_.model_tag = body_.integer(p.type, "model_tag");
        break;
      case Role::Indices:
        take_indices(p);
        break;
      case Role::Texcoord:
        take_texcoord(p);
        break;
      case Role::Value:
        sinks_[number]->push_back(body_.any(p.type));
        break;
      case Role::Skip:
        pass_over(p);
        break;
    }
  }

  std::size_t list_size(const PlyProperty& p) {
    const std::int64_t n = body_.integer(p.count_type, "the length of a list");
    if (n < 0) body_.fail("a list of negative length");
    if (static_cast<std::uint64_t>(n) > body_.left())
      body_.fail("a list of " + std::to_string(n) + ", longer than the rest of the file");
    return static_cast<std::size_t>(n);
  }

  void take_indices(const PlyProperty& p) {
    const std::size_t n = list_size(p);
    record_.indices.resize(n);
    for (std::int64_t& index : record_.indices) index = body_.integer(p.type, "a vertex index");
  }

  void take_texcoord(const PlyProperty& p) {
    record_.texcoord.resize(list_size(p));
    for (double& x : record_.texcoord) x = body_.any(p.type);
    store_as(texture_, p.type);
  }

  /// Two numbers for each corner of the present face; none where the file has another number.
  void add_texcoord() {
    const std::size_t n = 2 * record_.indices.size();
    const bool fits = record_.texcoord.size() == n;
    torn_ = torn_ || (!fits && !record_.texcoord.empty());
    if (!fits) record_.texcoord.assign(n, std::numeric_limits<double>::quiet_NaN());
    texture_.values.insert(texture_.values.end(), record_.texcoord.begin(), record_.texcoord.end());
  }

  void pass_over(const PlyProperty& p) {
    const std::size_t n = p.list ? list_size(p) : 1;
    for (std::size_t i = 0; i < n; ++i) body_.skip(p.type);
  }

  /// The class of the current element, whose dimension is `lowest`.
  ModelRef model(int lowest) const {
    if (!classified_ || record_.model_dimension == 7) return {};
    const std::int64_t dimension = record_.model_dimension, tag = record_.model_tag;
    if (dimension < lowest || dimension > 3) {
      body_.fail("a " + std::string(entity_name(lowest)) +
                 " cannot lie on a model entity of dimension " + std::to_string(dimension));
    }
    if (tag < ModelRef::min_tag || tag > ModelRef::max_tag)
      body_.fail("model_tag " + std::to_string(tag) + " is out of range");
    return {static_cast<int>(dimension), static_cast<std::int32_t>(tag)};
  }

  void add_vertex() {
    mesh_.positions.emplace_back(record_.position[0], record_.position[1], record_.position[2]);
    if (classified_) mesh_.vertex_classes.push_back(model(0));
  }

  void add_face() {
    const std::string wrong = faces_.add(record_.indices, model(2));
    if (!wrong.empty()) body_.fail(wrong);
    if (has_texture_) add_texcoord();
  }

  void add_edge() {
    const std::string wrong = faces_.add_edge(record_.ends[0], record_.ends[1], model(1));
    if (!wrong.empty()) body_.fail(wrong);
  }

  /// Strips end with -1; every second triangle runs the other way. Triangles that repeat a vertex
  /// are how strips turn corners: they are no faces.
  void add_strip() {
    std::size_t start = 0;
    const std::vector<std::int64_t>& v = record_.indices;
    for (std::size_t i = 0; i < v.size(); ++i) {
      if (v[i] == -1) start = i + 1;
      if (v[i] == -1 || i < start + 2) continue;
      const bool odd = (i - start) % 2 == 1;
      const std::int64_t triangle[] = {v[i - 2], v[odd ? i : i - 1], v[odd ? i - 1 : i]};
      if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
        continue;
      const std::string wrong = faces_.add(triangle, model(2));
      if (!wrong.empty()) body_.fail(wrong);
    }
  }

  const Source& source_;
  const PlyHeader& header_;
  Body body_;
  std::uint64_t vertex_count_;
  FaceSink faces_;
  MeshData mesh_;
  std::vector<Role> roles_;
  bool classified_ = false;
  Record record_;
  std::vector<PlyGroup> groups_;             ///< the arrays of the present element
  std::vector<std::vector<double>*> sinks_;  ///< where its properties go
  std::vector<Attribute> arrays_;            ///< all, as the file lists them
  Attribute texture_{"texcoord", 2, 2, false, {}, {}, Meaning::Texture};  ///< of corners
  bool has_texture_ = false, torn_ = false, strips_ = false;
  ItemList left_out_, misfits_;
};

}  // namespace

ReadResult read_ply(const Source& file) {
  const PlyHeader header = read_ply_header(file);
  const Source source = header.encoding == PlyEncoding::Ascii ? without_padding(file) : file;
  switch (header.encoding) {
    case PlyEncoding::LittleEndian:
      return PlyReader<PlyBinary<std::endian::little>>(source, header).read();
    case PlyEncoding::BigEndian:
      return PlyReader<PlyBinary<std::endian::big>>(source, header).read();
    case PlyEncoding::Ascii:
      break;
  }
  return PlyReader<PlyText>(source, header).read();
}

}  // namespace aomd::io::detail
