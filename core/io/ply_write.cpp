#include <limits>

#include "core/io/byte_writer.h"
#include "core/io/formats.h"

namespace aomd::io::detail {
namespace {

/// Writes values one after the other, as text or binary.
class PlyWriter {
 public:
  PlyWriter(const MeshData& mesh, bool binary)
      : mesh_(mesh),
        binary_(binary),
        // In text the digits themselves are exact, so that "double" costs nothing.
        doubles_(!binary || !fits_float(mesh)),
        wide_(mesh.positions.size() >
              static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {}

  std::string write() {
    out_.reserve(32 * (mesh_.positions.size() + mesh_.faces.size()));
    header();
    vertices();
    for_each_entity(mesh_.faces, [&](auto corners, ModelRef m) {
      value(static_cast<std::uint8_t>(corners.size()));
      for (const std::uint32_t v : corners) value(v);
      end_element(!mesh_.faces.classes.empty(), m);
    });
    for_each_entity(mesh_.edges, [&](auto ends, ModelRef m) {
      for (const std::uint32_t v : ends) value(v);
      end_element(!mesh_.edges.classes.empty(), m);
    });
    return out_.take();
  }

 private:
  void header() {
    const std::string_view index = wide_ ? "uint" : "int", real = doubles_ ? "double" : "float";
    out_ << "ply\nformat " << (binary_ ? "binary_little_endian" : "ascii")
         << " 1.0\ncomment AOMD Studio\n";
    out_ << "element vertex " << mesh_.positions.size() << '\n';
    for (const char axis : {'x', 'y', 'z'}) out_ << "property " << real << ' ' << axis << '\n';
    class_properties(!mesh_.vertex_classes.empty());
    out_ << "element face " << mesh_.faces.size() << "\nproperty list uchar " << index
         << " vertex_indices\n";
    class_properties(!mesh_.faces.classes.empty());
    if (!mesh_.edges.empty()) {
      out_ << "element edge " << mesh_.edges.size() << '\n';
      for (const char end : {'1', '2'}) out_ << "property " << index << " vertex" << end << '\n';
      class_properties(!mesh_.edges.classes.empty());
    }
    out_ << "end_header\n";
  }

  void class_properties(bool classified) {
    if (classified) out_ << "property uchar model_dimension\nproperty int model_tag\n";
  }

  void vertices() {
    const bool classified = !mesh_.vertex_classes.empty();
    for (std::size_t i = 0; i < mesh_.positions.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis) coordinate(mesh_.positions[i][axis]);
      end_element(classified, classified ? mesh_.vertex_classes[i] : ModelRef());
    }
  }

  void coordinate(double x) {
    if (doubles_) {
      value(x);
    } else {
      value(static_cast<float>(x));
    }
  }

  void end_element(bool classified, ModelRef m) {
    if (classified) {
      value(static_cast<std::uint8_t>(m.dimension()));
      value(m.tag());
    }
    if (!binary_) out_ << '\n';
    first_ = true;
  }

  template <class Value>
  void value(Value v) {
    if (binary_) {
      out_.raw<std::endian::little>(v);
      return;
    }
    if (!first_) out_ << ' ';
    first_ = false;
    if constexpr (sizeof(Value) == 1) {
      out_ << static_cast<int>(v);
    } else {
      out_ << v;
    }
  }

  const MeshData& mesh_;
  bool binary_, doubles_, wide_;
  bool first_ = true;
  ByteWriter out_;
};

}  // namespace

std::string write_ply(const MeshData& mesh, bool binary) { return PlyWriter(mesh, binary).write(); }

}  // namespace aomd::io::detail
