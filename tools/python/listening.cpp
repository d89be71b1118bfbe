#include "tools/python/listening.h"

namespace aomd::python {

void Listening::tell(std::string_view phase, std::optional<double> done) {
  const py::gil_scoped_acquire lock;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (progress_.is_none()) return;
  const py::object answer = progress_(phase, done);
  if (answer.is(py::bool_(false))) throw Cancelled();
}

cli::Listener Listening::listener() {
  return {[this](const std::string& note) { notes_.push_back(note); },
          [this](std::string_view phase, double done) {
            tell(phase, done < 0 ? std::nullopt : std::optional<double>(done));
          }};
}

}  // namespace aomd::python
