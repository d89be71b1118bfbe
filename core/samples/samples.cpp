#include "core/samples/samples.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "core/samples/makers.h"

namespace aomd {
namespace {

struct Maker {
  SampleInfo info;
  int smallest, largest;
  MeshData (*make)(int size);
};

constexpr std::array<Maker, 18> makers{{
    {{"scan", "a scanned creature: closed, smooth, with the noise of a scanner", 70'000,
      "faces, about"},
     80,
     6'000'000,
     sample::make_scan},
    {{"bracket", "a bent bracket with three holes: planes, fillets and bores, fully classified", 5,
      "cells across the thickness"},
     1,
     40,
     sample::make_bracket},
    {{"plane-hole", "a square with a round hole: every border edge on a model edge", 32,
      "cells along a side"},
     4,
     800,
     sample::make_plane_hole},
    {{"box", "a cube: 8 model vertices, 12 model edges, 6 model faces", 10, "cells along a side"},
     1,
     300,
     sample::make_box},
    {{"cylinder", "a closed cylinder with two circular model edges", 10, "cells along the radius"},
     2,
     300,
     sample::make_cylinder},
    {{"sphere", "a geodesic sphere, unclassified", 16, "cells along an edge of the icosahedron"},
     1,
     400,
     sample::make_sphere},
    {{"globe", "a globe in six charts, with a picture, its seams and colours", 32,
      "cells along a side of a chart"},
     1,
     400,
     sample::make_globe},
    {{"torus", "a smooth ring, unclassified", 80, "cells around the ring"},
     3,
     2000,
     sample::make_torus},
    {{"terrain", "a height field with a border, unclassified", 100, "cells along a side"},
     1,
     1000,
     sample::make_terrain},
    {{"nonmanifold", "three sheets that share an edge, classified", 8, "cells along a side"},
     1,
     500,
     sample::make_nonmanifold},
    {{"tet-box", "a cube of tetrahedra: 8 model vertices, 12 model edges, 6 model faces", 10,
      "cells along a side", 3},
     1,
     64,
     sample::make_tet_box},
    {{"hex-box", "the same cube of hexahedra", 10, "cells along a side", 3},
     1,
     100,
     sample::make_hex_box},
    {{"mixed", "two blocks of hexahedra, prisms, pyramids and tetrahedra, with an interface", 6,
      "cells along a side", 3},
     2,
     50,
     sample::make_mixed},
    {{"tet-drilled", "a box of tetrahedra with a round hole through it, fully classified", 8,
      "cells along a side", 3},
     2,
     64,
     sample::make_tet_drilled},
    {{"tet-ball", "a ball of tetrahedra", 8, "layers of tetrahedra", 3},
     1,
     40,
     sample::make_tet_ball},
    {{"ball-in-box", "two materials of tetrahedra: a ball inside a cube, with their interface", 3,
      "layers of the ball", 3},
     1,
     20,
     sample::make_ball_in_box},
    {{"tet-bracket", "an L-shaped bracket of tetrahedra with a hole, fully classified", 4,
      "cells across the thickness", 3},
     1,
     30,
     sample::make_tet_bracket},
    {{"layered-beam", "a beam of three materials, with a temperature and a stress", 4,
      "cells across the lowest layer", 3},
     1,
     30,
     sample::make_layered_beam},
}};

constexpr auto infos = [] {
  std::array<SampleInfo, makers.size()> list{};
  for (std::size_t i = 0; i < makers.size(); ++i) list[i] = makers[i].info;
  return list;
}();

std::string known_names() {
  std::string names;
  for (const SampleInfo& info : infos)
    names += (names.empty() ? "" : ", ") + std::string(info.name);
  return names;
}

}  // namespace

std::span<const SampleInfo> samples() { return infos; }

MeshData make_sample(std::string_view name, int size) {
  const auto maker = std::find_if(makers.begin(), makers.end(),
                                  [&](const Maker& m) { return m.info.name == name; });
  if (maker == makers.end()) {
    throw std::invalid_argument("no sample \"" + std::string(name) + "\"; there are " +
                                known_names());
  }
  if (size == 0) size = maker->info.default_size;
  if (size < maker->smallest || size > maker->largest) {
    throw std::invalid_argument("size " + std::to_string(size) + " of sample " + std::string(name) +
                                " is outside " + std::to_string(maker->smallest) + ".." +
                                std::to_string(maker->largest) + " (" +
                                std::string(maker->info.size_meaning) + ")");
  }
  return maker->make(size);
}

}  // namespace aomd
