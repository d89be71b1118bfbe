#include "core/paper/paper.h"

#include <algorithm>
#include <array>

#include "core/mesh/derive.h"
#include "core/operators/edge_removal.h"
#include "core/operators/smooth.h"
#include "core/operators/swap.h"

namespace aomd::paper {
namespace {

void require(bool condition, const char* what) {
  if (!condition) throw std::invalid_argument(what);
}

// The mesh of an entity that is alive.
template <int Dim>
Mesh& mesh_of(const pEntity_<Dim>& e) {
  return e->list.mesh();
}

template <int Dim>
Handle<Dim> entity_in(pMesh_ mesh, const pEntity_<Dim>& e) {
  const Mesh& own = mesh_of(e);
  require(&own == &mesh->mesh, "an entity of another mesh");
  return e.entity();
}

ModelRef model_of(int classification, int tag) {
  require(classification >= 0 && classification <= 3, "the level of a model entity is 0 to 3");
  require(tag >= ModelRef::min_tag && tag <= ModelRef::max_tag, "a model tag out of range");
  return {classification, tag};
}

template <std::size_t N>
std::array<Vertex, N> vertices_in(pMesh_ mesh, const std::array<pVertex_, N>& vertices) {
  std::array<Vertex, N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = entity_in(mesh, vertices[i]);
  return result;
}

template <int J, int I>
pList_<pEntity_<J>> list_of(const pEntity_<I>& e) {
  pList_<pEntity_<J>> result;
  for (const Handle<J> h : adjacent<J>(mesh_of(e), e.entity())) result.emplace_back(e.session(), h);
  return result;
}

template <int J, int I>
pEntity_<J> item_of(const pEntity_<I>& e, int i) {
  const Mesh& mesh = mesh_of(e);
  const auto at = static_cast<std::size_t>(i);
  if (!mesh.stored(I, J)) return {e.session(), adjacent<J>(mesh, e.entity()).at(at)};
  const Row<J> row = mesh.template row<J>(e.entity());
  if (at >= row.size()) throw std::out_of_range(std::string("no such ") + entity_name(J));
  return {e.session(), row[at]};
}

template <int Dim>
pEntity_<Dim> next_of(pMesh_ mesh, int* next) {
  const IdPool& ids = mesh->mesh.ids(Dim);
  const std::uint32_t id = ids.next_alive(static_cast<std::uint32_t>(*next));
  if (id >= ids.capacity()) return {};
  *next = static_cast<int>(id) + 1;
  return {mesh, Handle<Dim>(id)};
}

// The mesh behind a surface operator, which has what that needs.
void need(const Mesh& m, std::initializer_list<std::pair<int, int>> relations, const char* where) {
  for (const auto& [i, j] : relations)
    if (!m.stored(i, j))
      throw std::logic_error("M_setAdjacency_(mesh," + std::to_string(i) + "," + std::to_string(j) +
                             ",1) first: the operators on " + where + " need it");
}

Mesh& surface(pMesh_ mesh) {
  Mesh& m = mesh->mesh;
  need(m, {{2, 0}, {0, 1}, {0, 2}}, "surfaces");
  if (m.count(3) > 0 || m.representation().down(2, 0).stride() != 3)
    throw std::logic_error("this operator is for surfaces of triangles");
  return m;
}

Mesh& volume(pMesh_ mesh) {
  Mesh& m = mesh->mesh;
  if (m.count(3) == 0) throw std::logic_error("this operator is for volumes of tetrahedra");
  need(m, {{2, 0}, {0, 1}, {0, 2}, {3, 0}, {0, 3}}, "volumes");
  return m;
}

// The edges opposite to a vertex in its tetrahedra, each once.
std::vector<EdgeEnds> opposite_edges(const Mesh& m, Vertex v) {
  std::vector<EdgeEnds> opposite;
  Ball ball;
  gather(m, v, ball);
  for (const BallRegion& r : ball)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(r.others[k], r.others[(k + 1) % 3]);
      opposite.push_back({low, high});
    }
  std::sort(opposite.begin(), opposite.end());
  opposite.erase(std::unique(opposite.begin(), opposite.end()), opposite.end());
  return opposite;
}

int remove_opposite_edges(Mesh& m, pMesh_ mesh, pVertex_ vertex) {
  int removed = 0;
  EdgeRemoval plan;
  for (const auto& [a, b] : opposite_edges(m, entity_in(mesh, vertex))) {
    if (!judge(m, a, b, {mesh->improve}, plan).accepted()) continue;
    apply(m, plan);
    ++removed;
  }
  return removed;
}

int move_in_volume(Mesh& m, pMesh_ mesh, pVertex_ vertex) {
  if (!mesh->region_mover) mesh->region_mover.emplace(m);
  MoveRules rules;
  rules.max_turn = mesh->improve;
  rules.model = mesh->model;
  if (!mesh->region_mover->judge(m, entity_in(mesh, vertex), rules, mesh->move).accepted())
    return 0;
  RegionMover::apply(m, mesh->move);
  return 1;
}

}  // namespace

pFace_ F_create_(pMesh_ mesh, pVertex_ v0, pVertex_ v1, pVertex_ v2, int classification, int tag) {
  const auto v = vertices_in<3>(mesh, {v0, v1, v2});
  return {mesh, mesh->mesh.create_face(v, model_of(classification, tag))};
}

pRegion_ R_create_(pMesh_ mesh, pVertex_ v0, pVertex_ v1, pVertex_ v2, pVertex_ v3, RTip_ type,
                   int classification, int tag) {
  return R_create_(mesh, {v0, v1, v2, v3}, type, classification, tag);
}

pRegion_ R_create_(pMesh_ mesh, std::initializer_list<pVertex_> vertices, RTip_ type,
                   int classification, int tag) {
  std::vector<Vertex> v;
  for (const pVertex_& vertex : vertices) v.push_back(entity_in(mesh, vertex));
  return {mesh,
          mesh->mesh.create_region(static_cast<Shape>(type), v, model_of(classification, tag))};
}

void F_delete_(pMesh_ mesh, pFace_ face) { mesh->mesh.destroy(entity_in(mesh, face)); }

pEdge_ E_exists_(pVertex_ v0, pVertex_ v1) {
  const auto v = vertices_in<2>(v0.session(), {v0, v1});
  return {v0.session(), mesh_of(v0).find_edge(v[0], v[1])};
}

pFace_ F_exists_(pVertex_ v0, pVertex_ v1, pVertex_ v2) {
  return {v0.session(), mesh_of(v0).find_face(vertices_in<3>(v0.session(), {v0, v1, v2}))};
}

pRegion_ R_exists_(pVertex_ v0, pVertex_ v1, pVertex_ v2, pVertex_ v3) {
  return {v0.session(), mesh_of(v0).find_region(vertices_in<4>(v0.session(), {v0, v1, v2, v3}))};
}

pList_<pFace_> E_faces_(pEdge_ edge) { return list_of<2>(edge); }
pFace_ E_face_(pEdge_ edge, int i) { return item_of<2>(edge, i); }
pList_<pRegion_> E_regions_(pEdge_ edge) { return list_of<3>(edge); }
pVertex_ E_vertex_(pEdge_ edge, int i) { return item_of<0>(edge, i); }
pFace_ R_face_(pRegion_ region, int i) { return item_of<2>(region, i); }

int R_dirFace_(pRegion_ region, pFace_ face) {
  Mesh& m = mesh_of(region);
  const Face f = entity_in(region.session(), face);
  if (!m.stored(3, 2)) region.session()->region_faces = m.request(3, 2, "paper session");
  const auto faces = m.row<2>(region.entity()).indices();
  require(std::find(faces.begin(), faces.end(), f.index) != faces.end(),
          "the region does not use this face");
  return m.use_direction(region.entity(), f);
}

double E_length_(pEdge_ edge) {
  const Mesh& m = mesh_of(edge);
  const auto [a, b] = m.edge_vertices(edge.entity());
  return glm::length(m.position(a) - m.position(b));
}

void G_snapVertex_(pModel_ model, pVertex_ vertex) {
  snap(*model, mesh_of(vertex), vertex.entity());
}

pGFace_ F_modeling_(pFace_ face) {
  const ModelRef model = mesh_of(face).classification(face.entity());
  return model.dimension() == 2 ? pGFace_{face.session(), model} : pGFace_{};
}

pFace_ G_nextFace_(pGFace_ model_face, iterator* it) {
  require(static_cast<bool>(model_face), "this model face is null");
  Mesh& m = model_face.session->mesh;
  if (!it->started) {
    if (!m.class_lists()) m.keep_class_lists(true);
    const auto faces = m.class_lists()->entities(2, model_face.model);
    it->faces.assign(faces.begin(), faces.end());
    std::sort(it->faces.begin(), it->faces.end());
    it->started = true;
  }
  while (it->next < it->faces.size()) {
    const Face f(it->faces[it->next++]);
    if (m.alive(f) && m.classification(f) == model_face.model) return {model_face.session, f};
  }
  return {};
}

pEdge_ M_nextEdge_(pMesh_ mesh, int* next) { return next_of<1>(mesh, next); }
pVertex_ M_nextVertex_(pMesh_ mesh, int* next) { return next_of<0>(mesh, next); }

int E_2Dcollapse_(pMesh_ mesh, pEdge_ edge, pVertex_ vertex) {
  Mesh& m = surface(mesh);
  const Edge e = entity_in(mesh, edge);
  const Vertex v = entity_in(mesh, vertex);
  const auto [a, b] = m.edge_vertices(e);
  require(v == a || v == b, "the vertex is no end of the edge");
  if (!mesh->collapser) mesh->collapser.emplace(m);
  CollapsePlan& plan = mesh->plan;
  if (!mesh->collapser->judge(m, e, v, mesh->collapse, plan).accepted()) return 0;
  mesh->collapser->apply(m, plan);
  return 1;
}

int E_3Dcollapse_(pMesh_ mesh, pEdge_ edge, pVertex_ vertex) {
  Mesh& m = volume(mesh);
  const Edge e = entity_in(mesh, edge);
  const Vertex v = entity_in(mesh, vertex);
  const auto [a, b] = m.edge_vertices(e);
  require(v == a || v == b, "the vertex is no end of the edge");
  if (!mesh->region_collapser) mesh->region_collapser.emplace(m);
  VolumeRules rules;
  rules.faces = mesh->collapse;
  RegionCollapser& collapser = *mesh->region_collapser;
  if (!collapser.judge(m, e, {v == a, v == b}, rules, mesh->plan).accepted()) return 0;
  collapser.apply(m, mesh->plan);
  return 1;
}

int V_swapOpEdges_(pMesh_ mesh, pVertex_ vertex) {
  if (mesh->mesh.count(3) > 0) return remove_opposite_edges(volume(mesh), mesh, vertex);
  Mesh& m = surface(mesh);
  const Vertex v = entity_in(mesh, vertex);
  mesh->opposite.clear();
  for (const Face f : m.row<2>(v)) {
    const auto [a, b, c] = m.triangle(f);
    mesh->opposite.push_back(a == v   ? m.find_edge(b, c)
                             : b == v ? m.find_edge(c, a)
                                      : m.find_edge(a, b));
  }
  int swaps = 0;
  for (const Edge e : mesh->opposite) {
    EdgePair pair;
    if (!judge_swap(m, e, mesh->improve, pair).accepted()) continue;
    apply_swap(m, e, pair);
    ++swaps;
  }
  return swaps;
}

int V_smooth_(pMesh_ mesh, pVertex_ vertex) {
  if (mesh->mesh.count(3) > 0) return move_in_volume(volume(mesh), mesh, vertex);
  Mesh& m = surface(mesh);
  const Vertex v = entity_in(mesh, vertex);
  glm::dvec3 target;
  if (!judge_smooth(m, v, {mesh->improve, mesh->model}, target).accepted()) return 0;
  apply_smooth(m, v, target);
  return 1;
}

void M_setAdjacency_(pMesh_ mesh, int i, int j, int value) {
  if (value)
    mesh->mesh.set(i, j);
  else
    mesh->mesh.unset(i, j);
}

pVertex_ V_create_(pMesh_ mesh, double x, double y, double z, int classification, int tag) {
  return {mesh, mesh->mesh.create_vertex({x, y, z}, model_of(classification, tag))};
}

}  // namespace aomd::paper
