#pragma once
// Pictures as arrays: from and to files, and held against each other.

#include "tools/python/binding.h"

namespace aomd::python {

/// An array of shape (height, width, 4) that takes over the pixels.
[[nodiscard]] py::array array_of(io::Image image);

/// Adds what is done with pictures that are there.
void add_images(py::module_& module);

}  // namespace aomd::python
