#pragma once
// The model of an MSH 4.1 file: its entities, and those that partitioning has made of them.

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "core/io/msh.h"
#include "core/mesh/model_table.h"

namespace aomd::io::detail {

/// Reads $Entities and $PartitionedEntities, and tells what model entity a block lies on: of the
/// parts of an entity, the entity itself.
template <class Body>
class MshEntities {
 public:
  MshEntities(ModelTable& model, MshVersion version) : model_(model), version_(version) {}

  void read(Body& body) {
    std::uint64_t counts[4];
    for (std::uint64_t& n : counts) n = body.count("the number of entities");
    for (int dim = 0; dim <= 3; ++dim)
      for (std::uint64_t i = 0; i < counts[dim]; ++i) add(entity(dim, tag(dim, body), body));
  }

  void read_partitioned(Body& body) {
    body.count("the number of parts");
    const std::uint64_t ghosts = body.count("the number of ghost entities");
    for (std::uint64_t i = 0; i < 2 * ghosts; ++i) body.integer("a ghost entity");
    std::uint64_t counts[4];
    for (std::uint64_t& n : counts) n = body.count("the number of entities");
    for (int dim = 0; dim <= 3; ++dim)
      for (std::uint64_t i = 0; i < counts[dim]; ++i) part(dim, body);
    std::sort(known_.begin(), known_.end());
    for (auto& [ref, entity] : parents_)
      if (!std::binary_search(known_.begin(), known_.end(), ref)) add(std::move(entity));
  }

  /// The entity of a block. It is of higher dimension where the block lies on a border between
  /// parts, which the model does not have. Tag 0 stands for no classification: our writer's word
  /// for it, and MSH 2's.
  ModelRef model_ref(int dimension, std::int32_t tag, const Body& body) const {
    const ModelRef own = checked(dimension, tag, body);
    const auto parent = parent_of_.find(own);
    return parent == parent_of_.end() ? own : parent->second;
  }
  [[nodiscard]] bool partitioned() const { return !parent_of_.empty(); }

 private:
  static ModelRef checked(int dimension, std::int32_t tag, const Body& body) {
    if (tag < ModelRef::min_tag || tag > ModelRef::max_tag)
      body.fail("entity tag " + std::to_string(tag) + " is out of range");
    return tag == 0 ? ModelRef() : ModelRef(dimension, tag);
  }

  static ModelRef tag(int dim, Body& body) {
    return checked(dim, body.integer("the tag of an entity"), body);
  }

  static std::vector<std::int32_t> tags(const char* what, Body& body) {
    const std::uint64_t n = body.count(what);
    std::vector<std::int32_t> result;
    for (std::uint64_t i = 0; i < n; ++i) result.push_back(body.integer("a tag"));
    return result;
  }

  /// What follows the tag, and the parts that it belongs to. In version 4.0 vertices have a box
  /// too.
  ModelEntity entity(int dim, ModelRef ref, Body& body) const {
    ModelEntity entity;
    entity.ref = ref;
    const bool point = dim == 0 && version_ == MshVersion::V41;
    for (std::size_t k = 0; k < (point ? 3u : 6u); ++k)
      entity.box[k] = body.real("the box of an entity");
    if (point) std::copy_n(entity.box.begin(), 3, entity.box.begin() + 3);
    entity.groups = tags("the number of physical tags", body);
    if (dim > 0) entity.boundary = tags("the number of bounding entities", body);
    return entity;
  }

  void add(ModelEntity entity) {
    if (!entity.ref.valid()) return;
    known_.push_back(entity.ref);
    model_.entities.push_back(std::move(entity));
  }

  void part(int dim, Body& body) {
    const ModelRef own = tag(dim, body);
    const std::int32_t parent_dim = body.integer("the dimension of a parent");
    if (parent_dim < dim || parent_dim > 3)
      body.fail("a parent of dimension " + std::to_string(parent_dim));
    const ModelRef parent = tag(parent_dim, body);
    tags("the number of parts", body);
    ModelEntity entity = this->entity(dim, parent, body);
    if (own.valid()) parent_of_[own] = parent;
    if (parent.dimension() != dim) return;
    entity.boundary.clear();  // those of the part
    parents_.try_emplace(parent, std::move(entity));
  }

  ModelTable& model_;
  MshVersion version_;
  std::vector<ModelRef> known_;
  std::map<ModelRef, ModelRef> parent_of_;
  std::map<ModelRef, ModelEntity> parents_;  ///< as one of their parts describes them
};

}  // namespace aomd::io::detail
