#pragma once
// Views of an MSH file: numbers on nodes, on elements and on the nodes of elements ($NodeData,
// $ElementData, $ElementNodeData).

#include <array>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "core/base/text.h"
#include "core/io/msh_mesh.h"
#include "core/io/text_cursor.h"

namespace aomd::io::detail {

/// What is between the quotes in the rest of the line, or all of it where there are none.
[[nodiscard]] inline std::string_view unquoted(TextCursor& cursor) {
  const std::string_view line = cursor.rest_of_line();
  const std::size_t first = line.find('"'), last = line.rfind('"');
  return first == last ? line : line.substr(first + 1, last - first - 1);
}

/// Turns views into attributes of the mesh: one for vertices, or one for each dimension of which it
/// has elements, or one on the corners of faces. What a view leaves out is NaN. Of several time
/// steps the first is kept.
template <class Body>
class MshViews {
 public:
  enum class On { Nodes, Elements, Corners };

  MshViews(const Source& source, MshMesh& mesh) : source_(source), mesh_(mesh) {}

  /// The body stands behind the name of the section, and after the call before its end.
  void read(On on, Body& body) {
    const std::size_t start = body.text().offset();
    const View view = header(body);
    if (view.components < 1 || view.values < 0)
      body.fail_at(start, "a view without components or values");
    const auto [first, added] = steps_.try_emplace({on, view.name}, view.step);
    const bool kept = first->second == view.step;
    dropped_steps_ += !kept;
    targets_.fill(no_attribute);
    for (std::int64_t i = 0; i < view.values; ++i)
      on == On::Corners ? corner_row(kept, view, body) : row(on == On::Nodes, kept, view, body);
  }

  void finish() {
    if (dropped_steps_ > 0)
      mesh_.notes().push_back(counted(dropped_steps_, "further time step") + " dropped");
    if (dropped_rows_ > 0)
      mesh_.notes().push_back(counted(dropped_rows_, "value") +
                              " on what the mesh does not keep dropped");
  }

 private:
  static constexpr std::size_t no_attribute = static_cast<std::size_t>(-1);

  struct View {
    std::string name;
    std::int64_t step = 0, components = 0, values = 0;
  };

  /// Lists of strings, reals and integers, as text in binary files too.
  View header(Body& body) {
    TextCursor cursor = body.text();
    View view;
    const auto each = [&](const char* what, auto&& use) {
      cursor.skip_to_content();
      const std::int64_t n = cursor.integer(what);
      for (std::int64_t i = 0; i < n; ++i) {
        if (cursor.skip_to_content()) cursor.fail("the file ends within a view");
        use(i);
      }
    };
    each("the number of string tags", [&](std::int64_t i) {
      const std::string_view text = unquoted(cursor);
      if (i == 0) view.name = text;
    });
    each("the number of real tags", [&](std::int64_t) { cursor.real("a real tag"); });
    std::array<std::int64_t, 3> numbers{};
    each("the number of integer tags", [&](std::int64_t i) {
      const std::int64_t value = cursor.integer("an integer tag");
      if (i < 3) numbers[static_cast<std::size_t>(i)] = value;
    });
    cursor.end_line();
    body.move_to(cursor);
    view.step = numbers[0];
    view.components = numbers[1];
    view.values = numbers[2];
    return view;
  }

  void row(bool nodes, bool kept, const View& view, Body& body) {
    const MshMesh::Place place = place_of(nodes, view, body);
    const bool used = kept && place.index != no_index;
    dropped_rows_ += kept && !used;
    double* to = used ? values(place, view, body) : nullptr;
    for (std::int64_t k = 0; k < view.components; ++k) {
      const double value = body.value("a value");
      if (to) *to++ = value;
    }
  }

  MshMesh::Place place_of(bool node, const View& view, Body& body) {
    const std::int64_t tag = body.integer(node ? "a node tag" : "an element tag");
    bool known = false;
    MshMesh::Place place;
    if (node) {
      place.index = mesh_.vertex(static_cast<std::uint64_t>(tag), known);
    } else {
      place = mesh_.element(static_cast<std::uint64_t>(tag), known);
    }
    if (!known)
      body.fail("view " + shown(view.name) + " refers to " + (node ? "node " : "element ") +
                std::to_string(tag) + ", which is not there");
    return place;
  }

  /// The values of the first nodes are those of the corners. Those of an element that repeats a
  /// node say nothing of what is left of it.
  void corner_row(bool kept, const View& view, Body& body) {
    const MshMesh::Place place = place_of(false, view, body);
    const std::int64_t nodes = body.integer("the number of nodes of an element");
    if (nodes < 1) body.fail("view " + shown(view.name) + " has an element without nodes");
    const bool cut = place.index != no_index && !fits(place, nodes, view, body);
    const bool used = kept && place.index != no_index && place.dimension == 2 && !cut;
    dropped_rows_ += kept && !used;
    double* to = used ? corner_values(place.index, view, body) : nullptr;
    const std::size_t corners = used ? corners_of(place) : 0;
    for (std::int64_t node = 0; node < nodes; ++node)
      for (std::int64_t k = 0; k < view.components; ++k) {
        const double value = body.value("a value");
        if (static_cast<std::size_t>(node) < corners) *to++ = value;
      }
  }

  [[nodiscard]] std::size_t corners_of(MshMesh::Place place) const {
    const Shape shape = mesh_.mesh().list(place.dimension).shapes[place.index];
    return static_cast<std::size_t>(shape_template(shape).vertex_count);
  }

  /// False where the element may have had more corners in the file.
  bool fits(MshMesh::Place place, std::int64_t nodes, const View& view, const Body& body) const {
    const Shape shape = mesh_.mesh().list(place.dimension).shapes[place.index];
    if (msh_has_nodes(shape, nodes)) return true;
    if (place.dimension == 2 && mesh_.has_cut_faces()) return false;
    body.fail("view " + shown(view.name) + " has values at " + std::to_string(nodes) +
              " nodes of a " + std::string(shape_template(shape).name));
  }

  /// Where the values at the corners of a face go.
  double* corner_values(std::uint32_t face, const View& view, const Body& body) {
    MeshData& mesh = mesh_.mesh();
    if (first_corner_.empty()) {
      std::size_t next = 0;
      for (const Shape shape : mesh.faces.shapes) {
        first_corner_.push_back(next);
        next += static_cast<std::size_t>(shape_template(shape).vertex_count);
      }
    }
    std::size_t& target = targets_[2];
    if (target == no_attribute) {
      target = mesh.corners.size();
      mesh.corners.push_back(unknown(2, mesh.faces.vertices.size(), view, body));
    }
    return mesh.corners[target].values.data() +
           static_cast<std::size_t>(view.components) * first_corner_[face];
  }

  /// Where the values of this entity go.
  double* values(MshMesh::Place place, const View& view, const Body& body) {
    std::size_t& target = targets_[static_cast<std::size_t>(place.dimension)];
    if (target == no_attribute) target = add_attribute(place.dimension, view, body);
    return mesh_.mesh().attributes[target].values.data() +
           static_cast<std::size_t>(view.components) * place.index;
  }

  /// Views may be sparse, attributes are not: many views of a few values each must not fill the
  /// memory.
  std::size_t add_attribute(int dimension, const View& view, const Body& body) {
    MeshData& mesh = mesh_.mesh();
    const std::size_t n = dimension == 0 ? mesh.positions.size() : mesh.list(dimension).size();
    mesh.attributes.push_back(unknown(dimension, n, view, body));
    return mesh.attributes.size() - 1;
  }

  /// So many entities without values.
  Attribute unknown(int dimension, std::size_t n, const View& view, const Body& body) {
    const std::size_t most = 16 * source_.bytes.size() / sizeof(double);
    const auto components = static_cast<std::uint64_t>(view.components);
    if (components > most / n || components * n > most - held_)
      body.fail("view " + shown(view.name) +
                " holds too few values for its number of components and entities");
    held_ += components * n;
    return {view.name, dimension, static_cast<int>(components), false,
            std::vector<double>(components * n, std::numeric_limits<double>::quiet_NaN())};
  }

  const Source& source_;
  MshMesh& mesh_;
  std::map<std::pair<On, std::string>, std::int64_t> steps_;  ///< the one that is kept
  std::array<std::size_t, 4> targets_{};                      ///< attributes of the present view
  std::vector<std::size_t> first_corner_;  ///< by face; empty until it is asked for
  std::size_t dropped_steps_ = 0, dropped_rows_ = 0, held_ = 0;
};

}  // namespace aomd::io::detail
