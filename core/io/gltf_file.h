#pragma once
// The parts of a glTF file: its JSON, the bytes of its buffers and its pictures.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <tiny_gltf.h>

#include "core/io/notes.h"
#include "core/io/source.h"
#include "core/mesh/appearance.h"

namespace aomd::io::detail {

/// A .gltf or .glb in memory. tinygltf makes its model of the JSON alone: buffers and pictures are
/// taken here, each once, whatever the file says how often or how large they are.
class GltfFile {
 public:
  /// Throws ReadError for what is no glTF 2.0, and for buffers that are missing or too short.
  explicit GltfFile(const Source& source);

  [[nodiscard]] const Source& source() const { return source_; }
  [[nodiscard]] const tinygltf::Model& model() const { return model_; }
  /// The bytes of a view. Throws ReadError where the view, its buffer or its range are not there.
  [[nodiscard]] std::string_view view(int index) const;
  /// Bytes of the file and of all others that it names.
  [[nodiscard]] std::uint64_t size() const { return size_; }
  /// In the order of the file; one whose view is damaged has neither name nor bytes.
  [[nodiscard]] std::vector<Picture> pictures() const;
  /// Its materials, as they stand in its JSON.
  [[nodiscard]] const std::string& materials() const { return materials_; }
  /// What the file holds besides meshes and materials.
  [[nodiscard]] const ItemList& left_out() const { return left_out_; }

 private:
  struct Image {
    std::string name, uri;
    int view = -1;
  };

  std::string_view split_container();
  void read_json(std::string_view text);
  void take_buffer(const std::string* uri, std::uint64_t length);
  [[nodiscard]] std::string_view bytes_of_uri(const std::string& uri);

  const Source& source_;
  std::string_view chunk_;                    ///< the binary one of a .glb
  bool binary_ = false;                       ///< it is a .glb
  std::map<std::string, std::string> files_;  ///< by what names them
  std::vector<std::string_view> buffers_;
  std::vector<Image> images_;
  std::string materials_;
  tinygltf::Model model_;
  ItemList left_out_;
  std::uint64_t size_ = 0;
};

/// The file that a URI of a glTF file names; empty for one that names none beside it.
[[nodiscard]] std::string file_of_uri(std::string_view uri);
/// The reverse.
[[nodiscard]] std::string uri_of_file(std::string_view name);

}  // namespace aomd::io::detail
