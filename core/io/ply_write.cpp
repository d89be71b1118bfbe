#include <array>
#include <limits>

#include "core/io/byte_writer.h"
#include "core/io/formats.h"
#include "core/io/held_arrays.h"
#include "core/io/ply_arrays.h"
#include "core/io/stored_numbers.h"

namespace aomd::io::detail {
namespace {

bool is_ply_remark(const Remark& remark) {
  return remark.keyword == "comment" || remark.keyword == "obj_info";
}

std::string one_line(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  return text;
}

/// Writes values one after the other, as text or binary.
class PlyWriter {
 public:
  PlyWriter(const MeshData& mesh, bool binary, const std::vector<Remark>& remarks)
      : mesh_(mesh),
        remarks_(remarks),
        binary_(binary),
        // In text the digits themselves are exact, so that "double" costs nothing.
        doubles_(!binary || !fits_float(mesh)),
        wide_(mesh.positions.size() >
              static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
    texture_ = ply_texture(mesh);
    if (texture_) texture_type_ = stored_type(*texture_);
    for (int d = 0; d <= 2; ++d) columns_[static_cast<std::size_t>(d)] = columns_of(mesh, d);
  }

  std::string write() {
    out_.reserve(32 * (mesh_.positions.size() + mesh_.faces.size()));
    header();
    vertices();
    element_ = 0;
    for_each_entity(mesh_.faces, [&](auto corners, ModelRef m) {
      value(static_cast<std::uint8_t>(corners.size()));
      for (const std::uint32_t v : corners) value(v);
      if (texture_) texture_of(corners.size());
      end_element(!mesh_.faces.classes.empty(), m, columns_[2]);
    });
    element_ = 0;
    for_each_entity(mesh_.edges, [&](auto ends, ModelRef m) {
      for (const std::uint32_t v : ends) value(v);
      end_element(!mesh_.edges.classes.empty(), m, columns_[1]);
    });
    return out_.take();
  }

 private:
  void header() {
    const std::string_view index = wide_ ? "uint" : "int", real = doubles_ ? "double" : "float";
    out_ << "ply\nformat " << (binary_ ? "binary_little_endian" : "ascii") << " 1.0\ncomment "
         << own_comment << '\n';
    for (const Remark& remark : remarks_)
      if (is_ply_remark(remark)) out_ << remark.keyword << ' ' << one_line(remark.text) << '\n';
    out_ << "element vertex " << mesh_.positions.size() << '\n';
    for (const char axis : {'x', 'y', 'z'}) out_ << "property " << real << ' ' << axis << '\n';
    properties(!mesh_.vertex_classes.empty(), columns_[0]);
    out_ << "element face " << mesh_.faces.size() << "\nproperty list uchar " << index
         << " vertex_indices\n";
    if (texture_) out_ << "property list uchar " << ply_name(texture_type_) << " texcoord\n";
    properties(!mesh_.faces.classes.empty(), columns_[2]);
    if (!mesh_.edges.empty()) {
      out_ << "element edge " << mesh_.edges.size() << '\n';
      for (const char end : {'1', '2'}) out_ << "property " << index << " vertex" << end << '\n';
      properties(!mesh_.edges.classes.empty(), columns_[1]);
    }
    out_ << "end_header\n";
  }

  void properties(bool classified, const std::vector<PlyColumns>& columns) {
    if (classified) out_ << "property uchar model_dimension\nproperty int model_tag\n";
    for (const PlyColumns& each : columns)
      for (const std::string& name : each.names)
        out_ << "property " << ply_name(each.type) << ' ' << name << '\n';
  }

  void vertices() {
    const bool classified = !mesh_.vertex_classes.empty();
    for (std::size_t i = 0; i < mesh_.positions.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis) coordinate(mesh_.positions[i][axis]);
      end_element(classified, classified ? mesh_.vertex_classes[i] : ModelRef(), columns_[0]);
    }
  }

  void coordinate(double x) {
    if (doubles_) {
      value(x);
    } else {
      value(static_cast<float>(x));
    }
  }

  void texture_of(std::size_t corners) {
    value(static_cast<std::uint8_t>(2 * corners));
    for (std::size_t k = 0; k < 2 * corners; ++k)
      use_as(texture_type_, texture_->values[corner_value_++], [this](auto x) { value(x); });
  }

  void end_element(bool classified, ModelRef m, const std::vector<PlyColumns>& columns) {
    if (classified) {
      value(static_cast<std::uint8_t>(m.dimension()));
      value(m.tag());
    }
    for (const PlyColumns& each : columns) {
      const std::size_t n = each.names.size();
      for (std::size_t k = element_ * n; k < (element_ + 1) * n; ++k)
        use_as(each.type, each.array->values[k], [this](auto x) { value(x); });
    }
    ++element_;
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
  const std::vector<Remark>& remarks_;
  bool binary_, doubles_, wide_;
  bool first_ = true;
  std::array<std::vector<PlyColumns>, 3> columns_;  ///< of vertices, edges and faces
  const Attribute* texture_ = nullptr;              ///< on corners
  NumberType texture_type_ = NumberType::Float64;
  std::size_t corner_value_ = 0;  ///< the next one of it
  std::size_t element_ = 0;       ///< the number of the present one
  ByteWriter out_;
};

}  // namespace

std::string write_ply(const MeshData& mesh, bool binary, const std::vector<Remark>& remarks) {
  return PlyWriter(mesh, binary, remarks).write();
}

}  // namespace aomd::io::detail
