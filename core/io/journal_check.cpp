// Whether a history fits a mesh, found out on a shadow of it: only ids, vertex lists and how often
// each is used.

#include <bit>
#include <cmath>

#include "core/io/journal_file.h"

namespace aomd::io {
namespace {

struct Record : RecordHead {
  std::span<const std::uint32_t> body;  ///< without the first word

  explicit Record(std::span<const std::uint32_t> words)
      : RecordHead(unpack(words[0])), body(words.subspan(1, length() - 1)) {}
};

bool finite(std::span<const std::uint32_t> words) {
  for (std::size_t i = 0; i < words.size(); i += 2)
    if (!std::isfinite(
            std::bit_cast<double>(std::uint64_t{words[i]} | std::uint64_t{words[i + 1]} << 32)))
      return false;
  return true;
}

bool legal_class(int dim, std::uint32_t bits) {
  const ModelRef model = ModelRef::from_bits(bits);
  return (model.dimension() <= 3 || model == ModelRef()) && model.may_classify(dim);
}

class Shadow {
 public:
  explicit Shadow(const Mesh& mesh) : ids_{mesh.ids(0), mesh.ids(1), mesh.ids(2), mesh.ids(3)} {
    VertexBuffer buffer;
    uses_.assign(mesh.capacity(0), 0);
    for (int dim = 1; dim <= 3; ++dim) {
      for (std::uint32_t id = 0; id < mesh.capacity(dim); ++id)
        if (mesh.alive(EntityRef(dim, id)))
          hold(dim, id, mesh.vertices_of(EntityRef(dim, id), buffer));
    }
  }

  /// Applies one record; false when it does not fit.
  bool apply(const Record& r) {
    if (r.dim > 3) return false;
    switch (r.kind) {
      case RecordKind::Create:
        return create(r);
      case RecordKind::Destroy:
        return destroy(r);
      case RecordKind::Rebind:
        return rebind(r);
      case RecordKind::Move:
        return alive(0, r.body[0]) && finite(r.body.subspan(1));
      case RecordKind::Classify:
        return alive(r.dim, r.body[0]) && legal_class(r.dim, r.body[1]) &&
               legal_class(r.dim, r.body[2]);
    }
    return false;
  }

 private:
  struct Held {
    VertexBuffer vertices;
    std::uint32_t count;
  };

  [[nodiscard]] IdPool& ids(int dim) { return ids_[static_cast<std::size_t>(dim)]; }
  [[nodiscard]] bool alive(int dim, std::uint32_t id) { return ids(dim).alive(id); }
  [[nodiscard]] Held& held(int dim, std::uint32_t id) {
    return held_[static_cast<std::size_t>(dim) - 1][id];
  }

  void hold(int dim, std::uint32_t id, std::span<const std::uint32_t> vertices) {
    auto& list = held_[static_cast<std::size_t>(dim) - 1];
    if (list.size() <= id) list.resize(ids(dim).capacity());
    Held& h = list[id];
    h.count = static_cast<std::uint32_t>(vertices.size());
    std::copy(vertices.begin(), vertices.end(), h.vertices.begin());
    for (const std::uint32_t v : vertices) ++uses_[v];
  }

  [[nodiscard]] static bool shape_fits(const Record& r) {
    if (static_cast<std::size_t>(r.shape) >= shape_count()) return false;
    const ShapeTemplate& shape = shape_template(r.shape);
    return shape.dimension == r.dim && r.count <= max_shape_vertices &&
           r.count == static_cast<std::uint32_t>(r.dim == 0 ? 1 : shape.vertex_count);
  }

  bool create(const Record& r) {
    if (!shape_fits(r) || !legal_class(r.dim, r.body[1])) return false;
    const auto [id, fresh] = ids(r.dim).create();
    if (id != r.body[0] || fresh != r.fresh) return false;
    if (r.dim == 0) {
      if (fresh) uses_.push_back(0);
      return finite(r.body.subspan(2));
    }
    const auto vertices = r.body.subspan(2);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (!alive(0, vertices[i])) return false;
      for (std::size_t j = 0; j < i; ++j)
        if (vertices[i] == vertices[j]) return false;
    }
    hold(r.dim, id, vertices);
    return true;
  }

  bool destroy(const Record& r) {
    const std::uint32_t id = r.body[0];
    if (!shape_fits(r) || !alive(r.dim, id) || !legal_class(r.dim, r.body[1])) return false;
    if (r.dim == 0) {
      if (uses_[id] > 0) return false;
    } else {
      const Held& h = held(r.dim, id);
      const auto listed = r.body.subspan(2);
      if (!std::equal(listed.begin(), listed.end(), h.vertices.begin(),
                      h.vertices.begin() + h.count))
        return false;
      for (const std::uint32_t v : listed) --uses_[v];
    }
    ids(r.dim).destroy(id);
    return true;
  }

  bool rebind(const Record& r) {
    int last_dim = 1;
    for (std::size_t at = 0; at < r.body.size(); at += 4) {
      const std::uint32_t dim = r.body[at] >> 8, slot = r.body[at] & 255u, id = r.body[at + 1];
      const std::uint32_t from = r.body[at + 2], to = r.body[at + 3];
      if (dim < 1 || dim > 3 || static_cast<int>(dim) < last_dim) return false;
      last_dim = static_cast<int>(dim);
      if (!alive(last_dim, id) || !alive(0, to)) return false;
      Held& h = held(last_dim, id);
      if (slot >= h.count || h.vertices[slot] != from) return false;
      h.vertices[slot] = to;
      --uses_[from];
      ++uses_[to];
    }
    return true;
  }

  std::array<IdPool, 4> ids_;
  std::array<std::vector<Held>, 3> held_;  ///< of edges, faces and regions
  std::vector<std::uint32_t> uses_;        ///< of each vertex, by all of them
};

}  // namespace

void check_journal(const JournalFile& file, const std::string& name, const Mesh& mesh) {
  if (file.start != fingerprint(mesh))
    throw ReadError(name, {},
                    "the journal belongs to another mesh, or to another version of this one");
  Shadow shadow(mesh);
  const auto words = file.journal.words();
  for (std::size_t at = 0; at < words.size();) {
    const Record record(words.subspan(at));
    if (!shadow.apply(record))
      throw ReadError(name, {},
                      "the journal's record at word " + std::to_string(at) + " cannot be applied");
    at += 1 + record.body.size();
  }
}

}  // namespace aomd::io
