#include "core/mesh/bulk.h"

#include <algorithm>
#include <utility>

#include "core/base/assertion.h"

namespace aomd {
namespace {

bool has_holes(const Mesh& mesh, int dim) { return !mesh.ids(dim).free_ids().empty(); }

std::uint32_t widest(const VertexRows& rows, int lower) {
  if (rows.uniform()) return static_cast<std::uint32_t>(rows.uniform()->count(lower));
  int most = 0;
  rows.each([&](std::uint32_t id, const std::uint32_t*) {
    most = std::max(most, rows.shape(id).count(lower));
  });
  return static_cast<std::uint32_t>(std::max(most, 1));
}

bool all_triangles(const VertexRows& faces) {
  return faces.uniform() && faces.uniform()->vertex_count == 3;
}

// Calls work(shape, each) with the one shape of all entities, or with none: a loop over entities of
// one shape need not look it up for each.
template <typename Work>
void for_shape(const VertexRows& rows, Work&& work) {
  if (rows.uniform())
    work([shape = rows.uniform()](std::uint32_t) -> const ShapeTemplate& { return *shape; });
  else
    work([&rows](std::uint32_t id) -> const ShapeTemplate& { return rows.shape(id); });
}

template <typename Key, typename ShapeOf, typename MakeKey, typename Same>
void match(const VertexRows& rows, int j, const SideIndex<Key>& index, ShapeOf shape_of,
           MakeKey key, Same same, bool with_directions, DownRows& result) {
  std::uint32_t* const out = result.row(0);
  const std::size_t stride = result.stride();
  rows.each([&, out, stride](std::uint32_t id, const std::uint32_t* v) {
    const ShapeTemplate& shape = shape_of(id);
    std::uint32_t* const row = out + id * stride;
    const int n = shape.count(j);
    unsigned bits = 0;
    for (int k = 0; k < n; ++k) {
      const Key wanted = key(shape, k, v);
      const auto hit =
          index.find(wanted, [&](std::uint32_t side) { return same(side, shape, k, v); });
      AOMD_CHECK(hit.valid());
      row[k] = hit.id();
      bits |= unsigned{hit.forward() == wanted.forward} << k;
    }
    if (with_directions) result.set_directions(id, static_cast<std::uint16_t>(bits));
  });
}

// What is asked of a hit where equal keys are equal sides: nothing more.
constexpr auto no_second_look = [](std::uint32_t, const ShapeTemplate&, int, const std::uint32_t*) {
  return true;
};

void match_edges(const Mesh& mesh, const VertexRows& rows, bool with_directions, DownRows& result) {
  const SideIndex<EdgeKey> index = index_edges(mesh, VertexRows(mesh, 1));
  const auto key = [](const ShapeTemplate& shape, int k, const std::uint32_t* v) {
    const auto& ends = shape.edges[static_cast<std::size_t>(k)].vertices;
    return EdgeKey(v[ends[0]], v[ends[1]]);
  };
  for_shape(rows, [&](auto shape_of) {
    match(rows, 1, index, shape_of, key, no_second_look, with_directions, result);
  });
}

void match_faces(const Mesh& mesh, const VertexRows& rows, DownRows& result) {
  const VertexRows faces(mesh, 2);
  const SideIndex<FaceKey> index = index_faces(mesh, faces);
  if (all_triangles(faces) && rows.uniform()) {
    const auto key = [](const ShapeTemplate& shape, int k, const std::uint32_t* v) {
      const auto& corners = shape.faces[static_cast<std::size_t>(k)].vertices;
      return FaceKey(v[corners[0]], v[corners[1]], v[corners[2]]);
    };
    return for_shape(rows, [&](auto shape_of) {
      match(rows, 2, index, shape_of, key, no_second_look, true, result);
    });
  }
  const auto key = [](const ShapeTemplate& shape, int k, const std::uint32_t* v) {
    return FaceKey(SideVertices(shape.sub(2, k), v).span());
  };
  const auto same = [&](std::uint32_t face, const ShapeTemplate& shape, int k,
                        const std::uint32_t* v) {
    return same_set(faces.vertices(face), SideVertices(shape.sub(2, k), v).span());
  };
  for_shape(rows, [&](auto shape_of) { match(rows, 2, index, shape_of, key, same, true, result); });
}

// Calls visit(value, id) for every value of every row. Rows of 2, 3, 4 and 6 values are unrolled;
// the pointer moves on in a register, since what visit writes might be any number that is read from
// memory.
template <typename Visit>
void each_entry(const Mesh& mesh, int i, int j, const std::uint32_t* row, std::size_t stride,
                Visit visit) {
  const IdPool& ids = mesh.ids(j);
  const std::uint32_t n = ids.capacity();
  const auto unrolled = [&]<int N>(std::integral_constant<int, N>) {
    for (std::uint32_t id = 0; id < n; ++id, row += stride)
      for (int k = 0; k < N; ++k) visit(row[k], id);
  };
  const ShapeTemplate* uniform = ids.free_ids().empty() ? mesh.uniform_shape(j) : nullptr;
  switch (uniform ? uniform->count(i) : 0) {
    case 2:
      return unrolled(std::integral_constant<int, 2>());
    case 3:
      return unrolled(std::integral_constant<int, 3>());
    case 4:
      return unrolled(std::integral_constant<int, 4>());
    case 6:
      return unrolled(std::integral_constant<int, 6>());
    default:
      break;
  }
  for (std::uint32_t id = ids.next_alive(0); id < n; id = ids.next_alive(id + 1))
    for (int k = 0; k < shape_template(mesh.shape(EntityRef(j, id))).count(i); ++k)
      visit(row[id * stride + static_cast<std::size_t>(k)], id);
}

// Count, prefix sum, fill.
void fill_upward(const Mesh& mesh, int i, int j, const std::uint32_t* rows, std::size_t stride,
                 UpRows& result) {
  std::vector<std::uint32_t> places(mesh.capacity(i), 0);
  std::uint32_t* const at = places.data();
  each_entry(mesh, i, j, rows, stride, [at](std::uint32_t lower, std::uint32_t) { ++at[lower]; });
  std::uint32_t* const pool = result.allocate(places);
  each_entry(mesh, i, j, rows, stride,
             [at, pool](std::uint32_t lower, std::uint32_t id) { pool[at[lower]++] = id; });
}

}  // namespace

VertexRows::VertexRows(const Mesh& mesh, int dim)
    : mesh_(mesh), dim_(dim), uniform_(mesh.uniform_shape(dim)) {
  const DownRows* rows = &mesh.representation().down(dim, 0);
  if (!rows->stored()) {
    made_.allocate(
        mesh.capacity(dim),
        static_cast<std::uint32_t>(uniform_ ? uniform_->vertex_count : max_shape_vertices), false);
    VertexBuffer buffer;
    each([&](std::uint32_t id, const std::uint32_t*) {
      const auto v = mesh.vertices_of(EntityRef(dim, id), buffer);
      std::copy(v.begin(), v.end(), made_.row(id));
    });
    rows = &made_;
  }
  data_ = rows->row(0);
  stride_ = rows->stride();
}

bool same_set(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b) {
  return a.size() == b.size() && std::all_of(a.begin(), a.end(), [&](std::uint32_t v) {
           return std::find(b.begin(), b.end(), v) != b.end();
         });
}

SideIndex<EdgeKey> index_edges(const Mesh& mesh, const VertexRows& edges) {
  return SideIndex<EdgeKey>(mesh.capacity(0), mesh.count(1), [&](auto&& visit) {
    edges.each([&](std::uint32_t id, const std::uint32_t* v) { visit(id, EdgeKey(v[0], v[1])); });
  });
}

SideIndex<FaceKey> index_faces(const Mesh& mesh, const VertexRows& faces) {
  const bool triangles = all_triangles(faces);
  return SideIndex<FaceKey>(mesh.capacity(0), mesh.count(2), [&](auto&& visit) {
    faces.each([&](std::uint32_t id, const std::uint32_t* v) {
      visit(id, triangles ? FaceKey(v[0], v[1], v[2]) : FaceKey(faces.vertices(id)));
    });
  });
}

void build_upward(const Mesh& mesh, int i, int j, UpRows& result) {
  if (i == 0) {
    const VertexRows rows(mesh, j);
    fill_upward(mesh, i, j, rows.row(0), rows.stride(), result);
  } else {
    const DownRows& rows = mesh.representation().down(j, i);
    fill_upward(mesh, i, j, rows.row(0), rows.stride(), result);
  }
}

void build_sides(const Mesh& mesh, int i, int j, DownRows& result) {
  const VertexRows rows(mesh, i);
  const bool every_place = !has_holes(mesh, i) && rows.uniform();
  result.allocate(mesh.capacity(i), widest(rows, j), j == i - 1, !every_place);
  if (j == 1)
    match_edges(mesh, rows, i == 2, result);
  else
    match_faces(mesh, rows, result);
}

namespace {

// Finds the edges that a level lacks. Linear: the sides at each vertex are told apart by marks, not
// by searching.
class EdgeMaker {
 public:
  explicit EdgeMaker(const Mesh& mesh)
      : mesh_(mesh), edges_(mesh, 1), faces_(mesh, 2), regions_(mesh, 3) {
    AOMD_CHECK(mesh.capacity(0) < std::uint32_t{1} << 31);
    AOMD_CHECK(mesh.capacity(1) + std::uint64_t{face_stride_} * mesh.capacity(2) +
                   std::uint64_t{region_stride_} * mesh.capacity(3) <
               no_index);
    std::uint32_t* const begin = begin_.data();
    each_side([begin](std::uint32_t a, std::uint32_t b, std::uint32_t) {
      ++begin[std::min(a, b) + std::size_t{2}];
    });
    for (std::size_t v = 2; v < begin_.size(); ++v) begin[v] += begin[v - 1];
    sides_.resize(begin_.back());
    Side* const sides = sides_.data();
    each_side([begin, sides](std::uint32_t a, std::uint32_t b, std::uint32_t place) {
      const std::uint32_t high = std::max(a, b);
      sides[begin[std::min(a, b) + std::size_t{1}]++] = {high & ~(1u << 31), a < b, place};
    });
  }

  MissingEntities run(DownRows* sides_of_faces) {
    std::uint32_t* const rows = sides_of_faces ? allocate(*sides_of_faces) : nullptr;
    missing_.vertices.reserve(sides_.size());
    missing_.classes.reserve(sides_.size() / 2 + 16);
    std::vector<Seen> seen(mesh_.capacity(0));
    for (std::uint32_t low = 0; low < mesh_.capacity(0); ++low)
      for (std::uint32_t at = begin_[low]; at < begin_[low + std::size_t{1}]; ++at) {
        const Side& side = sides_[at];
        Seen& mark = seen[side.high];
        if (mark.low != low) mark = {low, number_of(side, low) << 1 | side.forward};
        if (rows && side.place - first_face_ < first_region_ - first_face_)
          rows[side.place - first_face_] = mark.edge ^ side.forward ^ 1u;
      }
    if (rows) part_directions(*sides_of_faces);
    missing_.shapes.assign(missing_.classes.size(), Shape::Line);
    return std::move(missing_);
  }

 private:
  // An edge, or one of a face or of a region.
  struct Side {
    std::uint32_t high : 31;    // the larger of its vertices
    std::uint32_t forward : 1;  // from the smaller one
    std::uint32_t place;  // an edge, behind these in the rows of faces, behind these of regions
  };
  // The last edge seen that has a vertex as the larger one.
  struct Seen {
    std::uint32_t low = no_index;  // its other vertex
    std::uint32_t edge = 0;        // twice, and one more where it is forward
  };

  template <typename Visit>
  void each_side(Visit visit) const {
    edges_.each([&](std::uint32_t id, const std::uint32_t* v) { visit(v[0], v[1], id); });
    if (all_triangles(faces_))
      each_side_of_triangles(visit);
    else
      each_side_of(faces_, first_face_, face_stride_, visit);
    each_side_of(regions_, first_region_, region_stride_, visit);
  }

  template <typename Visit>
  void each_side_of(const VertexRows& rows, std::uint32_t first, std::uint32_t stride,
                    Visit visit) const {
    rows.each([&](std::uint32_t id, const std::uint32_t* v) {
      const ShapeTemplate& shape = rows.shape(id);
      std::uint32_t place = first + id * stride;
      for (int k = 0; k < shape.edge_count; ++k, ++place) {
        const auto& ends = shape.edges[static_cast<std::size_t>(k)].vertices;
        visit(v[ends[0]], v[ends[1]], place);
      }
    });
  }

  // The same, with what the template says read once.
  template <typename Visit>
  void each_side_of_triangles(Visit visit) const {
    std::array<std::uint8_t, 6> at{};
    for (std::size_t k = 0; k < 3; ++k)
      std::copy_n(faces_.uniform()->edges[k].vertices.begin(), 2, at.begin() + 2 * k);
    faces_.each([&](std::uint32_t id, const std::uint32_t* v) {
      const std::uint32_t place = first_face_ + id * 3;
      visit(v[at[0]], v[at[1]], place);
      visit(v[at[2]], v[at[3]], place + 1);
      visit(v[at[4]], v[at[5]], place + 2);
    });
  }

  // The edge that a side is; one that is not listed is made as its first user has it.
  std::uint32_t number_of(const Side& side, std::uint32_t low) {
    if (side.place < first_face_) return side.place;
    const std::uint32_t high = side.high;
    missing_.vertices.push_back(side.forward ? low : high);
    missing_.vertices.push_back(side.forward ? high : low);
    missing_.classes.push_back(
        side.place < first_region_
            ? mesh_.classification(Face((side.place - first_face_) / face_stride_))
            : mesh_.classification(Region((side.place - first_region_) / region_stride_)));
    return first_face_ + static_cast<std::uint32_t>(missing_.classes.size()) - 1;
  }

  std::uint32_t* allocate(DownRows& rows) const {
    const bool every_place = !has_holes(mesh_, 2) && faces_.uniform();
    rows.allocate(mesh_.capacity(2), face_stride_, true, !every_place);
    return rows.row(0);
  }

  // From edges in which the lowest bit says whether they are used in their own direction.
  void part_directions(DownRows& rows) const {
    std::uint32_t* const out = rows.row(0);
    for_shape(faces_, [&, stride = face_stride_](auto shape_of) {
      faces_.each([&](std::uint32_t id, const std::uint32_t*) {
        std::uint32_t* const row = out + std::size_t{id} * stride;
        const int sides = shape_of(id).edge_count;
        unsigned bits = 0;
        for (int k = 0; k < sides; ++k) {
          bits |= (row[k] & 1u) << k;
          row[k] >>= 1;
        }
        rows.set_directions(id, static_cast<std::uint16_t>(bits));
      });
    });
  }

  const Mesh& mesh_;
  VertexRows edges_, faces_, regions_;
  std::uint32_t face_stride_ = widest(faces_, 1), region_stride_ = widest(regions_, 1);
  std::uint32_t first_face_ = mesh_.capacity(1),
                first_region_ = first_face_ + face_stride_ * mesh_.capacity(2);
  std::vector<std::uint32_t> begin_ =
      std::vector<std::uint32_t>(mesh_.capacity(0) + std::size_t{2});
  RawVector<Side> sides_;  ///< by their smaller vertices, of each in the order of places
  MissingEntities missing_;
};

}  // namespace

MissingEntities missing_edges(const Mesh& mesh, DownRows* sides_of_faces) {
  return EdgeMaker(mesh).run(sides_of_faces);
}

// Chains by smallest vertex, since the faces to be found are being made.
MissingEntities missing_faces(const Mesh& mesh) {
  struct Known {
    FaceKey::Tag tag;
    std::uint32_t begin, next;
  };
  const VertexRows faces(mesh, 2), regions(mesh, 3);
  MissingEntities missing;
  std::vector<std::uint32_t> first(mesh.capacity(0), no_index);
  std::vector<Known> known;
  std::vector<std::uint32_t> corners;
  known.reserve(mesh.count(2) + std::size_t{2} * mesh.count(3) + 64);
  const auto add = [&](const FaceKey& key, std::span<const std::uint32_t> v) {
    known.push_back({key.tag, static_cast<std::uint32_t>(corners.size()), first[key.low]});
    first[key.low] = static_cast<std::uint32_t>(known.size() - 1);
    corners.insert(corners.end(), v.begin(), v.end());
  };
  faces.each([&](std::uint32_t id, const std::uint32_t*) {
    add(FaceKey(faces.vertices(id)), faces.vertices(id));
  });
  const std::size_t listed = corners.size();
  regions.each([&](std::uint32_t id, const std::uint32_t* v) {
    const ShapeTemplate& shape = regions.shape(id);
    for (int k = 0; k < shape.face_count; ++k) {
      const SubEntity& sub = shape.faces[static_cast<std::size_t>(k)];
      const SideVertices side(sub, v);
      const FaceKey key(side.span());
      std::uint32_t at = first[key.low];
      while (at != no_index) {
        const std::uint32_t next_begin = at + 1 < known.size()
                                             ? known[at + 1].begin
                                             : static_cast<std::uint32_t>(corners.size());
        const std::span own(corners.data() + known[at].begin, next_begin - known[at].begin);
        if (known[at].tag == key.tag && same_set(own, side.span())) break;
        at = known[at].next;
      }
      if (at != no_index) continue;
      add(key, side.span());
      missing.shapes.push_back(sub.shape);
      missing.classes.push_back(mesh.classification(Region(id)));
    }
  });
  missing.vertices.assign(corners.begin() + static_cast<std::ptrdiff_t>(listed), corners.end());
  return missing;
}

}  // namespace aomd
