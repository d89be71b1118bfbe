#pragma once
// What the parts of the Python module share.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>
#include <string>
#include <vector>

#include "core/io/png.h"
#include "core/mesh/mesh_data.h"
#include "tools/aomd/report.h"

namespace aomd::python {

namespace py = pybind11;

/// Python's Mesh. Nothing changes it once it is made, so that arrays may look into it.
using MeshHandle = std::shared_ptr<MeshData>;
using NoLock = py::call_guard<py::gil_scoped_release>;

/// Each adds one part to the module.
void add_errors(py::module_& module);
void add_mesh(py::module_& module);
void add_commands(py::module_& module);
void add_database(py::module_& module);
void add_decimation(py::module_& module);
void add_stepping(py::module_& module);
void add_picture(py::module_& module);

}  // namespace aomd::python
