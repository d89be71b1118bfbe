#include "core/io/record_layout.h"

#include <utility>

#include "core/io/notes.h"
#include "core/io/stored_numbers.h"
#include "core/io/vtk_numbers.h"

namespace aomd::io::detail {
namespace {

std::size_t size_of_all(const std::vector<RecordArray>& arrays) {
  std::size_t size = 0;
  for (const RecordArray& array : arrays) size += array.size();
  return size;
}

/// The numbers that stand at one place in each of the records.
std::vector<double> numbers_in(std::string_view records, std::size_t size, std::size_t begin,
                               const RecordArray& array, std::endian order) {
  std::vector<double> values;
  if (size == 0) return values;
  values.reserve(records.size() / size * static_cast<std::size_t>(array.components));
  for (std::size_t at = begin; at < records.size(); at += size)
    decode(records.substr(at, array.size()), array.type, order, values);
  return values;
}

void add_arrays(const std::vector<RecordArray>& arrays, int dimension, std::string_view records,
                std::size_t size, std::size_t begin, std::endian order, MeshData& mesh) {
  for (const RecordArray& array : arrays) {
    Attribute a{array.name, dimension, array.components, false,
                numbers_in(records, size, begin, array, order)};
    store_as(a, array.type);
    a.meaning = array.meaning;
    mesh.attributes.push_back(std::move(a));
    begin += array.size();
  }
}

std::string text_of(const std::vector<RecordArray>& arrays) {
  std::string text;
  for (const RecordArray& a : arrays)
    text += '\n' + a.name + '\n' + std::to_string(static_cast<int>(a.type)) + ' ' +
            std::to_string(a.components) + ' ' + std::to_string(static_cast<int>(a.meaning));
  return text + "\n\n";
}

}  // namespace

std::size_t RecordLayout::vertex_size() const {
  return 3 * size_of(coordinate) + size_of_all(of_vertices);
}

std::size_t RecordLayout::face_size() const { return size_of_all(of_faces); }

MeshData RecordLayout::mesh_of(std::string_view vertices, std::string_view faces,
                               const std::vector<std::array<std::uint32_t, 3>>& corners) const {
  MeshData mesh;
  const RecordArray place{"", coordinate, 3};
  const std::vector<double> x = numbers_in(vertices, vertex_size(), 0, place, order);
  mesh.positions.reserve(x.size() / 3);
  for (std::size_t k = 0; k + 2 < x.size(); k += 3)
    mesh.positions.emplace_back(x[k], x[k + 1], x[k + 2]);
  mesh.faces.shapes.assign(corners.size(), Shape::Triangle);
  mesh.faces.vertices.reserve(3 * corners.size());
  for (const auto& t : corners)
    mesh.faces.vertices.insert(mesh.faces.vertices.end(), t.begin(), t.end());
  add_arrays(of_vertices, 0, vertices, vertex_size(), place.size(), order, mesh);
  add_arrays(of_faces, 2, faces, face_size(), 0, order, mesh);
  std::vector<std::string> unsaid;
  rename_repeated(mesh.attributes, unsaid);
  return mesh;
}

std::string RecordLayout::text() const {
  return std::to_string(static_cast<int>(order == std::endian::big)) + ' ' +
         std::to_string(static_cast<int>(coordinate)) + text_of(of_vertices) + text_of(of_faces);
}

}  // namespace aomd::io::detail
