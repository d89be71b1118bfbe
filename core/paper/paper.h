#pragma once
// The calls of the paper by their own names, so that its programs run as printed
// (tests/paper/paper_test.cpp). Each is a few lines over core/mesh, core/model and core/operators,
// which new programs use directly.
//
// All throw std::invalid_argument for a null or deleted entity, one of another mesh, or one that
// does not belong to the other argument, and std::logic_error naming the T(I,J) to set where a
// relation is missing.

#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/paper/types.h"

#pragma GCC visibility push(default)

namespace aomd::paper {

/// (1), (3): the model entity is of level `classification`, 0 to 3, and id `tag`. Throw as
/// Mesh::create_face and Mesh::create_region do.
pFace_ F_create_(pMesh_ mesh, pVertex_ v0, pVertex_ v1, pVertex_ v2, int classification, int tag);
pRegion_ R_create_(pMesh_ mesh, pVertex_ v0, pVertex_ v1, pVertex_ v2, pVertex_ v3, RTip_ type,
                   int classification, int tag);
/// For types with any number of vertices.
pRegion_ R_create_(pMesh_ mesh, std::initializer_list<pVertex_> vertices, RTip_ type,
                   int classification, int tag);
/// Deletes a face that no region uses; its edges and vertices stay.
void F_delete_(pMesh_ mesh, pFace_ face);

/// (2), section 2.1.1: the entity on these vertices in any order, or null.
[[nodiscard]] pEdge_ E_exists_(pVertex_ v0, pVertex_ v1);
[[nodiscard]] pFace_ F_exists_(pVertex_ v0, pVertex_ v1, pVertex_ v2);
[[nodiscard]] pRegion_ R_exists_(pVertex_ v0, pVertex_ v1, pVertex_ v2, pVertex_ v3);

/// (2), (4): adjacency, by the cheapest path that T offers; the i-th throws std::out_of_range past
/// the last.
[[nodiscard]] pList_<pFace_> E_faces_(pEdge_ edge);
[[nodiscard]] pFace_ E_face_(pEdge_ edge, int i);
[[nodiscard]] pList_<pRegion_> E_regions_(pEdge_ edge);
[[nodiscard]] pVertex_ E_vertex_(pEdge_ edge, int i);
[[nodiscard]] pFace_ R_face_(pRegion_ region, int i);
/// 1 where the region uses the face in the face's own direction, 0 where in the opposite one. The
/// first call stores T(3,2) for as long as the Session lives, O(regions); later ones are O(1).
[[nodiscard]] int R_dirFace_(pRegion_ region, pFace_ face);
[[nodiscard]] double E_length_(pEdge_ edge);

/// (5): moves the vertex to the closest point of the model entity that it is classified on. Throws
/// as aomd::snap does.
void G_snapVertex_(pModel_ model, pVertex_ vertex);

/// (6): the model face that a face is classified on, null where it is on none; and the faces on it,
/// by ascending ids, null after the last. A loop sees the faces that were on the model face when it
/// began and still are: any may be deleted meanwhile. The first loop builds Mesh::class_lists(),
/// which edits keep from then on.
[[nodiscard]] pGFace_ F_modeling_(pFace_ face);
[[nodiscard]] pFace_ G_nextFace_(pGFace_ model_face, iterator* it);

/// Figure 7: the first edge or vertex with an id of *next or more, null after the last; *next
/// starts at 0. Any entity may be deleted meanwhile.
[[nodiscard]] pEdge_ M_nextEdge_(pMesh_ mesh, int* next);
[[nodiscard]] pVertex_ M_nextVertex_(pMesh_ mesh, int* next);

/// Figure 7: deletes the end `vertex` by collapsing the edge onto the other one, if
/// Session::collapse allows it. 1 when done, 0 when refused. For triangles without regions and with
/// T(0,1), T(0,2), T(2,0).
int E_2Dcollapse_(pMesh_ mesh, pEdge_ edge, pVertex_ vertex);
/// The same among tetrahedra, which always keep the topology: T(0,3) and T(3,0) beside these.
int E_3Dcollapse_(pMesh_ mesh, pEdge_ edge, pVertex_ vertex);
/// Swaps those edges opposite to the vertex in its faces whose swap makes the smallest angle
/// larger; among tetrahedra removes those opposite to it in its regions where the worst shape
/// grows. Returns how many. What must be stored: as above, also for the next one.
int V_swapOpEdges_(pMesh_ mesh, pVertex_ vertex);
/// Moves the vertex to the average of its neighbours, on a model edge of those along it, and onto
/// Session::model; among tetrahedra where the worst around it gets better (RegionMover). 1 when
/// done.
int V_smooth_(pMesh_ mesh, pVertex_ vertex);

/// Figure 7: the number of that name attached to an entity: Mesh::attached<Vertex, double> and so
/// on. Throws std::invalid_argument where there is none.
template <int Dim>
[[nodiscard]] double L_dataD_(const DataList_<Dim>& list, std::string_view name) {
  const auto* column = list.mesh().template find_attached<Handle<Dim>, double>(name);
  if (!column)
    throw std::invalid_argument("no number named \"" + std::string(name) + "\" is attached");
  return (*column)[list.entity];
}

// What the paper's programs need and the paper does not print, in its style
// -------------------------------------
/// T(i,j) = value, 1 or 0. Throws as Mesh::set and Mesh::unset do.
void M_setAdjacency_(pMesh_ mesh, int i, int j, int value);
pVertex_ V_create_(pMesh_ mesh, double x, double y, double z, int classification, int tag);
/// Sets what L_dataD_ reads; makes the column, 0 for all others, when there is none.
template <int Dim>
void L_putDataD_(const DataList_<Dim>& list, std::string_view name, double value) {
  list.mesh().template attached<Handle<Dim>, double>(name)[list.entity] = value;
}

}  // namespace aomd::paper

#pragma GCC visibility pop
