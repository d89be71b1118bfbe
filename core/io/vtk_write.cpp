// Legacy VTK, version 3.0: what every reader of the format takes.

#include <algorithm>
#include <span>

#include "core/io/byte_writer.h"
#include "core/io/formats.h"
#include "core/io/stored_numbers.h"
#include "core/io/vtk_dataset.h"
#include "core/io/vtk_numbers.h"

namespace aomd::io::detail {
namespace {

class LegacyWriter {
 public:
  explicit LegacyWriter(bool binary) : binary_(binary) {}

  std::string write(const VtkDataset& grid) {
    out_.reserve(32 * (grid.points.size() + grid.types.size()));
    out_ << "# vtk DataFile Version 3.0\nAOMD Studio\n" << (binary_ ? "BINARY" : "ASCII");
    out_ << "\nDATASET UNSTRUCTURED_GRID\n";
    if (!grid.field_data.empty()) fields(grid.field_data);
    out_ << "POINTS " << grid.points.size() << " double\n";
    for (const glm::dvec3& p : grid.points) {
      for (int axis = 0; axis < 3; ++axis) value(p[axis], axis == 2);
    }
    end_block();
    cells(grid);
    data("CELL_DATA", grid.types.size(), grid.cell_data);
    data("POINT_DATA", grid.points.size(), grid.point_data);
    return out_.take();
  }

 private:
  template <class Value>
  void value(Value v, bool last) {
    if (binary_) {
      out_.raw<std::endian::big>(v);
    } else if constexpr (sizeof(Value) == 1) {
      out_ << int{v} << (last ? '\n' : ' ');
    } else {
      out_ << v << (last ? '\n' : ' ');
    }
  }
  void end_block() {
    if (binary_) out_ << '\n';
  }

  void cells(const VtkDataset& grid) {
    const std::size_t n = grid.types.size();
    out_ << "CELLS " << n << ' ' << n + grid.connectivity.size() << '\n';
    std::size_t at = 0;
    for (const std::int64_t end : grid.ends) {
      const auto stop = static_cast<std::size_t>(end);
      value(static_cast<std::int32_t>(stop - at), false);
      for (; at < stop; ++at)
        value(static_cast<std::int32_t>(grid.connectivity[at]), at + 1 == stop);
    }
    end_block();
    out_ << "CELL_TYPES " << n << '\n';
    for (const std::uint8_t type : grid.types) value(std::int32_t{type}, true);
    end_block();
  }

  /// What VTK shows first, and what it knows by its meaning, by its keyword; runs of others as
  /// fields.
  void data(std::string_view keyword, std::size_t n, const std::vector<VtkArray>& arrays) {
    if (arrays.empty()) return;
    out_ << keyword << ' ' << n << '\n';
    for (auto from = arrays.begin(); from != arrays.end();) {
      const auto to = std::find_if(from, arrays.end(),
                                   [](const VtkArray& a) { return !keyword_of(a).empty(); });
      if (from != to) fields({from, to});
      if (to != arrays.end()) known(*to);
      from = to == arrays.end() ? to : to + 1;
    }
  }

  /// Empty where the array goes with the fields.
  static std::string_view keyword_of(const VtkArray& a) {
    if (a.meaning == Meaning::Scalars && a.components <= 4) return "SCALARS";
    if (a.meaning == Meaning::Vectors && a.components == 3) return "VECTORS";
    if (a.meaning == Meaning::Normal && a.components == 3) return "NORMALS";
    if (a.meaning == Meaning::Texture && a.components <= 3) return "TEXTURE_COORDINATES";
    if (a.meaning != Meaning::Tensors) return {};
    return a.components == 9 ? "TENSORS" : a.components == 6 ? "TENSORS6" : "";
  }

  void known(const VtkArray& array) {
    const std::string_view keyword = keyword_of(array);
    const NumberType type = stored_type(array);
    out_ << keyword << ' ';
    name(array.name);
    if (array.meaning == Meaning::Texture) out_ << ' ' << array.components;
    out_ << ' ' << legacy_name(type);
    if (array.meaning == Meaning::Scalars) out_ << ' ' << array.components;
    out_ << '\n';
    if (array.meaning == Meaning::Scalars) out_ << "LOOKUP_TABLE default\n";
    for_each_value(array, type, [&](auto x, bool last) { value(x, last); });
    end_block();
  }

  void fields(std::span<const VtkArray> arrays) {
    out_ << "FIELD FieldData " << arrays.size() << '\n';
    for (const VtkArray& array : arrays) {
      const NumberType type = stored_type(array);
      const auto n = static_cast<std::size_t>(array.components);
      name(array.name);
      out_ << ' ' << array.components << ' ' << array.values.size() / n << ' ' << legacy_name(type)
           << '\n';
      for_each_value(array, type, [&](auto x, bool last) { value(x, last); });
      end_block();
    }
  }

  /// Names are one word: what would break that is written as "%20".
  void name(std::string_view text) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    for (const char c : text) {
      const auto byte = static_cast<unsigned char>(c);
      if (byte > 0x20 && byte < 0x7f && c != '%' && c != '"') {
        out_ << c;
      } else {
        out_ << '%' << digits[byte >> 4] << digits[byte & 15u];
      }
    }
  }

  bool binary_;
  ByteWriter out_;
};

}  // namespace

std::string write_vtk(const MeshData& mesh, bool binary) {
  return LegacyWriter(binary).write(grid_of(mesh));
}

}  // namespace aomd::io::detail
