// Medit meshes, text and binary.

#include <algorithm>
#include <array>
#include <optional>

#include "core/base/text.h"
#include "core/io/entities.h"
#include "core/io/formats.h"
#include "core/io/medit.h"
#include "core/io/medit_input.h"
#include "core/io/notes.h"
#include "core/mesh/handle.h"

namespace aomd::io::detail {
namespace {

/// Where the elements of one keyword stand among those of their dimension.
struct MeditPart {
  bool read = false;
  std::size_t first = 0, count = 0;
  std::vector<std::size_t> dropped{};  ///< places in the list that gave no element; ascending
};

/// A 1-based number of something that may follow later, and the end of its word.
struct Mark {
  std::int64_t number = 0;
  std::size_t offset = 0;
};

/// Vectors given once and referred to by vertices.
struct Vectors {
  std::vector<glm::dvec3> values;
  std::vector<std::pair<std::uint32_t, Mark>> uses;
};

template <class Input>
class MeditReader {
 public:
  explicit MeditReader(const Source& source) : source_(source), input_(source) {}

  ReadResult read() {
    for (std::string keyword; input_.next(keyword);) section(keyword);
    read_early();
    if (!has_vertices_) input_.fail("the file has no Vertices");
    classify();
    add_attributes();
    ReadResult result{std::move(mesh_), Format::Medit, {}};
    result.whole = curved_ == 0 && repeats_.edges + repeats_.faces + repeats_.cut == 0;
    repeats_.note(result.notes);
    if (curved_ > 0) drop_inner_nodes(result);
    if (!passed_over_.empty()) result.notes.push_back("passed over: " + passed_over_.text());
    return result;
  }

 private:
  /// The number of items of so many numbers each.
  std::size_t count(const std::string& keyword, std::size_t integers, std::size_t reals = 0) {
    const std::int64_t n = input_.integer("the number of items");
    if (n < 0) input_.fail("a negative number of " + keyword);
    if (static_cast<std::uint64_t>(n) >= no_index)
      throw LimitError(source_.name, {}, "more than 2^32 - 2 " + keyword);
    if (!input_.has_room(static_cast<std::uint64_t>(n), integers, reals))
      input_.fail("the file is too short for " + std::to_string(n) + ' ' + keyword);
    return static_cast<std::size_t>(n);
  }

  /// Sections may come in any order: those that need what follows later are read at the end.
  struct Early {
    std::string name;
    std::size_t start;
  };
  static bool is_vertices(const Early& early) { return lower(early.name) == "vertices"; }

  /// Only vectors and vertices depend on the dimension, all else on the vertices.
  [[nodiscard]] bool is_early(const std::string& keyword) const {
    if (keyword == "dimension") return false;
    const bool vectors = keyword == "vertices" || keyword == "normals" || keyword == "tangents";
    return vectors ? dimension_ == 0 : !has_vertices_;
  }

  void read_early() {
    if (dimension_ == 0) input_.fail("the file has no Dimension");
    std::stable_sort(early_.begin(), early_.end(), [](const Early& a, const Early& b) {
      return is_vertices(a) && !is_vertices(b);
    });
    for (const Early& each : early_) {
      if (!has_vertices_ && !is_vertices(each)) return;
      input_.move_to(each.start);
      section(each.name);
    }
  }

  void section(const std::string& name) {
    const std::string keyword = lower(name);
    if (is_early(keyword)) {
      early_.push_back({name, input_.place()});
      return input_.pass_over();
    }
    if (keyword == "dimension") return dimension();
    if (keyword == "vertices") return vertices(name);
    if (const auto kind = medit_elements(keyword)) return elements(name, *kind);
    if (keyword == "corners") return marks(name, corners_);
    if (keyword == "requiredvertices") return marks(name, required_[0]);
    if (keyword == "ridges") return marks(name, ridges_);
    if (keyword.starts_with("required")) {
      if (const auto kind = medit_elements(keyword.substr(8)))
        return marks(name, required_[static_cast<std::size_t>(kind->shape)]);
    }
    if (keyword == "normals") return vectors(name, normals_);
    if (keyword == "tangents") return vectors(name, tangents_);
    if (keyword == "normalatvertices") return vector_uses(name, normals_);
    if (keyword == "tangentatvertices") return vector_uses(name, tangents_);
    if (keyword.ends_with("ordering")) {
      if (const auto kind = medit_elements(keyword.substr(0, keyword.size() - 8)))
        return ordering(name, *kind);
    }
    passed_over_.add(shown(name));
    input_.pass_over();
  }

  void dimension() {
    const std::int64_t d = input_.dimension();
    if (d != 2 && d != 3) input_.fail("dimension " + std::to_string(d) + "; it is 2 or 3");
    dimension_ = static_cast<int>(d);
  }

  glm::dvec3 vector() {
    const double x = input_.real("x"), y = input_.real("y");
    return {x, y, dimension_ == 3 ? input_.real("z") : 0};
  }

  void vertices(const std::string& name) {
    if (has_vertices_) input_.fail("Vertices are listed twice");
    has_vertices_ = true;
    const std::size_t n = count(name, 1, static_cast<std::size_t>(dimension_));
    mesh_.positions.reserve(n);
    references_.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
      mesh_.positions.push_back(vector());
      references_.push_back(reference());
    }
  }

  std::int32_t reference() {
    const std::int64_t tag = input_.integer("a reference");
    if (tag < ModelRef::min_tag || tag > ModelRef::max_tag)
      input_.fail("reference " + std::to_string(tag) + " is out of range");
    return static_cast<std::int32_t>(tag);
  }

  /// Of elements of higher order the corners, which come first.
  void elements(const std::string& name, const MeditElements& kind) {
    const ShapeTemplate& shape = shape_template(kind.shape);
    const auto corners = static_cast<std::size_t>(shape.vertex_count);
    const bool curved = kind.nodes > corners;
    MeditPart& part = (curved ? curved_parts_ : parts_)[static_cast<std::size_t>(kind.shape)];
    if (part.read) input_.fail(name + " are listed twice");
    EntityList& list = mesh_.list(shape.dimension);
    part = {true, list.size(), count(name, kind.nodes + 1)};
    list.shapes.reserve(list.size() + part.count);
    list.vertices.reserve(list.vertices.size() + corners * part.count);
    list.classes.reserve(list.size() + part.count);
    std::array<std::int64_t, 8> v{};
    const std::span<std::int64_t> used(v.data(), corners);
    for (std::size_t i = 0; i < part.count; ++i) {
      for (std::int64_t& index : used) index = input_.integer("a vertex index") - 1;
      const std::string wrong = entity_defect(kind.shape, used, mesh_.positions.size(), 1);
      const bool kept = wrong.empty() || add_rest(kind.shape, used, list, wrong);
      if (wrong.empty()) append(list, kind.shape, used);
      for (std::size_t k = corners; k < kind.nodes; ++k) inner_node();
      const std::int32_t tag = reference();
      if (!kept) {
        part.dropped.push_back(i);
        continue;
      }
      list.classes.emplace_back(shape.dimension, tag);
      tagged_ = tagged_ || tag != 0;
    }
    if (curved) curved_ += part.count;
  }

  /// Adds what is left of an edge or a face without its repeated corners; false where nothing is.
  bool add_rest(Shape shape, std::span<const std::int64_t> used, EntityList& list,
                const std::string& wrong) {
    const auto left = without_repeats(shape, used, mesh_.positions.size(), repeats_);
    if (!left) input_.fail(wrong);
    if (!left->empty()) append(list, Shape::Triangle, *left);
    return !left->empty();
  }

  void inner_node() {
    const std::size_t v = vertex_index();
    inner_.resize(mesh_.positions.size());
    inner_[v] = 1;
  }

  std::size_t vertex_index() {
    const std::int64_t vertex = input_.integer("a vertex index") - 1;
    if (outside(vertex, mesh_.positions.size()))
      input_.fail(out_of_range(vertex, mesh_.positions.size(), 1));
    return static_cast<std::size_t>(vertex);
  }

  /// The place of each node of an element of higher order, in steps along its sides: 0 or all of
  /// them at a corner. What does not begin with the corners would be misread.
  void ordering(const std::string& name, const MeditElements& kind) {
    constexpr std::size_t numbers[] = {0, 1, 3, 2, 4, 3, 4, 3};  // of a node, by shape
    const std::size_t per_node = numbers[static_cast<std::size_t>(kind.shape)],
                      n = count(name, per_node),
                      corners = static_cast<std::size_t>(shape_template(kind.shape).vertex_count);
    for (std::size_t i = 0; i < n * per_node; ++i) {
      const std::int64_t step = input_.integer("a place");
      if (i < corners * per_node && step != 0 && step != static_cast<std::int64_t>(kind.order))
        input_.fail(name + " does not begin with the corners: save the mesh in the usual order");
    }
  }

  Mark number() {
    const std::int64_t n = input_.integer("an index");
    return {n, input_.offset()};
  }

  /// Marked items by their numbers; checked once all lists are there.
  void marks(const std::string& name, std::vector<Mark>& into) {
    const std::size_t n = count(name, 1);
    for (std::size_t i = 0; i < n; ++i) into.push_back(number());
  }

  void vectors(const std::string& name, Vectors& into) {
    const std::size_t n = count(name, 0, static_cast<std::size_t>(dimension_));
    for (std::size_t i = 0; i < n; ++i) into.values.push_back(vector());
  }

  void vector_uses(const std::string& name, Vectors& into) {
    const std::size_t n = count(name, 2);
    for (std::size_t i = 0; i < n; ++i) {
      const auto vertex = static_cast<std::uint32_t>(vertex_index());
      into.uses.emplace_back(vertex, number());
    }
  }

  /// References classify, unless there are only zeros and nothing else that tells of a model.
  void classify() {
    const bool model_edges =
        !ridges_.empty() || !required_[static_cast<std::size_t>(Shape::Line)].empty();
    if (!tagged_ && corners_.empty() && !model_edges) {
      for (int d = 1; d <= 3; ++d) mesh_.list(d).classes.clear();
      return;
    }
    mesh_.vertex_classes = lowest_classes(mesh_);
    std::int32_t number = 0;
    std::vector<bool> seen(mesh_.positions.size());
    for (const Mark& corner : corners_) {
      const std::size_t v = checked(corner, mesh_.positions.size());
      if (seen[v]) continue;
      seen[v] = true;
      mesh_.vertex_classes[v] = ModelRef(0, ++number);
    }
  }

  /// The 0-based place of what is marked.
  std::size_t checked(const Mark& mark, std::size_t count) const {
    if (mark.number >= 1 && static_cast<std::uint64_t>(mark.number) <= count)
      return static_cast<std::size_t>(mark.number) - 1;
    input_.fail_at(mark.offset, "index " + std::to_string(mark.number) + " is out of range (1.." +
                                    std::to_string(count) + ")");
  }

  void add_attributes() {
    const std::size_t n = mesh_.positions.size();
    if (std::any_of(references_.begin(), references_.end(), [](std::int32_t r) { return r != 0; }))
      add(medit_reference, 0, 1, true).assign(references_.begin(), references_.end());
    if (!required_[0].empty()) mark(add(medit_required, 0, 1, true, n), required_[0], {true, 0, n});
    add_vectors(medit_normal, normals_, 0);
    add_vectors(medit_tangent, tangents_, normals_.values.size());
    for (int d = 1; d <= 3; ++d) {
      add_required(d);
      if (d == 1 && !ridges_.empty())
        mark(add(medit_ridge, 1, 1, true, mesh_.edges.size()), ridges_,
             parts_[static_cast<std::size_t>(Shape::Line)]);
    }
  }

  std::vector<double>& add(std::string_view name, int d, int components, bool integer,
                           std::size_t n = 0) {
    mesh_.attributes.push_back({std::string(name), d, components, integer, std::vector<double>(n)});
    return mesh_.attributes.back().values;
  }

  void mark(std::vector<double>& values, const std::vector<Mark>& marks,
            const MeditPart& part) const {
    for (const Mark& m : marks) {
      const std::size_t place = checked(m, part.count);
      const auto gone = std::lower_bound(part.dropped.begin(), part.dropped.end(), place);
      if (gone != part.dropped.end() && *gone == place) continue;
      values[part.first + place - static_cast<std::size_t>(gone - part.dropped.begin())] = 1;
    }
  }

  /// Numbers of elements of higher order count where there are no others.
  const MeditPart& part_of(std::size_t shape) const {
    return parts_[shape].read ? parts_[shape] : curved_parts_[shape];
  }

  void add_required(int d) {
    std::vector<double>* values = nullptr;
    for (const MeditList& list : medit_lists) {
      const auto k = static_cast<std::size_t>(list.shape);
      if (shape_template(list.shape).dimension != d || required_[k].empty()) continue;
      if (!values) values = &add(medit_required, d, 1, true, mesh_.list(d).size());
      mark(*values, required_[k], part_of(k));
    }
  }

  /// Mmg's files count tangents on from the last normal: then every number lies beyond the
  /// tangents' own.
  static std::int64_t first_number(const Vectors& vectors, std::size_t others) {
    const bool beyond = std::all_of(vectors.uses.begin(), vectors.uses.end(), [&](const auto& use) {
      return use.second.number > static_cast<std::int64_t>(std::max(vectors.values.size(), others));
    });
    return beyond ? static_cast<std::int64_t>(others) : 0;
  }

  void add_vectors(std::string_view name, const Vectors& vectors, std::size_t others) {
    if (vectors.uses.empty()) return;
    std::vector<double>& values = add(name, 0, 3, false, 3 * mesh_.positions.size());
    const std::int64_t first = first_number(vectors, others);
    for (const auto& [vertex, use] : vectors.uses) {
      const glm::dvec3& vector =
          vectors.values[checked({use.number - first, use.offset}, vectors.values.size())];
      for (int axis = 0; axis < 3; ++axis)
        values[3 * std::size_t{vertex} + static_cast<std::size_t>(axis)] = vector[axis];
    }
  }

  /// What only elements of higher order use, other than as a corner.
  void drop_inner_nodes(ReadResult& result) {
    result.notes.push_back(counted(curved_, "higher-order element") + " read by the corners");
    inner_.resize(result.mesh.positions.size());
    for (int d = 1; d <= 3; ++d) {
      for (const std::uint32_t v : result.mesh.list(d).vertices) inner_[v] = 0;
    }
    drop_vertices(result.mesh, inner_);
  }

  const Source& source_;
  Input input_;
  MeshData mesh_;
  int dimension_ = 0;
  bool has_vertices_ = false;
  std::vector<Early> early_;
  bool tagged_ = false;  ///< an element has a reference other than 0
  std::vector<std::int32_t> references_;
  std::array<MeditPart, builtin_shapes> parts_, curved_parts_;  ///< by shape; of higher order
  std::array<std::vector<Mark>, builtin_shapes> required_;      ///< by shape; vertices first
  std::vector<Mark> corners_, ridges_;
  Vectors normals_, tangents_;
  Repeats repeats_;
  std::size_t curved_ = 0;           ///< elements of higher order
  std::vector<std::uint8_t> inner_;  ///< not 0: a node of one of them, other than a corner
  ItemList passed_over_;
};

}  // namespace

bool is_binary_medit(std::string_view bytes) {
  const std::string_view one = bytes.substr(0, 4);
  return one == std::string_view("\1\0\0\0", 4) || one == std::string_view("\0\0\0\1", 4);
}

ReadResult read_medit(const Source& source) {
  if (is_binary_medit(source.bytes)) return MeditReader<MeditBinary>(source).read();
  return MeditReader<MeditText>(without_padding(source)).read();
}

}  // namespace aomd::io::detail
