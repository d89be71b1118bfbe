#pragma once
// Pictures and libraries of materials beside meshes: where they are, and how they get to where
// another mesh is written.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/io.h"

namespace aomd::io::detail {

/// The bytes of a picture: its own, or those of its file; none where that cannot be read.
[[nodiscard]] std::optional<std::string> picture_bytes(const Appearance& looks,
                                                       const Picture& picture);

/// "image/png" or "image/jpeg" by the first bytes; empty for what is neither.
[[nodiscard]] std::string_view picture_type(std::string_view bytes);

/// Files that a mesh names, as they are named from where it is written.
class FilesBeside {
 public:
  /// `mesh` is what is written; what has to be copied goes into the list of `encoded`.
  FilesBeside(const Appearance& looks, std::filesystem::path mesh, EncodedMesh& encoded)
      : looks_(looks), mesh_(std::move(mesh)), encoded_(encoded) {}

  /// The name of a file that lies beside the mesh that was read. It stays where it can be found
  /// under its name from the new place too; else it is copied, under another name where that one
  /// is taken. One that is missing keeps its name: reading has said so.
  [[nodiscard]] std::string name_of(const std::string& file);
  /// That of a picture; bytes become a file.
  [[nodiscard]] std::string name_of(const Picture& picture);
  /// The mesh's own name with another extension; where the mesh is not there yet and such a file
  /// is, that is something else and stays: "a_gltf.bin" instead of "a.bin".
  [[nodiscard]] std::string own_name(std::string_view extension) const;
  /// Adds a file of that name, and returns it.
  std::string add(std::string_view extension, std::string bytes);

 private:
  [[nodiscard]] std::string put(const std::string& name, std::string bytes);

  const Appearance& looks_;
  std::filesystem::path mesh_;
  EncodedMesh& encoded_;
};

}  // namespace aomd::io::detail
