#pragma once
// Files of glTF put together by hand.

#include <string>

#include "core/io/base64.h"
#include "tests/support/io_helpers.h"

namespace aomd::test {

template <class... Values>
std::string floats(Values... values) {
  return (raw(static_cast<float>(values)) + ...);
}

/// Puts a file together from its parts of JSON and the bytes of its one buffer.
struct GltfText {
  std::string meshes, accessors, views, bytes;
  std::string nodes = R"([{"mesh":0}])", more;

  [[nodiscard]] std::string str() const {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":)" + nodes +
           R"(,"meshes":)" + meshes + R"(,"accessors":)" + accessors + R"(,"bufferViews":)" +
           views + more + R"(,"buffers":[{"byteLength":)" + std::to_string(bytes.size()) +
           R"(,"uri":"data:application/octet-stream;base64,)" + io::detail::to_base64(bytes) +
           R"("}]})";
  }
};

/// Four points, of which the file makes primitives.
inline GltfText square(const std::string& primitive = R"({"attributes":{"POSITION":0},"mode":5})") {
  GltfText text;
  text.meshes = R"([{"name":"sheet","primitives":[)" + primitive + "]}]";
  text.accessors = R"([{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"}])";
  text.views = R"([{"buffer":0,"byteLength":48}])";
  text.bytes = floats(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0);
  return text;
}

/// Two triangles.
inline MeshData sheet() {
  MeshData mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.faces.add(Shape::Triangle, {0, 1, 2});
  mesh.faces.add(Shape::Triangle, {2, 1, 3});
  return mesh;
}

}  // namespace aomd::test
