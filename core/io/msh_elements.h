#pragma once
// The elements of an MSH file of any version.

#include <array>
#include <type_traits>

#include "core/io/msh_entities.h"
#include "core/io/msh_mesh.h"
#include "core/io/msh_parts.h"

namespace aomd::io::detail {

/// Reads $Elements behind the name of the section.
template <class Body>
class MshElements {
 public:
  MshElements(const Source& source, MshVersion version, const MshEntities<Body>& entities,
              MshMesh& mesh)
      : source_(source), version_(version), entities_(entities), mesh_(mesh) {}

  void read(Body& body) { version_ < MshVersion::V40 ? list(body) : blocks(body); }
  /// Elements on borders between parts, which are dropped.
  [[nodiscard]] std::uint64_t between_parts() const { return between_parts_; }

 private:
  static MshType type(Body& body) {
    const std::int32_t number = body.integer("an element type");
    const auto type = msh_type(number);
    if (!type)
      body.fail("element type " + std::to_string(number) + " is not one that is known here");
    return *type;
  }

  void blocks(Body& body) {
    const std::uint64_t blocks = body.count("the number of blocks");
    const std::uint64_t n = body.count("the number of elements");
    if (wide()) {
      body.count("the smallest element tag");
      body.count("the largest element tag");
    }
    msh_check_room(source_, body, n, 2 * (wide() ? Body::long_size : Body::int_size), "elements");
    mesh_.promise(n);
    std::uint64_t found = 0;
    for (std::uint64_t b = 0; b < blocks; ++b) found += block(body, n - found);
    if (found != n) {
      body.fail("the section promises " + counted(n, "element") + ", its blocks hold " +
                std::to_string(found));
    }
  }

  std::uint64_t block(Body& body, std::uint64_t most) {
    const auto [dim, entity] = msh_block_entity(body, version_);
    const ModelRef model = entities_.model_ref(dim, entity, body);
    const bool between_parts = model.valid() && model.dimension() != dim;
    const MshType kind = type(body);
    if (!model.may_classify(shape_template(kind.shape).dimension)) {
      body.fail("a " + std::string(shape_template(kind.shape).name) +
                " cannot lie on a model entity of dimension " + std::to_string(dim));
    }
    const std::uint64_t n = body.count("the number of elements");
    if (n > most) body.fail("the blocks hold more elements than the section promises");
    for (std::uint64_t i = 0; i < n; ++i) {
      const std::uint64_t tag = tag_of(body, "an element tag");
      const auto nodes = std::span(nodes_).first(static_cast<std::size_t>(kind.nodes));
      for (std::uint64_t& node : nodes) node = tag_of(body, "a node tag");
      between_parts ? mesh_.drop(tag) : add(body, tag, kind, model, 0);
    }
    between_parts_ += between_parts ? n : 0;
    return n;
  }

  /// Tags have 64 bits in version 4.1 alone.
  [[nodiscard]] bool wide() const { return version_ == MshVersion::V41; }
  std::uint64_t tag_of(Body& body, const char* what) const {
    return wide() ? body.count(what) : static_cast<std::uint64_t>(body.integer(what));
  }

  void add(const Body& body, std::uint64_t tag, MshType kind, ModelRef model,
           std::int32_t physical) {
    const auto nodes = std::span(nodes_).first(static_cast<std::size_t>(kind.nodes));
    const std::string wrong = mesh_.add(tag, kind, nodes, model, physical);
    if (!wrong.empty()) body.fail(wrong);
  }

  void list(Body& body) {
    const std::uint64_t n = msh_count_line(body, "the number of elements");
    msh_check_room(source_, body, n, Body::int_size * 2, "elements");
    mesh_.promise(n);
    if constexpr (std::is_same_v<Body, MshText>) {
      for (std::uint64_t i = 0; i < n; ++i) listed(body);
    } else {
      for (std::uint64_t found = 0; found < n;) found += run(body, n - found);
    }
  }

  void listed(Body& body) {
    const std::uint64_t tag = body.count("an element tag");
    const MshType kind = type(body);
    if (version_ == MshVersion::V1) return element1(body, tag, kind);
    element(body, tag, kind, body.integer("the number of tags"));
  }

  /// Binary files of version 2 list elements in runs of one type and number of tags.
  std::uint64_t run(Body& body, std::uint64_t most) {
    const MshType kind = type(body);
    const std::int32_t n = body.integer("the number of elements");
    if (n < 1 || static_cast<std::uint64_t>(n) > most)
      body.fail("a run of " + std::to_string(n) + " elements where " + std::to_string(most) +
                " are left");
    const std::int32_t tags = body.integer("the number of tags");
    for (std::int32_t i = 0; i < n; ++i)
      element(body, static_cast<std::uint32_t>(body.integer("an element tag")), kind, tags);
    return static_cast<std::uint64_t>(n);
  }

  /// The tags are: physical group, model entity, and others that mean nothing to us.
  void element(Body& body, std::uint64_t tag, MshType kind, std::int32_t tags) {
    if (tags < 0) body.fail("a negative number of tags");
    std::int32_t physical = 0, elementary = 0;
    for (std::int32_t k = 0; k < tags; ++k) {
      const std::int32_t value = body.integer("a tag");
      if (k == 0) physical = value;
      if (k == 1) elementary = value;
    }
    nodes_of_element(body, tag, kind, physical, elementary);
  }

  /// Of version 1: always two tags, and the number of nodes.
  void element1(Body& body, std::uint64_t tag, MshType kind) {
    const std::int32_t physical = body.integer("a tag"), elementary = body.integer("a tag");
    if (const std::int32_t n = body.integer("the number of nodes"); n != kind.nodes)
      body.fail("element " + std::to_string(tag) + " has " + counted(kind.nodes, "node") +
                " by its type, not " + std::to_string(n));
    nodes_of_element(body, tag, kind, physical, elementary);
  }

  void nodes_of_element(Body& body, std::uint64_t tag, MshType kind, std::int32_t physical,
                        std::int32_t elementary) {
    const ModelRef model = entities_.model_ref(shape_template(kind.shape).dimension,
                                               elementary != 0 ? elementary : physical, body);
    for (int k = 0; k < kind.nodes; ++k)
      nodes_[static_cast<std::size_t>(k)] = static_cast<std::uint64_t>(body.integer("a node tag"));
    add(body, tag, kind, model, physical);
  }

  const Source& source_;
  MshVersion version_;
  const MshEntities<Body>& entities_;
  MshMesh& mesh_;
  std::array<std::uint64_t, max_msh_nodes> nodes_{};
  std::uint64_t between_parts_ = 0;
};

}  // namespace aomd::io::detail
