#pragma once
// The generators behind make_sample(), each for a size that its bounds allow.

#include "core/mesh/mesh_data.h"

namespace aomd::sample {

[[nodiscard]] MeshData make_scan(int faces);
[[nodiscard]] MeshData make_bracket(int cells);
[[nodiscard]] MeshData make_plane_hole(int cells);
[[nodiscard]] MeshData make_box(int cells);
[[nodiscard]] MeshData make_cylinder(int rings);
[[nodiscard]] MeshData make_sphere(int frequency);
[[nodiscard]] MeshData make_globe(int cells);
[[nodiscard]] MeshData make_torus(int cells);
[[nodiscard]] MeshData make_terrain(int cells);
[[nodiscard]] MeshData make_nonmanifold(int cells);
[[nodiscard]] MeshData make_tet_box(int cells);
[[nodiscard]] MeshData make_hex_box(int cells);
[[nodiscard]] MeshData make_mixed(int cells);
[[nodiscard]] MeshData make_tet_drilled(int cells);
[[nodiscard]] MeshData make_tet_ball(int layers);
[[nodiscard]] MeshData make_ball_in_box(int layers);
[[nodiscard]] MeshData make_tet_bracket(int n);
[[nodiscard]] MeshData make_layered_beam(int n);

}  // namespace aomd::sample
