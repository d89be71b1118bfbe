#pragma once
// CAD files as models, through Gmsh: optional when the program is built and when it runs.

#include <memory>
#include <string>

#include "core/mesh/mesh_data.h"
#include "core/model/model.h"

#pragma GCC visibility push(default)

namespace aomd {

/// Whether the program was built for Gmsh and finds its library. The library is loaded at the first
/// call of any function here, not before: it takes 0.1 s.
[[nodiscard]] bool has_gmsh();

/// True for the extensions that load_gmsh_model takes: .step .stp .brep .iges .igs .geo, in either
/// case.
[[nodiscard]] bool is_cad_file(const std::string& path);

/// Reads a CAD file. Entities have Gmsh's tags, so a mesh that Gmsh writes from the same file is
/// classified on this model. Lengths are those of the file.
///
/// Closest points are found from samples of the parametrisation and refined by Newton's method
/// until they move no more: to rounding on OpenCASCADE's curves and surfaces; the built-in kernel
/// of .geo files differentiates numerically, which leaves about 1e-8 of the distance on its curves,
/// 1e-6 on its curved surfaces. The point itself always lies on the entity to rounding. About 10
/// microseconds each. Faces end at the rectangle of their parameters, not at their border curves.
///
/// Gmsh is one state for the whole program: models and their functions must be used from one thread
/// at a time. It prints nothing. A .geo file is a program: those that start others, read or write
/// files, or end the process are refused.
///
/// Throws ModelError, naming file and line where it can: no such file, no model in it, built
/// without Gmsh.
[[nodiscard]] std::unique_ptr<Model> load_gmsh_model(const std::string& path);

struct GmshMeshOptions {
  double size = 0;    ///< length of edges; 0 leaves it to Gmsh
  int dimension = 2;  ///< 1 curves, 2 surfaces, 3 volumes
};

/// Meshes a CAD file with Gmsh: linear elements, every entity classified. Lists all edges and faces
/// that lie on model edges and faces. Throws ModelError as above and where Gmsh cannot mesh it.
[[nodiscard]] MeshData mesh_with_gmsh(const std::string& path, const GmshMeshOptions& options = {});

}  // namespace aomd

#pragma GCC visibility pop
