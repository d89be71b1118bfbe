#include <map>
#include <type_traits>

#include "core/io/byte_writer.h"
#include "core/io/formats.h"
#include "core/io/held_arrays.h"
#include "core/io/stored_numbers.h"

namespace aomd::io::detail {
namespace {

/// Writes OFF as text or binary, with what the format holds of arrays.
class OffWriter {
 public:
  OffWriter(const MeshData& mesh, bool binary)
      : mesh_(mesh), binary_(binary), arrays_(off_arrays(mesh)) {
    for (const Attribute* a :
         {arrays_.colours, arrays_.texture, arrays_.normals, arrays_.face_colours})
      if (a) types_[a] = stored_type(*a);
  }

  std::string write() {
    out_.reserve(48 * mesh_.positions.size() + 24 * mesh_.faces.size());
    header();
    for (std::size_t v = 0; v < mesh_.positions.size(); ++v) vertex(v);
    std::size_t face = 0;
    for_each_entity(mesh_.faces, [&](auto corners, ModelRef) {
      count(corners.size());
      for (const std::uint32_t v : corners) count(v);
      if (binary_) count(arrays_.face_colours ? components(*arrays_.face_colours) : 0);
      if (arrays_.face_colours) values(*arrays_.face_colours, face);
      end_line();
      ++face;
    });
    return out_.take();
  }

 private:
  static std::size_t components(const Attribute& a) {
    return static_cast<std::size_t>(a.components);
  }

  void header() {
    if (arrays_.texture) out_ << "ST";
    if (arrays_.colours) out_ << 'C';
    if (arrays_.normals) out_ << 'N';
    out_ << (binary_ ? "OFF BINARY\n" : "OFF\n");
    count(mesh_.positions.size());
    count(mesh_.faces.size());
    count(0);
    end_line();
  }

  void vertex(std::size_t v) {
    const glm::dvec3& p = mesh_.positions[v];
    for (int axis = 0; axis < 3; ++axis)
      binary_ ? out_.raw<std::endian::big>(static_cast<float>(p[axis])) : text(p[axis]);
    if (arrays_.normals) values(*arrays_.normals, v);
    if (arrays_.colours) values(*arrays_.colours, v);
    if (arrays_.texture) values(*arrays_.texture, v);
    end_line();
  }

  /// Binary files have floats, and colours there are 0 to 1, of vertices with alpha.
  void values(const Attribute& a, std::size_t i) {
    const bool colour = a.meaning == Meaning::Colour;
    const double full = colour && binary_ ? full_colour(a) : 1;
    const NumberType type = types_.at(&a);
    const std::size_t n = components(a);
    for (std::size_t k = n * i; k < n * (i + 1); ++k)
      if (binary_)
        out_.raw<std::endian::big>(static_cast<float>(a.values[k] / full));
      else
        use_as(type, a.values[k], [&](auto x) { colour ? shade(x) : text(x); });
    if (binary_ && colour && n == 3 && &a == arrays_.colours) out_.raw<std::endian::big>(1.0f);
  }

  /// A real one shows that it is real.
  template <class Number>
  void shade(Number x) {
    ByteWriter digits;
    if constexpr (std::is_floating_point_v<Number>) digits << x;
    const std::string shown = digits.take();
    text(x);
    if (!shown.empty() && shown.find_first_not_of("-0123456789") == std::string::npos) out_ << ".0";
  }
  template <class Number>
  void text(Number x) {
    if (!first_) out_ << ' ';
    first_ = false;
    if constexpr (sizeof(Number) == 1)
      out_ << static_cast<int>(x);
    else
      out_ << x;
  }
  void count(std::size_t n) {
    binary_ ? out_.raw<std::endian::big>(static_cast<std::uint32_t>(n)) : text(n);
  }
  void end_line() {
    if (!binary_) out_ << '\n';
    first_ = true;
  }

  const MeshData& mesh_;
  bool binary_;
  OffColumns arrays_;
  std::map<const Attribute*, NumberType> types_;
  bool first_ = true;
  ByteWriter out_;
};

}  // namespace

std::string write_off(const MeshData& mesh, bool binary) { return OffWriter(mesh, binary).write(); }

}  // namespace aomd::io::detail
