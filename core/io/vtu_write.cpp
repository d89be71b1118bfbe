// VTU: text, or appended raw bytes, which every reader of the format takes.

#include <algorithm>

#include "core/io/byte_writer.h"
#include "core/io/formats.h"
#include "core/io/stored_numbers.h"
#include "core/io/vtk_dataset.h"
#include "core/io/vtk_numbers.h"
#include "core/io/vtk_pieces.h"

namespace aomd::io::detail {
namespace {

void put_escaped(ByteWriter& out, std::string_view text) {
  for (const char c : text) {
    if (c == '&' || c == '<' || c == '>' || c == '"' || static_cast<unsigned char>(c) < 0x20) {
      out << "&#" << static_cast<int>(static_cast<unsigned char>(c)) << ';';
    } else {
      out << c;
    }
  }
}

/// The first array of each meaning that VTK knows is the active one, and so is the one that says
/// which elements of the whole a piece has.
void put_actives(ByteWriter& out, const std::vector<VtkArray>& list) {
  const auto put = [&](std::string_view word, std::string_view name) {
    out << ' ' << word << "=\"";
    put_escaped(out, name);
    out << '"';
  };
  for (const auto& [word, meaning] : vtu_actives) {
    const auto found = std::find_if(list.begin(), list.end(),
                                    [m = meaning](const VtkArray& a) { return a.meaning == m; });
    if (found != list.end()) put(word, found->name);
  }
  for (const std::string_view name : {point_ids_name, cell_ids_name})
    if (find_array(list, name)) put("GlobalIds", name);
}

class VtuWriter {
 public:
  explicit VtuWriter(bool binary) : binary_(binary) {}

  std::string write(const VtkDataset& grid) {
    out_.reserve(48 * (grid.points.size() + grid.types.size()));
    out_ << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
            "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n";
    if (!grid.field_data.empty()) arrays("FieldData", grid.field_data, true);
    out_ << "<Piece NumberOfPoints=\"" << grid.points.size() << "\" NumberOfCells=\""
         << grid.types.size() << "\">\n";
    arrays("PointData", grid.point_data, false);
    arrays("CellData", grid.cell_data, false);
    points(grid);
    cells(grid);
    out_ << "</Piece>\n</UnstructuredGrid>\n";
    if (binary_)
      out_ << "<AppendedData encoding=\"raw\">\n_" << appended_.take() << "\n</AppendedData>\n";
    out_ << "</VTKFile>\n";
    return out_.take();
  }

 private:
  void points(const VtkDataset& grid) {
    out_ << "<Points>\n";
    begin("Float64", "Points", 3, 0);
    size(24 * grid.points.size());
    for (const glm::dvec3& p : grid.points) {
      for (int axis = 0; axis < 3; ++axis) value(p[axis], axis == 2);
    }
    end();
    out_ << "</Points>\n";
  }

  void cells(const VtkDataset& grid) {
    out_ << "<Cells>\n";
    column("Int64", "connectivity", grid.connectivity);
    column("Int64", "offsets", grid.ends);
    column("UInt8", "types", grid.types);
    out_ << "</Cells>\n";
  }

  template <class Value>
  void column(std::string_view type, std::string_view name, const std::vector<Value>& values) {
    constexpr std::size_t per_line = 16;
    begin(type, name, 0, 0);
    size(sizeof(Value) * values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
      value(values[i], i % per_line == per_line - 1 || i + 1 == values.size());
    end();
  }

  void arrays(std::string_view element, const std::vector<VtkArray>& list, bool of_field) {
    out_ << '<' << element;
    if (!of_field) put_actives(out_, list);
    out_ << ">\n";
    for (const VtkArray& array : list) {
      const NumberType type = stored_type(array);
      const auto n = static_cast<std::size_t>(array.components);
      begin(xml_name(type), array.name, n, of_field ? array.values.size() / n : 0);
      size(size_of(type) * array.values.size());
      for_each_value(array, type, [&](auto x, bool last) { value(x, last); });
      end();
    }
    out_ << "</" << element << ">\n";
  }

  /// `components` and `tuples` are left out where they are 0.
  void begin(std::string_view type, std::string_view name, std::size_t components,
             std::size_t tuples) {
    out_ << "<DataArray type=\"" << type << "\" Name=\"";
    escaped(name);
    if (components != 0) out_ << "\" NumberOfComponents=\"" << components;
    if (tuples != 0) out_ << "\" NumberOfTuples=\"" << tuples;
    if (binary_) {
      out_ << "\" format=\"appended\" offset=\"" << appended_.size() << "\"/>\n";
    } else {
      out_ << "\" format=\"ascii\">\n";
    }
  }
  void size(std::size_t bytes) {
    if (binary_) appended_.raw<std::endian::little>(static_cast<std::uint64_t>(bytes));
  }
  template <class Value>
  void value(Value v, bool last) {
    if (binary_) {
      appended_.raw<std::endian::little>(v);
    } else if constexpr (sizeof(Value) == 1) {
      out_ << int{v} << (last ? '\n' : ' ');
    } else {
      out_ << v << (last ? '\n' : ' ');
    }
  }
  void end() {
    if (!binary_) out_ << "</DataArray>\n";
  }

  void escaped(std::string_view text) { put_escaped(out_, text); }

  bool binary_;
  ByteWriter out_, appended_;
};

/// What a list of pieces says of their arrays.
void put_parallel(ByteWriter& out, std::string_view element, const std::vector<VtkArray>& list) {
  out << '<' << element;
  put_actives(out, list);
  out << ">\n";
  for (const VtkArray& array : list) {
    out << "<PDataArray type=\"" << xml_name(stored_type(array)) << "\" Name=\"";
    put_escaped(out, array.name);
    out << "\" NumberOfComponents=\"" << array.components << "\"/>\n";
  }
  out << "</" << element << ">\n";
}

std::string pvtu_of(const VtkDataset& piece, const std::vector<EncodedMesh::Beside>& files) {
  ByteWriter out;
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" "
         "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
         "<PUnstructuredGrid GhostLevel=\"0\">\n";
  put_parallel(out, "PPointData", piece.point_data);
  put_parallel(out, "PCellData", piece.cell_data);
  out << "<PPoints>\n<PDataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"/>\n"
         "</PPoints>\n";
  for (const EncodedMesh::Beside& file : files) {
    out << "<Piece Source=\"";
    put_escaped(out, file.name);
    out << "\"/>\n";
  }
  out << "</PUnstructuredGrid>\n</VTKFile>\n";
  return out.take();
}

}  // namespace

void write_pvtu(const std::filesystem::path& path, const MeshData& mesh, bool binary,
                std::size_t pieces, EncodedMesh& encoded) {
  std::vector<VtkDataset> grids = cut_grid(grid_of(mesh), pieces);
  for (std::size_t i = 0; i < grids.size(); ++i) {
    encoded.beside.push_back(
        {piece_beside(path, i).filename().string(), VtuWriter(binary).write(grids[i])});
    if (i > 0) grids[i] = {};
  }
  encoded.bytes = pvtu_of(grids[0], encoded.beside);
}

std::string write_vtu(const MeshData& mesh, bool binary) {
  return VtuWriter(binary).write(grid_of(mesh));
}

}  // namespace aomd::io::detail
