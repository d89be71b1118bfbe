#include "tools/aomd/given_mesh.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "tools/aomd/block_input.h"
#include "tools/aomd/command.h"

namespace aomd::cli {

GivenMesh::Notes GivenMesh::read(Exchange& exchange, Progress& progress) {
  from_file_ = true;
  if (options_.blocks > 1) return read_blocks(exchange, progress);
  progress.show("reading");
  io::ReadResult read = read_input(options_.input);
  progress.wipe();
  own_ = std::move(read.mesh);
  return std::move(read.notes);
}

// What is coarser already stands for the file.
GivenMesh::Notes GivenMesh::read_blocks(Exchange& exchange, Progress& progress) {
  CoarseSurface input = *read_in_blocks(options_, exchange, progress);
  progress.wipe();
  in_blocks_ = InBlocks{input.vertices, input.faces};
  samples_ = std::move(input.samples);
  own_ = std::move(input.mesh);
  return notes_of(input);
}

MeshData& GivenMesh::own() {
  if (mesh_ != &own_) own_ = *mesh_;
  mesh_ = &own_;
  return own_;
}

// They are asked for where data go with them, and where something is to be blamed on the input.
void GivenMesh::forget_regions() {
  if (options_.reach || options_.triangulate || options_.split_to_tets) return;
  if (!can_be_read_again() || data_need_regions() || !mesh().periodic.empty()) return;
  own_.regions.vertices = std::vector<std::uint32_t>();
  forgotten_ = true;
}

bool GivenMesh::can_be_read_again() const {
  return from_file_ && options_.input != "-" && std::filesystem::is_regular_file(options_.input);
}

// What Medit says of vertices, edges and faces is followed without the regions, or not at all.
bool GivenMesh::data_need_regions() const {
  return std::any_of(mesh().attributes.begin(), mesh().attributes.end(), [](const Attribute& a) {
    return a.dimension == 3 || !a.name.starts_with("medit:");
  });
}

MeshData GivenMesh::whole() const { return forgotten_ ? read_input(options_.input).mesh : mesh(); }

void GivenMesh::recall_regions() {
  if (forgotten_) own_ = read_input(options_.input).mesh;
  forgotten_ = false;
}

}  // namespace aomd::cli
