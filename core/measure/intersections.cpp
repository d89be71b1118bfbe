#include "core/measure/intersections.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <unordered_map>

#include "core/base/parallel.h"
#include "core/io/weld.h"
#include "core/measure/crowded_pairs.h"
#include "core/model/triangle_intersection.h"
#include "core/model/triangle_tree.h"

namespace aomd::measure {

namespace {

constexpr std::size_t nodes_a_piece = 512;
constexpr std::size_t most_named = 8;

// The triangles of all faces that have area, face by face.
struct Pieces {
  std::vector<Triangle> corners;
  std::vector<Face> faces;  ///< of each piece

  void add(const Triangle& t, Face f) {
    corners.push_back(t);
    faces.push_back(f);
  }
};

Pieces pieces_of(const Mesh& mesh) {
  const Triangles all = triangles_of(mesh);
  Pieces pieces;
  pieces.corners.reserve(all.corners.size());
  pieces.faces.reserve(all.corners.size());
  for (std::size_t i = 0; i < all.corners.size(); ++i)
    if (!without_area(all.corners[i])) pieces.add(all.corners[i], all.faces[i]);
  return pieces;
}

// Faces that are the same triangles, taken out so that the first of them stands for all.
class Copies {
 public:
  /// None.
  Copies() = default;
  /// Removes the pieces of all but the first of each set.
  explicit Copies(Pieces& pieces) {
    const std::vector<Keyed> faces = sorted_faces(pieces);
    std::vector<std::uint8_t> keep(pieces.corners.size(), 1);
    for (std::size_t i = 0, j = 0; i < faces.size(); i = j) {
      for (j = i + 1; j < faces.size() && faces[j].key == faces[i].key; ++j)
        for (std::uint32_t p = faces[j].begin; p < faces[j].end; ++p) keep[p] = 0;
      if (j - i < 2) continue;
      auto& set = sets_[pieces.faces[faces[i].begin].index];
      for (std::size_t k = i; k < j; ++k) set.push_back(pieces.faces[faces[k].begin]);
    }
    if (!sets_.empty()) pieces = kept(pieces, keep);
  }

  /// All faces that one stands for, itself first.
  [[nodiscard]] std::vector<Face> of(Face f) const {
    const auto it = sets_.find(f.index);
    return it == sets_.end() ? std::vector<Face>{f} : it->second;
  }
  [[nodiscard]] std::size_t count(Face f) const {
    const auto it = sets_.find(f.index);
    return it == sets_.end() ? 1 : it->second.size();
  }
  /// Calls visit(faces) for each set of two or more.
  template <typename Visit>
  void each_set(Visit&& visit) const {
    for (const auto& [first, set] : sets_) visit(set);
  }

 private:
  struct Keyed {
    std::vector<std::array<std::uint32_t, 3>> key;  ///< the corners of its pieces, all sorted
    std::uint32_t begin, end;                       ///< its pieces
  };

  static std::vector<Keyed> sorted_faces(const Pieces& pieces) {
    io::detail::Welder welder;
    std::vector<Keyed> faces;
    for (std::uint32_t i = 0; i < pieces.corners.size(); ++i) {
      if (i == 0 || pieces.faces[i] != pieces.faces[i - 1]) faces.push_back({{}, i, i});
      std::array<std::uint32_t, 3> points{};
      for (std::size_t k = 0; k < 3; ++k) points[k] = welder.add(pieces.corners[i][k]);
      std::sort(points.begin(), points.end());
      faces.back().key.push_back(points);
      faces.back().end = i + 1;
    }
    for (Keyed& face : faces) std::sort(face.key.begin(), face.key.end());
    std::sort(faces.begin(), faces.end(), [](const Keyed& a, const Keyed& b) {
      return a.key != b.key ? a.key < b.key : a.begin < b.begin;
    });
    return faces;
  }

  static Pieces kept(const Pieces& pieces, const std::vector<std::uint8_t>& keep) {
    Pieces rest;
    for (std::size_t i = 0; i < keep.size(); ++i)
      if (keep[i] != 0) rest.add(pieces.corners[i], pieces.faces[i]);
    return rest;
  }

  std::unordered_map<std::uint32_t, std::vector<Face>> sets_;  ///< by their first
};

// Whether pieces of the same two faces cut each other that come before these two: a pair of quads
// may cut in up to four places.
bool met_before(const Pieces& pieces, std::size_t i, std::size_t j) {
  if (pieces.faces[j] < pieces.faces[i]) std::swap(i, j);
  const auto first_of = [&](std::size_t p) {
    while (p > 0 && pieces.faces[p - 1] == pieces.faces[p]) --p;
    return p;
  };
  for (std::size_t a = first_of(i); a <= i; ++a)
    for (std::size_t b = first_of(j);
         b < pieces.faces.size() && pieces.faces[b] == pieces.faces[j] && (a < i || b < j); ++b)
      if (intersect(pieces.corners[a], pieces.corners[b])) return true;
  return false;
}

// Calls meet(pair) once for every pair of faces that intersect, from several threads in turn.
template <typename Meet>
void each_pair(const Pieces& pieces, bool crowd, int threads, Meet&& meet) {
  std::mutex mutex;
  const auto cut = [&](std::uint32_t i, std::uint32_t j) {
    return pieces.faces[i] != pieces.faces[j] && intersect(pieces.corners[i], pieces.corners[j]);
  };
  const auto tell = [&](std::uint32_t i, std::uint32_t j) {
    if (met_before(pieces, i, j)) return;
    const auto [first, second] = std::minmax(pieces.faces[i], pieces.faces[j]);
    const std::scoped_lock lock(mutex);
    meet(IntersectingPair{first, second});
  };
  if (crowd)
    return crowded_pairs(pieces.corners, threads, [&](std::uint32_t i, std::uint32_t j) {
      if (cut(i, j)) tell(i, j);
    });
  const BoxTree tree = boxes_of(pieces.corners, threads);
  parallel_for(tree.nodes(), threads, nodes_a_piece, [&](std::size_t begin, std::size_t end) {
    tree.touching_pairs(begin, end, [&](std::uint32_t n, std::uint32_t m) {
      const std::uint32_t i = tree.source(n), j = tree.source(m);
      if (cut(i, j)) tell(i, j);
    });
  });
}

// The smallest few of many pairs.
class FirstPairs {
 public:
  void add(const IntersectingPair& pair) {
    pairs_.push_back(pair);
    if (pairs_.size() >= 2 * most_named) cut();
  }
  [[nodiscard]] std::vector<IntersectingPair> take() {
    cut();
    return std::move(pairs_);
  }

 private:
  void cut() {
    std::sort(pairs_.begin(), pairs_.end());
    pairs_.resize(std::min(pairs_.size(), most_named));
  }
  std::vector<IntersectingPair> pairs_;
};

}  // namespace

std::vector<IntersectingPair> self_intersections(const Mesh& mesh, int threads) {
  Pieces pieces = pieces_of(mesh);
  const bool crowd = crowded(pieces.corners);
  const Copies copies = crowd ? Copies(pieces) : Copies();
  std::vector<IntersectingPair> pairs;
  const auto add = [&](Face f, Face g) { pairs.push_back({std::min(f, g), std::max(f, g)}); };
  each_pair(pieces, crowd, threads, [&](const IntersectingPair& pair) {
    for (const Face f : copies.of(pair.first))
      for (const Face g : copies.of(pair.second)) add(f, g);
  });
  copies.each_set([&](const std::vector<Face>& set) {
    for (std::size_t i = 0; i < set.size(); ++i)
      for (std::size_t j = i + 1; j < set.size(); ++j) add(set[i], set[j]);
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

IntersectionCount count_self_intersections(const Mesh& mesh, int threads) {
  Pieces pieces = pieces_of(mesh);
  const bool crowd = crowded(pieces.corners);
  const Copies copies = crowd ? Copies(pieces) : Copies();
  IntersectionCount result;
  FirstPairs first;
  each_pair(pieces, crowd, threads, [&](const IntersectingPair& pair) {
    result.pairs += copies.count(pair.first) * copies.count(pair.second);
    first.add(pair);
  });
  copies.each_set([&](const std::vector<Face>& set) {
    result.pairs += set.size() * (set.size() - 1) / 2;
    first.add({set[0], set[1]});
  });
  result.first = first.take();
  return result;
}

}  // namespace aomd::measure
