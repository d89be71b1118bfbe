// The compiled part of the Python package `aomd`. What people read, and what it is called, is in
// aomd/__init__.py.

#include <new>
#include <string>

#include "core/base/version.h"
#include "core/io/error.h"
#include "core/model/model.h"
#include "tools/aomd/command.h"
#include "tools/python/binding.h"
#include "tools/python/listening.h"
#include "viewer/app/window.h"
#include "viewer/commands/command_error.h"

namespace aomd::python {
namespace {

struct Errors {
  py::object usage, read, write, limit, nothing_to_do, internal, cancelled;
};

/// Lives as long as the interpreter, which needs the types for as long.
Errors& errors() {
  static auto* const all = new Errors;
  return *all;
}

py::object make_error(py::module_& module, const char* name, const py::object& bases, int code) {
  py::dict members;
  members["exit_code"] = code;
  const std::string full = std::string("aomd.") + name;
  auto type = py::reinterpret_steal<py::object>(
      PyErr_NewException(full.c_str(), bases.ptr(), members.ptr()));
  module.attr(name) = type;
  return type;
}

void raise(const py::object& type, const std::exception& e) {
  PyErr_SetString(type.ptr(), e.what());
}

/// The kinds of failure that main.cpp gives exit codes to.
void translate(std::exception_ptr thrown) try {
  if (thrown) std::rethrow_exception(std::move(thrown));
} catch (const io::ReadError& e) {
  raise(errors().read, e);
} catch (const ModelError& e) {
  raise(errors().read, e);
} catch (const io::WriteError& e) {
  raise(errors().write, e);
} catch (const io::LimitError& e) {
  raise(errors().limit, e);
} catch (const app::WindowError& e) {
  raise(errors().limit, e);
} catch (const cli::UsageError& e) {
  raise(errors().usage, e);
} catch (const scene::CommandError& e) {
  raise(errors().usage, e);
} catch (const cli::NothingToDo& e) {
  raise(errors().nothing_to_do, e);
} catch (const cli::InternalFault& e) {
  raise(errors().internal, e);
} catch (const Cancelled& e) {
  raise(errors().cancelled, e);
}

}  // namespace

void add_errors(py::module_& module) {
  const auto exception = py::reinterpret_borrow<py::object>(PyExc_Exception);
  const auto value_error = py::reinterpret_borrow<py::object>(PyExc_ValueError);
  const py::object base = make_error(module, "Error", exception, cli::internal_fault);
  errors().usage =
      make_error(module, "UsageError", py::make_tuple(base, value_error), cli::wrong_usage);
  errors().read = make_error(module, "ReadError", base, cli::bad_input);
  errors().write = make_error(module, "WriteError", base, cli::not_written);
  errors().limit = make_error(module, "LimitError", base, cli::out_of_limits);
  errors().nothing_to_do = make_error(module, "NothingToDo", base, cli::says_no);
  errors().internal = make_error(module, "InternalFault", base, cli::internal_fault);
  errors().cancelled = make_error(module, "Cancelled", base, cli::signalled + 2);
  py::register_exception_translator(&translate);
}

}  // namespace aomd::python

PYBIND11_MODULE(_aomd, module) {
  using namespace aomd::python;
  module.attr("version") =
      py::make_tuple(AOMD_VERSION_MAJOR, AOMD_VERSION_MINOR, AOMD_VERSION_PATCH);
  add_errors(module);
  add_mesh(module);
  add_commands(module);
  add_database(module);
  add_decimation(module);
  add_stepping(module);
  add_picture(module);
}
