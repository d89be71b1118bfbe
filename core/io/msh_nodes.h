#pragma once
// The nodes of an MSH file of any version.

#include "core/io/msh_entities.h"
#include "core/io/msh_mesh.h"
#include "core/io/msh_parts.h"

namespace aomd::io::detail {

/// Reads $Nodes, and $ParametricNodes of version 2, behind the name of the section.
template <class Body>
class MshNodes {
 public:
  MshNodes(const Source& source, MshVersion version, const MshEntities<Body>& entities,
           MshMesh& mesh)
      : source_(source), version_(version), entities_(entities), mesh_(mesh) {}

  void read(Body& body, bool parametric) {
    version_ < MshVersion::V40 ? list(body, parametric) : blocks(body);
  }

 private:
  void position(Body& body) {
    const double x = body.real("x"), y = body.real("y"), z = body.real("z");
    mesh_.add_position({x, y, z});
  }

  /// Of 64 bits in version 4.1.
  std::uint64_t tag(Body& body) const {
    const std::int64_t tag = version_ == MshVersion::V41
                                 ? static_cast<std::int64_t>(body.count("a node tag"))
                                 : body.integer("a node tag");
    if (tag < 1) body.fail("node tag " + std::to_string(tag) + ", expected 1 or more");
    return static_cast<std::uint64_t>(tag);
  }

  void list(Body& body, bool parametric) {
    const std::uint64_t n = msh_count_line(body, "the number of nodes");
    msh_check_room(source_, body, n, Body::int_size + 3 * Body::real_size, "nodes");
    mesh_.reserve_nodes(static_cast<std::size_t>(n));
    for (std::uint64_t i = 0; i < n; ++i) {
      const std::uint64_t node = tag(body);
      position(body);
      mesh_.add_node_tag(node, parametric ? class_and_parameters(body) : ModelRef());
    }
  }

  /// Behind the position of a parametric node.
  ModelRef class_and_parameters(Body& body) {
    const int dim = msh_dimension(body);
    const ModelRef model = entities_.model_ref(dim, body.integer("an entity tag"), body);
    for (int k = 0; k < dim && dim < 3; ++k) body.value("a parameter");
    return model;
  }

  void blocks(Body& body) {
    const std::uint64_t blocks = body.count("the number of blocks");
    const std::uint64_t n = body.count("the number of nodes");
    if (version_ == MshVersion::V41) {
      body.count("the smallest node tag");
      body.count("the largest node tag");
    }
    const std::size_t tag_size = version_ == MshVersion::V41 ? Body::long_size : Body::int_size;
    msh_check_room(source_, body, n, tag_size + 3 * Body::real_size, "nodes");
    mesh_.reserve_nodes(static_cast<std::size_t>(n));
    for (std::uint64_t b = 0; b < blocks; ++b) block(body, n - mesh_.node_count());
    if (mesh_.node_count() != n) {
      body.fail("the section promises " + counted(n, "node") + ", its blocks hold " +
                std::to_string(mesh_.node_count()));
    }
  }

  /// Version 4.1 lists all tags of a block before the positions, 4.0 each before its own.
  void block(Body& body, std::uint64_t most) {
    const auto [dim, entity] = msh_block_entity(body, version_);
    const ModelRef model = entities_.model_ref(dim, entity, body);
    const std::int32_t parametric = body.integer("the parametric flag");
    if (parametric != 0 && parametric != 1) body.fail("the parametric flag is neither 0 nor 1");
    const std::uint64_t n = body.count("the number of nodes");
    if (n > most) body.fail("the blocks hold more nodes than the section promises");
    const bool old = version_ == MshVersion::V40;
    for (std::uint64_t i = 0; i < n && !old; ++i) mesh_.add_node_tag(tag(body), model);
    for (std::uint64_t i = 0; i < n; ++i) {
      if (old) mesh_.add_node_tag(tag(body), model);
      position(body);
      for (int k = 0; k < (old && dim == 3 ? 0 : dim) * parametric; ++k) body.value("a parameter");
    }
  }

  const Source& source_;
  MshVersion version_;
  const MshEntities<Body>& entities_;
  MshMesh& mesh_;
};

}  // namespace aomd::io::detail
