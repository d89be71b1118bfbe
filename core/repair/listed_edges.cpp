#include <unordered_map>
#include <unordered_set>

#include "core/repair/stages.h"

namespace aomd::repair_detail {
namespace {

class ListedEdges {
 public:
  ListedEdges(Surface& surface, const std::vector<std::uint32_t>& before, const Weld& weld)
      : surface_(surface), edges_(surface.data().edges), before_(before), weld_(weld) {}

  void follow() {
    find_parts();
    for (std::uint32_t e = 0; e < edges_.size(); ++e)
      if (const auto own = key(e); is_part(e, own)) listed_.insert(own);
    const auto given = static_cast<std::uint32_t>(edges_.size());
    for (std::uint32_t e = 0; e < given; ++e)
      if (!parts_[base(e)].keys.empty() && !is_part(e, key(e))) move(e);
    for (std::uint32_t e = 0; e < given; ++e) {
      Parts& parts = parts_[base(e)];
      for (; parts.free < parts.keys.size(); ++parts.free)
        if (listed_.insert(parts.keys[parts.free]).second) append(e, parts.keys[parts.free]);
    }
  }

 private:
  // What an edge has become, in the order of the faces.
  struct Parts {
    std::vector<std::uint64_t> keys;
    std::unordered_set<std::uint64_t> known;
    std::size_t free = 0;  ///< all before it are listed
  };

  [[nodiscard]] std::uint64_t key(std::uint32_t e) const {
    return edge_key(edges_.vertices[2 * std::size_t{e}], edges_.vertices[2 * std::size_t{e} + 1]);
  }
  // The edge before its faces came apart. Copies do not occur: no list knew them then.
  [[nodiscard]] std::uint64_t base(std::uint32_t e) const { return bases_[e]; }
  [[nodiscard]] bool is_part(std::uint32_t e, std::uint64_t own) {
    return parts_[base(e)].known.contains(own);
  }

  // What each listed edge is now.
  void find_parts() {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      bases_.push_back(
          edge_key(weld_.base(edges_.vertices[2 * e]), weld_.base(edges_.vertices[2 * e + 1])));
      parts_[bases_.back()];
    }
    surface_.each_corner([&](std::uint32_t c) {
      const std::uint32_t n = surface_.next(c);
      const auto it = parts_.find(edge_key(before_[c], before_[n]));
      if (it == parts_.end()) return;
      const std::uint64_t now = edge_key(surface_.vertex(c), surface_.vertex(n));
      if (it->second.known.insert(now).second) it->second.keys.push_back(now);
    });
  }

  // Gives an edge to a part that is not listed yet, if there is one.
  void move(std::uint32_t e) {
    Parts& parts = parts_[base(e)];
    while (parts.free < parts.keys.size() && listed_.contains(parts.keys[parts.free])) ++parts.free;
    const std::uint64_t part =
        parts.free == parts.keys.size() ? parts.keys.front() : parts.keys[parts.free];
    listed_.insert(part);
    std::uint32_t* const ends = &edges_.vertices[2 * std::size_t{e}];
    ends[0] = static_cast<std::uint32_t>(part >> 32);
    ends[1] = static_cast<std::uint32_t>(part);
  }

  void append(std::uint32_t e, std::uint64_t part) {
    edges_.shapes.push_back(Shape::Line);
    edges_.vertices.insert(edges_.vertices.end(), {static_cast<std::uint32_t>(part >> 32),
                                                   static_cast<std::uint32_t>(part)});
    if (!edges_.classes.empty()) edges_.classes.emplace_back(edges_.classes[e]);
    for (Attribute& a : surface_.data().attributes) {
      const auto n = static_cast<std::size_t>(a.components);
      for (std::size_t k = 0; a.dimension == 1 && k < n; ++k)
        a.values.push_back(double{a.values[e * n + k]});
    }
  }

  Surface& surface_;
  EntityList& edges_;
  const std::vector<std::uint32_t>& before_;
  const Weld& weld_;
  std::vector<std::uint64_t> bases_;
  std::unordered_map<std::uint64_t, Parts> parts_;
  std::unordered_set<std::uint64_t> listed_;
};

}  // namespace

void follow_faces(Surface& surface, const std::vector<std::uint32_t>& before, const Weld& weld) {
  if (!surface.data().edges.empty()) ListedEdges(surface, before, weld).follow();
}

}  // namespace aomd::repair_detail
