#pragma once
// The mesh as plain data, with what its file brought and a Mesh does not hold.

#include <string>
#include <vector>

#include "viewer/document/document.h"

namespace aomd::scene {

/// A state of a document's mesh, and what of the file's data does not belong to it.
struct WholeData {
  MeshData data;
  std::vector<std::string> notes;  ///< a line each
};

/// The present mesh. Nothing may run. O(size log size) where operations have changed it.
[[nodiscard]] WholeData whole_data(Document& document);
/// The mesh as loaded; document.can_look_back() must be true. O(size).
[[nodiscard]] MeshData whole_as_loaded(Document& document);
/// Another state, which was made of the mesh as loaded.
[[nodiscard]] WholeData whole_data_of(Document& document, MeshData state);

}  // namespace aomd::scene
