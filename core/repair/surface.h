#pragma once
// What the stages of a repair work on: the faces of a MeshData whose places stay until the end.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/mesh/handle.h"
#include "core/mesh/mesh_data.h"

namespace aomd::repair_detail {

/// How many entities a stage touched, and the first few of them.
class Tally {
 public:
  void add(std::uint32_t id) {
    if (++count_ <= shown) first_.push_back(id);
  }
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] const std::vector<std::uint32_t>& first() const { return first_; }

 private:
  static constexpr std::size_t shown = 8;
  std::size_t count_ = 0;
  std::vector<std::uint32_t> first_;
};

/// The faces under repair. A face keeps its number and its corners their places until finish(); a
/// removed one is only marked. A corner c stands for the side from its vertex to that of next(c) as
/// well.
class Surface {
 public:
  /// Throws std::invalid_argument where lists do not fit each other or vertices do not exist.
  explicit Surface(MeshData& data);

  [[nodiscard]] MeshData& data() { return data_; }
  [[nodiscard]] const MeshData& data() const { return data_; }
  [[nodiscard]] std::uint32_t face_count() const {
    return static_cast<std::uint32_t>(data_.faces.size());
  }
  [[nodiscard]] std::uint32_t vertex_count() const {
    return static_cast<std::uint32_t>(data_.positions.size());
  }
  [[nodiscard]] std::uint32_t corner_count() const {
    return static_cast<std::uint32_t>(face_of_.size());
  }

  [[nodiscard]] bool alive(std::uint32_t f) const { return removed_[f] == 0; }
  void remove(std::uint32_t f) {
    removed_[f] = 1;
    ++removed_count_;
  }
  void restore(std::uint32_t f) {
    removed_[f] = 0;
    --removed_count_;
  }

  [[nodiscard]] std::uint32_t first_corner(std::uint32_t f) const { return begin_[f]; }
  [[nodiscard]] std::uint32_t face_of(std::uint32_t corner) const { return face_of_[corner]; }
  [[nodiscard]] std::uint32_t next(std::uint32_t corner) const {
    const std::uint32_t f = face_of_[corner];
    return corner + 1 < begin_[f] + size(f) ? corner + 1 : begin_[f];
  }
  [[nodiscard]] std::uint32_t vertex(std::uint32_t corner) const {
    return data_.faces.vertices[corner];
  }
  [[nodiscard]] std::span<const std::uint32_t> vertices(std::uint32_t f) const {
    return {data_.faces.vertices.data() + begin_[f], size(f)};
  }
  [[nodiscard]] std::span<std::uint32_t> vertices(std::uint32_t f) {
    return {data_.faces.vertices.data() + begin_[f], size(f)};
  }
  [[nodiscard]] const glm::dvec3& position(std::uint32_t v) const { return data_.positions[v]; }
  /// The class of a face; none where nothing is classified.
  [[nodiscard]] ModelRef face_class(std::uint32_t f) const {
    return data_.faces.classes.empty() ? ModelRef() : data_.faces.classes[f];
  }
  [[nodiscard]] ModelRef vertex_class(std::uint32_t v) const {
    return data_.vertex_classes.empty() ? ModelRef() : data_.vertex_classes[v];
  }
  /// Its length twice the area.
  [[nodiscard]] glm::dvec3 normal(std::uint32_t f) const;

  /// Fewer corners than before.
  void shrink(std::uint32_t f, std::span<const std::uint32_t> corners);
  void set_vertex(std::uint32_t corner, std::uint32_t v) { data_.faces.vertices[corner] = v; }
  void move_vertex(std::uint32_t v, const glm::dvec3& to) { data_.positions[v] = to; }
  /// A new vertex like v.
  std::uint32_t copy_vertex(std::uint32_t v);
  /// A face takes the class and the attributes of another.
  void take_properties(std::uint32_t f, std::uint32_t from);

  /// Calls visit(f) for the living faces in ascending order.
  template <typename Visit>
  void each_face(Visit&& visit) const {
    for (std::uint32_t f = 0; f < face_count(); ++f)
      if (alive(f)) visit(f);
  }
  /// Calls visit(corner) for all corners of living faces in ascending order.
  template <typename Visit>
  void each_corner(Visit&& visit) const {
    each_face([&](std::uint32_t f) {
      for (std::uint32_t c = begin_[f]; c < begin_[f] + size(f); ++c) visit(c);
    });
  }

  /// Drops the removed faces from all lists, and listed edges that have lost their last face.
  void finish();

 private:
  [[nodiscard]] std::uint32_t size(std::uint32_t f) const {
    return static_cast<std::uint32_t>(shape_template(data_.faces.shapes[f]).vertex_count);
  }
  void drop_bare_edges();

  MeshData& data_;
  std::vector<std::uint32_t> begin_;    ///< of each face in data.faces.vertices
  std::vector<std::uint32_t> face_of_;  ///< of each corner
  std::vector<std::uint8_t> removed_;
  std::size_t removed_count_ = 0;
  bool shrunk_ = false;
};

/// Keeps the entities of one dimension whose flag is not 0: their shapes, classes and attributes.
/// `begin` tells where the vertices of each start. Dimension 0: positions, nothing is renumbered.
void keep_entities(MeshData& data, int dim, const std::vector<std::uint8_t>& keep,
                   const std::vector<std::uint32_t>& begin = {});

}  // namespace aomd::repair_detail
