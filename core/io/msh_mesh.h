#pragma once
// Collects the nodes and elements of an MSH file and makes a mesh of them.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/io/msh.h"
#include "core/io/notes.h"
#include "core/mesh/handle.h"

namespace aomd::io::detail {

/// Tags in the order in which they come. As long as each is one more than the one before, as Gmsh
/// numbers them, only the first is stored.
class MshTagList {
 public:
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] std::uint64_t operator[](std::size_t i) const {
    return is_run_ ? first_ + i : tags_[i];
  }
  [[nodiscard]] std::uint64_t back() const { return (*this)[size_ - 1]; }
  void push_back(std::uint64_t tag);
  void pop_back();
  /// Each is one more than the one before.
  [[nodiscard]] bool is_run() const { return is_run_; }
  /// All of them, one by one; afterwards the list has none.
  [[nodiscard]] std::vector<std::uint64_t> take();
  /// The order that makes them ascend; empty where they do already.
  [[nodiscard]] std::vector<std::uint32_t> ascending_order() const;

 private:
  std::uint64_t first_ = 0;
  std::size_t size_ = 0;
  bool is_run_ = true;
  std::vector<std::uint64_t> tags_;  ///< where they are no run
};

/// Places of arbitrary tags in an ascending list.
class MshTags {
 public:
  /// `ascending` may hold a tag twice: the first counts.
  void build(std::vector<std::uint64_t> ascending);
  void build(MshTagList&& ascending);
  /// no_index where there is no such tag. O(1) where the tags are dense, otherwise O(log n).
  [[nodiscard]] std::uint32_t find(std::uint64_t tag) const {
    const std::uint64_t k = tag - first_;  // wraps below the first
    if (k < table_.size()) return table_[k];
    return contiguous_ ? (k < count_ ? static_cast<std::uint32_t>(k) : no_index) : search(tag);
  }

 private:
  [[nodiscard]] std::uint32_t search(std::uint64_t tag) const;

  std::vector<std::uint64_t> tags_;
  std::vector<std::uint32_t> table_;  ///< by tag - first_, where gaps are few
  std::uint64_t first_ = 0;
  std::size_t count_ = 0;  ///< where they are contiguous, and not stored
  bool contiguous_ = true;
};

/// The order that makes the tags ascend; empty where they do already.
[[nodiscard]] std::vector<std::uint32_t> ascending_order(const std::vector<std::uint64_t>& tags);

/// The values at these places, in this order.
template <class Value>
void permute(std::vector<Value>& values, const std::vector<std::uint32_t>& order) {
  std::vector<Value> result;
  result.reserve(order.size());
  for (const std::uint32_t i : order) result.push_back(values[i]);
  values = std::move(result);
}

/// Nodes first, then elements, then finish(). Vertices end up in the order of the node tags,
/// elements of each dimension in that of their tags: so a file can group them by model entity and
/// still keep their order.
class MshMesh {
 public:
  /// An element by the dimension and index of the mesh entity it became.
  struct Place {
    int dimension = 0;
    std::uint32_t index = no_index;
  };

  void reserve_nodes(std::size_t n);
  void add_node_tag(std::uint64_t tag, ModelRef model);
  void add_position(const glm::dvec3& p) { mesh_.positions.push_back(p); }
  [[nodiscard]] std::size_t node_count() const { return node_tags_.size(); }
  /// All nodes are there. Returns what is wrong with them, or an empty string.
  [[nodiscard]] std::string finish_nodes();

  /// So many elements are to come in all: lists grow to hold no more.
  void promise(std::uint64_t elements) { promised_ = elements; }
  /// Adds an element by its node tags; edges and faces with repeated nodes are mended or dropped.
  /// `physical` is that of MSH 2, 0 where there is none. Returns
  /// what is wrong, or an empty string.
  [[nodiscard]] std::string add(std::uint64_t tag, MshType type,
                                std::span<const std::uint64_t> nodes, ModelRef model,
                                std::int32_t physical);
  /// An element that the mesh does not keep, though views may refer to it.
  void drop(std::uint64_t tag) {
    ++added_;
    dropped_.push_back(tag);
  }
  [[nodiscard]] ModelTable& model() { return mesh_.model; }

  /// What a file says about where its vertices lie: nothing, by blocks of nodes, or for certain.
  enum class NodeClasses { None, Blocks, Entities };
  /// Sorts, drops repeated elements and nodes that only higher-order elements use, classifies the
  /// vertices: by their blocks (with a lower element's class where they contradict it), or by their
  /// lowest element. Where the file has no table of the model, makes one from the physical tags
  /// (`make_table`). Linear but for the sorting.
  void finish(NodeClasses known, bool make_table);

  /// After finish(). The vertex of a node, no_index where it was dropped or (`known` false) never
  /// there.
  [[nodiscard]] std::uint32_t vertex(std::uint64_t tag, bool& known) const;
  /// After finish(). The first element with this tag; index no_index where it was dropped or is a
  /// point.
  [[nodiscard]] Place element(std::uint64_t tag, bool& known) const;
  /// Whether there are faces without corners that their elements repeat.
  [[nodiscard]] bool has_cut_faces() const { return repeats_.cut > 0; }
  [[nodiscard]] MeshData& mesh() { return mesh_; }
  [[nodiscard]] std::vector<std::string>& notes() { return notes_; }

 private:
  /// Elements of one dimension.
  struct Elements {
    EntityList list;
    MshTagList tags;
    std::vector<std::int32_t> physical;  ///< one each, or none where all are 0

    [[nodiscard]] std::int32_t physical_of(std::size_t i) const {
      return physical.empty() ? 0 : physical[i];
    }
    void permute(const std::vector<std::uint32_t>& order);
  };

  template <class Value>
  void make_room(std::vector<Value>& values, std::size_t each) const;
  std::string mend_last(Elements& elements, std::span<const std::uint64_t> nodes);
  static void sort(Elements& elements);
  std::size_t drop_repeated(int dim);
  void drop_unused_nodes();
  void classify_vertices(NodeClasses known);
  [[nodiscard]] bool blocks_classify() const;
  void make_model();

  MeshData mesh_;
  std::vector<std::uint64_t> node_tags_;
  MshTags nodes_;
  std::vector<bool> corner_, inner_;         ///< nodes that elements use as a corner, and otherwise
  std::vector<std::uint32_t> new_vertices_;  ///< by node; empty where none was dropped
  std::array<Elements, 4> elements_;
  std::array<MshTags, 4> element_tags_;
  std::vector<std::uint64_t> dropped_;  ///< tags of elements that are not kept
  std::vector<std::pair<ModelRef, std::int32_t>> further_groups_;
  Repeats repeats_;
  std::size_t higher_order_ = 0;
  std::uint64_t promised_ = 0, added_ = 0;  ///< elements
  std::vector<std::string> notes_;
};

}  // namespace aomd::io::detail
