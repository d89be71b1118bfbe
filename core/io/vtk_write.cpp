// Legacy VTK, version 3.0: what every reader of the format takes.

#include "core/io/byte_writer.h"
#include "core/io/formats.h"
#include "core/io/vtk_dataset.h"

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

  void data(std::string_view keyword, std::size_t n, const std::vector<VtkArray>& arrays) {
    if (arrays.empty()) return;
    out_ << keyword << ' ' << n << '\n';
    fields(arrays);
  }

  void fields(const std::vector<VtkArray>& arrays) {
    out_ << "FIELD FieldData " << arrays.size() << '\n';
    for (const VtkArray& array : arrays) {
      const bool narrow = array.integer && fits_int32(array);
      const auto n = static_cast<std::size_t>(array.components);
      name(array.name);
      out_ << ' ' << array.components << ' ' << array.values.size() / n << ' '
           << (!array.integer ? "double"
               : narrow       ? "int"
                              : "vtktypeint64")
           << '\n';
      for_each_value(array, narrow, [&](auto x, bool last) { value(x, last); });
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
