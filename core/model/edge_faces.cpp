#include "core/model/edge_faces.h"

#include "core/base/assertion.h"

namespace aomd {

EdgeFaces::EdgeFaces(const Mesh& mesh) : pairs_(mesh.capacity(1)) {
  AOMD_CHECK(mesh.capacity(2) < std::uint32_t{1} << 30);
  const DownRows& sides = mesh.representation().down(2, 1);
  Pair* const pairs = pairs_.data();
  mesh.faces().each([&, pairs](Face f) {
    unsigned directions = sides.directions(f.index);
    for (const Edge e : mesh.row<1>(f)) {
      Pair& pair = pairs[e.index];
      const Use use(f, (directions & 1u) != 0);
      directions >>= 1;
      if (!pair.first.valid())
        pair.first = use;
      else if (!pair.second.valid())
        pair.second = use;
      else
        pair.second.go_on(), others_.emplace_back(e, f);
    }
  });
  std::stable_sort(others_.begin(), others_.end(),
                   [](const Other& a, const Other& b) { return a.first < b.first; });
}

}  // namespace aomd
