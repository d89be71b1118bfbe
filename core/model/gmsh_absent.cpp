// Built without Gmsh: CAD files are refused.

#include "core/model/cad_file.h"
#include "core/model/gmsh_model.h"

namespace aomd {
namespace {

[[noreturn]] void refuse(const std::string& path) {
  check_cad_file(path);
  throw ModelError(path +
                   ": built without Gmsh; install libgmsh-dev and build again to read CAD files");
}

}  // namespace

bool has_gmsh() { return false; }
std::unique_ptr<Model> load_gmsh_model(const std::string& path) { refuse(path); }
MeshData mesh_with_gmsh(const std::string& path, const GmshMeshOptions&) { refuse(path); }

}  // namespace aomd
