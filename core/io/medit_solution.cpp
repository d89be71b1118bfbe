#include "core/io/medit_solution.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/text.h"
#include "core/io/formats.h"
#include "core/io/medit.h"
#include "core/io/medit_input.h"
#include "core/io/medit_out.h"
#include "core/io/text_file.h"

namespace aomd::io::detail {
namespace {

/// What a section is about: vertices, or elements of one shape.
struct Entities {
  int dimension = 0;
  Shape shape = Shape::Point;

  [[nodiscard]] bool has(const MeshData& mesh, std::size_t i) const {
    return dimension == 0 || mesh.list(dimension).shapes[i] == shape;
  }
  /// How many entities of the dimension there are, whatever their shape.
  [[nodiscard]] std::size_t all(const MeshData& mesh) const {
    return dimension == 0 ? mesh.positions.size() : mesh.list(dimension).size();
  }
  [[nodiscard]] std::size_t count(const MeshData& mesh) const {
    std::size_t n = 0;
    for (std::size_t i = 0; i < all(mesh); ++i) n += has(mesh, i);
    return n;
  }
};

/// The numbers of types of values: these many components in space.
constexpr std::array<std::pair<int, int>, 4> types{{{1, 1}, {2, 3}, {3, 6}, {4, 9}}};

template <class Input>
class SolutionReader {
 public:
  SolutionReader(const Source& source, MeshData& mesh) : input_(source), mesh_(mesh) {}

  void read() {
    for (std::string name; input_.next(name);) section(name);
    for (std::vector<Attribute>& list : arrays_)
      for (Attribute& a : list) mesh_.attributes.push_back(std::move(a));
  }

 private:
  void section(const std::string& name) {
    const std::string keyword = lower(name);
    if (keyword == "dimension") {
      space_ = static_cast<int>(input_.dimension());
      if (space_ != 2 && space_ != 3) input_.fail("the dimension must be 2 or 3");
    } else if (keyword == "solatvertices") {
      values(name, {});
    } else if (const auto kind = elements(keyword); kind && kind->order == 1) {
      values(name, {shape_template(kind->shape).dimension, kind->shape});
    } else {
      input_.pass_over();
    }
  }

  static std::optional<MeditElements> elements(const std::string& keyword) {
    constexpr std::string_view start = "solat";
    if (!keyword.starts_with(start)) return {};
    return medit_elements(keyword.substr(start.size()));
  }

  void values(const std::string& name, const Entities& entities) {
    if (space_ == 0) input_.fail("the file has no Dimension before its values");
    const std::int64_t n = input_.integer("the number of values");
    const std::size_t wanted = entities.count(mesh_);
    if (n < 0 || static_cast<std::uint64_t>(n) != wanted)
      input_.fail(name + " has values for " + std::to_string(n) + ", and the mesh has " +
                  std::to_string(wanted) + " of these");
    const std::vector<Attribute*> arrays = arrays_of(entities);
    for (std::size_t i = 0; i < entities.all(mesh_); ++i) {
      if (!entities.has(mesh_, i)) continue;
      for (Attribute* const a : arrays) {
        const auto components = static_cast<std::size_t>(a->components);
        for (std::size_t k = 0; k < components; ++k)
          a->values[components * i + k] = input_.real("a value");
      }
    }
  }

  /// Reads the types; elements of another shape may have made their arrays already.
  std::vector<Attribute*> arrays_of(const Entities& entities) {
    const std::int64_t n = input_.integer("the number of types");
    if (n < 0 || !input_.has_room(static_cast<std::uint64_t>(n), 1, 0))
      input_.fail("the file is too short for " + std::to_string(n) + " types");
    std::vector<Attribute>& list = arrays_[static_cast<std::size_t>(entities.dimension)];
    std::vector<int> components;
    for (std::int64_t k = 0; k < n; ++k) components.push_back(components_of_type());
    check_room(entities, components);
    for (std::size_t k = 0; k < components.size(); ++k) {
      if (k == list.size()) list.push_back(unknown(k, entities, components[k]));
      if (list[k].components != components[k])
        input_.fail("value " + std::to_string(k + 1) + " has another type than before");
    }
    std::vector<Attribute*> arrays;
    for (std::size_t k = 0; k < components.size(); ++k) arrays.push_back(&list[k]);
    return arrays;
  }

  int components_of_type() {
    const std::int64_t type = input_.integer("a type");
    const std::array<int, 4> in_space{1, space_, space_ * (space_ + 1) / 2, space_ * space_};
    if (type < 1 || type > 4)
      input_.fail("type " + std::to_string(type) + " is not one that is known here");
    return in_space[static_cast<std::size_t>(type - 1)];
  }

  void check_room(const Entities& entities, const std::vector<int>& components) const {
    std::size_t each = 0;
    for (const int n : components) each += static_cast<std::size_t>(n);
    const std::size_t items = entities.count(mesh_);
    if (each > 0 && !input_.has_room(items, 0, each))
      input_.fail("the file is too short for " + counted(items * each, "value"));
  }

  [[nodiscard]] Attribute unknown(std::size_t k, const Entities& entities, int components) const {
    const std::size_t numbers = entities.all(mesh_) * static_cast<std::size_t>(components);
    return {solution_name(k), entities.dimension, components, false,
            std::vector<double>(numbers, std::numeric_limits<double>::quiet_NaN())};
  }

  Input input_;
  MeshData& mesh_;
  int space_ = 0;
  std::array<std::vector<Attribute>, 4> arrays_;
};

class SolutionWriter {
 public:
  SolutionWriter(const MeshData& mesh, bool binary)
      : mesh_(mesh), arrays_(solution_arrays(mesh)), out_(binary, most_bytes()) {}

  std::string write() {
    if (arrays_.empty()) return {};
    section("SolAtVertices", {});
    for (const MeditList& list : medit_lists)
      section("SolAt" + std::string(list.keyword),
              {shape_template(list.shape).dimension, list.shape});
    return out_.finish();
  }

 private:
  [[nodiscard]] std::uint64_t most_bytes() const {
    std::uint64_t sum = 4096;
    for (const Attribute* const a : arrays_) sum += 8 * std::uint64_t{a->values.size()} + 64;
    return sum;
  }

  void section(const std::string& keyword, const Entities& entities) {
    std::vector<const Attribute*> here;
    std::size_t numbers = 0;
    for (const Attribute* const a : arrays_) {
      if (a->dimension != entities.dimension) continue;
      here.push_back(a);
      numbers += static_cast<std::size_t>(a->components);
    }
    const std::size_t count = entities.count(mesh_);
    if (here.empty() || count == 0) return;
    out_.begin_values(keyword, count, here.size(), numbers);
    for (const Attribute* const a : here) out_.integer(type_of(a->components));
    out_.end_line();
    for (std::size_t i = 0; i < entities.all(mesh_); ++i) {
      if (!entities.has(mesh_, i)) continue;
      for (const Attribute* const a : here) {
        const auto components = static_cast<std::size_t>(a->components);
        for (std::size_t k = 0; k < components; ++k) out_.real(a->values[components * i + k]);
      }
      out_.end_line();
    }
  }

  static int type_of(int components) {
    const auto* const found = std::find_if(
        types.begin(), types.end(), [&](const auto& type) { return type.second == components; });
    return found->first;
  }

  const MeshData& mesh_;
  std::vector<const Attribute*> arrays_;
  MeditOut out_;
};

}  // namespace

std::string solution_name(std::size_t n) {
  return n == 0 ? "solution" : "solution " + std::to_string(n + 1);
}

void read_solution(const Source& source, MeshData& mesh) {
  if (is_binary_medit(source.bytes)) return SolutionReader<MeditBinary>(source, mesh).read();
  const Source text = without_padding(without_mark(source));
  SolutionReader<MeditText>(text, mesh).read();
}

std::vector<const Attribute*> solution_arrays(const MeshData& mesh) {
  std::vector<const Attribute*> found;
  for (const Attribute& a : mesh.attributes) {
    const bool has_type = std::any_of(
        types.begin(), types.end(), [&](const auto& type) { return type.second == a.components; });
    if (!a.integer && has_type && !a.name.starts_with("medit:") &&
        std::all_of(a.values.begin(), a.values.end(), [](double x) { return std::isfinite(x); }))
      found.push_back(&a);
  }
  return found;
}

std::string write_solution(const MeshData& mesh, bool binary) {
  return SolutionWriter(mesh, binary).write();
}

}  // namespace aomd::io::detail
