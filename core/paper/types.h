#pragma once
// The types of the paper's programs: handles that know their mesh.

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/mesh/mesh.h"
#include "core/model/model.h"
#include "core/operators/region_collapse.h"
#include "core/operators/region_move.h"

#pragma GCC visibility push(default)

namespace aomd::paper {

/// What stands behind a pMesh_: a mesh, which must outlive it, the limits of the operators, and the
/// scratch space that makes a call cost what the operator costs. `Session session(mesh); pMesh_
/// mesh = &session;`
struct Session {
  explicit Session(Mesh& m) : mesh(m) {}
  Mesh& mesh;
  CollapseRules collapse{TurnLimit(10), TopologyRule::Paper};  ///< of E_2Dcollapse_, E_3Dcollapse_
  TurnLimit improve{10};                                       ///< of V_swapOpEdges_ and V_smooth_
  const Model* model = nullptr;  ///< V_smooth_ snaps to it when there is one

  // Made by the calls when first needed
  std::optional<Collapser> collapser;
  std::optional<RegionCollapser> region_collapser;
  std::optional<RegionMover> region_mover;
  VolumeCollapsePlan plan;
  RegionMove move;
  std::vector<Edge> opposite;
  Request region_faces;
};
using pMesh_ = Session*;
using pModel_ = const Model*;

/// What `vertex->list` is: the data attached to one entity, see L_dataD_.
template <int Dim>
struct DataList_ {
  pMesh_ session = nullptr;
  Handle<Dim> entity;

  /// Throws std::invalid_argument for a null or deleted entity.
  [[nodiscard]] Mesh& mesh() const {
    if (!session || !session->mesh.alive(entity))
      throw std::invalid_argument(std::string("this ") + entity_name(Dim) + " is null or deleted");
    return session->mesh;
  }
};

/// A handle that knows its mesh; false when null. Deleting the entity leaves it dangling, as a
/// pointer would be.
template <int Dim>
class pEntity_ {
 public:
  struct Fields {
    DataList_<Dim> list;
    const Fields* operator->() const { return this; }
  };
  pEntity_() = default;
  pEntity_(pMesh_ session, Handle<Dim> entity) : session_(session), entity_(entity) {}

  [[nodiscard]] pMesh_ session() const { return session_; }
  [[nodiscard]] Handle<Dim> entity() const { return entity_; }
  explicit operator bool() const { return entity_.valid(); }
  Fields operator->() const { return {{session_, entity_}}; }
  friend bool operator==(const pEntity_&, const pEntity_&) = default;

 private:
  pMesh_ session_ = nullptr;
  Handle<Dim> entity_;
};
using pVertex_ = pEntity_<0>;
using pEdge_ = pEntity_<1>;
using pFace_ = pEntity_<2>;
using pRegion_ = pEntity_<3>;

/// A list of entities; `pList_ faces = E_faces_(edge);` finds the kind by itself.
template <typename P>
struct pList_ : std::vector<P> {};

/// A model face as the mesh knows it; false when null.
struct pGFace_ {
  pMesh_ session = nullptr;
  ModelRef model;
  explicit operator bool() const { return model.valid(); }
};

/// Where G_nextFace_ stands; one that has been nowhere yet starts a loop.
struct iterator {
  bool started = false;
  std::vector<std::uint32_t> faces;
  std::size_t next = 0;
};

enum RTip_ {
  TETRAHEDRON = static_cast<int>(Shape::Tetrahedron),
  PYRAMID = static_cast<int>(Shape::Pyramid),
  PRISM = static_cast<int>(Shape::Prism),
  HEXAHEDRON = static_cast<int>(Shape::Hexahedron)
};

}  // namespace aomd::paper

#pragma GCC visibility pop
