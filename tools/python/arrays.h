#pragma once
// Arrays of NumPy from and to what a mesh is made of.

#include <cstdint>
#include <string>
#include <vector>

#include "core/mesh/mesh_data.h"
#include "tools/python/binding.h"

namespace aomd::python {

/// An array that looks into `values`, which `owner` keeps alive; nobody can write through it. One
/// dimension, or two where there are columns.
template <typename T>
[[nodiscard]] py::array view(const T* values, std::size_t rows, std::size_t columns,
                             const py::object& owner) {
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(rows)};
  if (columns > 0) shape.push_back(static_cast<py::ssize_t>(columns));
  py::array_t<T> array(shape, values, owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// An array of its own that takes over the values.
template <typename T>
[[nodiscard]] py::array owned(std::vector<T> values, std::size_t columns = 0) {
  auto* const kept = new std::vector<T>(std::move(values));
  const py::capsule owner(kept, [](void* p) { delete static_cast<std::vector<T>*>(p); });
  const std::size_t rows = columns > 0 ? kept->size() / columns : kept->size();
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(rows)};
  if (columns > 0) shape.push_back(static_cast<py::ssize_t>(columns));
  return py::array_t<T>(shape, kept->data(), owner);
}

/// Positions from an array of shape (n, 3). Throws std::invalid_argument for other shapes and for
/// what is not finite.
[[nodiscard]] std::vector<glm::dvec3> positions_from(const py::array& array);

/// Entities of one dimension from an array of shape (n, k), whose k tells the shape, or from a list
/// of such arrays, one after the other. Throws std::invalid_argument for a k that no shape has, for
/// what is not whole, and for vertices that there are not.
[[nodiscard]] EntityList entities_from(const py::object& arrays, int dimension,
                                       std::size_t vertices);

/// Classes from an array of shape (n,), tags of model entities of that dimension, or (n, 2): their
/// dimension and tag, -1 and 0 for none. Throws std::invalid_argument where they cannot be.
[[nodiscard]] std::vector<ModelRef> classes_from(const py::array& array, int dimension,
                                                 std::size_t count);
/// The opposite: shape (n, 2).
[[nodiscard]] py::array classes_to(const std::vector<ModelRef>& classes);

/// One array of attached numbers of shape (n,) or (n, components). Throws std::invalid_argument.
[[nodiscard]] Attribute attribute_from(const std::string& name, const py::array& values,
                                       int dimension, std::size_t count);

/// 0 to 3 for "vertices", "edges", "faces", "regions". Throws std::invalid_argument for others.
[[nodiscard]] int dimension_of(const std::string& kind);

}  // namespace aomd::python
