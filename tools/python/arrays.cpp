#include "tools/python/arrays.h"

#include <cmath>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/base/text.h"
#include "core/mesh/names.h"

namespace aomd::python {
namespace {

/// Hands over all numbers of an array, row by row, where it holds T in whatever order; false where
/// it does not.
template <typename T, typename Take>
bool taken_as(const py::array& array, const Take& take) {
  if (!py::isinstance<py::array_t<T>>(array)) return false;
  const bool rows_alone = array.ndim() < 2;
  const auto* const first = static_cast<const char*>(array.data());
  const py::ssize_t columns = rows_alone ? 1 : array.shape(1);
  const py::ssize_t across = rows_alone ? 0 : array.strides(1);
  for (py::ssize_t row = 0; row < array.shape(0); ++row)
    for (py::ssize_t column = 0; column < columns; ++column) {
      T number;
      std::memcpy(&number, first + row * array.strides(0) + column * across, sizeof number);
      take(number);
    }
  return true;
}

/// The same for any array of one or two dimensions. The usual types are not converted first, which
/// would be a copy of all of it.
template <typename Take>
void take_whole(const py::array& array, const Take& take) {
  const auto whole = [&](auto number) { take(static_cast<std::int64_t>(number)); };
  if (taken_as<std::uint32_t>(array, whole) || taken_as<std::int32_t>(array, whole) ||
      taken_as<std::int64_t>(array, whole) || taken_as<std::uint64_t>(array, whole))
    return;
  taken_as<std::int64_t>(py::array_t<std::int64_t, py::array::forcecast>(array), take);
}

template <typename Take>
void take_real(const py::array& array, const Take& take) {
  const auto real = [&](auto number) { take(static_cast<double>(number)); };
  if (taken_as<double>(array, real) || taken_as<float>(array, real)) return;
  taken_as<double>(py::array_t<double, py::array::forcecast>(array), take);
}

std::string shape_text(const py::array& array) { return py::str(array.attr("shape")); }

void check_whole(const py::array& array, const std::string& what) {
  const char kind = array.dtype().kind();
  if (kind != 'i' && kind != 'u' && array.size() > 0)
    throw std::invalid_argument(what + ": must be whole numbers, not " +
                                std::string(py::str(array.dtype())));
}

Shape shape_with(int dimension, py::ssize_t corners, const std::string& what) {
  for (std::size_t s = 0; s < builtin_shapes; ++s) {
    const ShapeTemplate& shape = shape_template(static_cast<Shape>(s));
    if (shape.dimension == dimension && shape.vertex_count == corners) return static_cast<Shape>(s);
  }
  throw std::invalid_argument(what + ": none has " + std::to_string(corners) + " vertices");
}

void append(EntityList& list, const py::array& array, int dimension, std::size_t vertices) {
  const std::string what = entity_plural(dimension);
  if (array.ndim() != 2)
    throw std::invalid_argument(what + ": must have the shape (n, vertices of each), not " +
                                shape_text(array));
  const Shape shape = shape_with(dimension, array.shape(1), what);
  check_whole(array, what);
  const auto rows = static_cast<std::size_t>(array.shape(0));
  const auto columns = static_cast<std::size_t>(array.shape(1));
  list.shapes.insert(list.shapes.end(), rows, shape);
  list.vertices.reserve(list.vertices.size() + rows * columns);
  std::size_t count = 0;
  take_whole(array, [&](std::int64_t vertex) {
    if (vertex < 0 || static_cast<std::size_t>(vertex) >= vertices)
      throw std::invalid_argument(what + ": row " + std::to_string(count / columns) +
                                  " names vertex " + std::to_string(vertex) + " of " +
                                  std::to_string(vertices));
    list.vertices.push_back(static_cast<std::uint32_t>(vertex));
    ++count;
  });
}

bool is_list(const py::object& arrays) {
  if (!py::isinstance<py::list>(arrays) && !py::isinstance<py::tuple>(arrays)) return false;
  const auto items = py::reinterpret_borrow<py::sequence>(arrays);
  return !items.empty() && py::isinstance<py::array>(items[0]);
}

ModelRef class_of(std::int64_t dimension, std::int64_t tag, std::size_t row) {
  if (dimension == -1) return {};
  if (dimension < 0 || dimension > 3 || tag < ModelRef::min_tag || tag > ModelRef::max_tag)
    throw std::invalid_argument("classes: row " + std::to_string(row) + " is no model entity: " +
                                std::to_string(dimension) + ", " + std::to_string(tag));
  return {static_cast<int>(dimension), static_cast<std::int32_t>(tag)};
}

}  // namespace

std::vector<glm::dvec3> positions_from(const py::array& array) {
  if (array.ndim() != 2 || array.shape(1) != 3)
    throw std::invalid_argument("vertices: must have the shape (n, 3), not " + shape_text(array));
  std::vector<glm::dvec3> positions(static_cast<std::size_t>(array.shape(0)));
  std::size_t count = 0;
  take_real(array, [&](double coordinate) {
    if (!std::isfinite(coordinate))
      throw std::invalid_argument("vertices: vertex " + std::to_string(count / 3) +
                                  " is not finite");
    positions[count / 3][static_cast<int>(count % 3)] = coordinate;
    ++count;
  });
  return positions;
}

EntityList entities_from(const py::object& arrays, int dimension, std::size_t vertices) {
  EntityList list;
  if (arrays.is_none()) return list;
  if (!is_list(arrays)) {
    append(list, py::array::ensure(arrays), dimension, vertices);
    return list;
  }
  for (const py::handle each : arrays) append(list, py::array::ensure(each), dimension, vertices);
  return list;
}

std::vector<ModelRef> classes_from(const py::array& array, int dimension, std::size_t count) {
  const bool pairs = array.ndim() == 2 && array.shape(1) == 2;
  if ((!pairs && array.ndim() != 1) || static_cast<std::size_t>(array.shape(0)) != count)
    throw std::invalid_argument("classes of " + std::string(entity_plural(dimension)) +
                                ": must have the shape (" + std::to_string(count) + ",) or (" +
                                std::to_string(count) + ", 2), not " + shape_text(array));
  check_whole(array, "classes");
  std::vector<ModelRef> classes;
  classes.reserve(count);
  std::optional<std::int64_t> first;  // of a pair
  take_whole(array, [&](std::int64_t number) {
    if (pairs && !first) {
      first = number;
      return;
    }
    classes.push_back(class_of(first.value_or(dimension), number, classes.size()));
    first.reset();
  });
  return classes;
}

py::array classes_to(const std::vector<ModelRef>& classes) {
  std::vector<std::int32_t> values;
  values.reserve(2 * classes.size());
  for (const ModelRef each : classes) {
    values.push_back(each.valid() ? each.dimension() : -1);
    values.push_back(each.valid() ? each.tag() : 0);
  }
  return owned(std::move(values), 2);
}

Attribute attribute_from(const std::string& name, const py::array& values, int dimension,
                         std::size_t count) {
  const char kind = values.dtype().kind();
  if (values.ndim() < 1 || values.ndim() > 2 ||
      static_cast<std::size_t>(values.shape(0)) != count ||
      (kind != 'f' && kind != 'i' && kind != 'u'))
    throw std::invalid_argument(shown(name) + ": must be numbers of the shape (" +
                                std::to_string(count) + ",) or (" + std::to_string(count) +
                                ", k), not " + shape_text(values));
  Attribute attribute;
  attribute.name = name;
  attribute.dimension = dimension;
  attribute.components = values.ndim() == 2 ? static_cast<int>(values.shape(1)) : 1;
  attribute.integer = kind != 'f';
  attribute.values.reserve(static_cast<std::size_t>(values.size()));
  take_real(values, [&](double number) { attribute.values.push_back(number); });
  return attribute;
}

int dimension_of(const std::string& kind) {
  for (int dim = 0; dim < 4; ++dim)
    if (kind == entity_plural(dim)) return dim;
  throw std::invalid_argument("must be vertices, edges, faces or regions, not " + shown(kind));
}

}  // namespace aomd::python
