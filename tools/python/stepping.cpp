// Decimation step by step, and why an edge stays.

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/base/box.h"
#include "core/decimate/decimation.h"
#include "core/decimate/explain/explanation.h"
#include "core/decimate/explain/stop_words.h"
#include "tools/python/held_mesh.h"
#include "tools/python/listening.h"
#include "tools/python/told_options.h"

namespace aomd::python {
namespace {

double diagonal_of_mesh(const Mesh& mesh) {
  Box box;
  for (const Vertex v : mesh.vertices()) box.add(mesh.position(v));
  return box.diagonal();
}

/// A decimation that follows what else is done to its mesh, such as undoing.
class Stepping {
 public:
  Stepping(std::shared_ptr<HeldMesh> held, const std::vector<std::string>& words,
           const py::object& keep, const py::object& spacing)
      : held_(std::move(held)),
        told_(words, keep, spacing, held_->mesh.capacity(0)),
        decimation_(held_->mesh, told_.for_mesh(held_->mesh, diagonal_of_mesh(held_->mesh))),
        seen_(held_->mesh.revision()) {}

  std::optional<std::pair<std::string, std::pair<int, std::uint32_t>>> step() {
    const auto made = present().step();
    seen_ = held_->mesh.revision();
    if (!made) return {};
    return std::pair(std::string(step_name(made->kind)),
                     std::pair(int(made->entity.dimension), made->entity.index));
  }

  std::uint32_t sweep() { return count(&Decimation::sweep); }
  std::uint32_t swap() { return count(&Decimation::swap_pass); }
  std::uint32_t smooth() { return count(&Decimation::smooth_pass); }

  bool run(py::object progress, std::optional<double> seconds) {
    using namespace std::chrono;
    Listening listening(std::move(progress));
    const auto end = steady_clock::now() + duration<double>(seconds.value_or(0));
    Decimation& decimation = present();
    const py::gil_scoped_release unlocked;
    while (decimation.run(milliseconds(50)) == Decimation::Stop::Budget) {
      seen_ = held_->mesh.revision();
      listening.tell(phase_name(decimation.phase()), decimation.progress());
      if (seconds && steady_clock::now() >= end) break;
    }
    seen_ = held_->mesh.revision();
    return decimation.done();
  }

  std::vector<std::string> why(std::uint32_t edge) {
    const Edge e(held_->at(1, edge).index);
    std::vector<std::string> sentences;
    for (const CollapseOutlook& outlook : present().outlook(e))
      sentences.push_back(explain_collapse(held_->mesh, outlook, decimation_.options()));
    return sentences;
  }

  std::optional<std::string> why_swap(std::uint32_t edge) {
    const Edge e(held_->at(1, edge).index);
    const auto outlook = present().swap_outlook(e);
    if (!outlook) return {};
    return explain_swap(held_->mesh, e, *outlook);
  }

  std::optional<std::string> why_move(std::uint32_t vertex) {
    const auto outlook = present().move_outlook(Vertex(held_->at(0, vertex).index));
    if (!outlook) return {};
    return explain_move(held_->mesh, *outlook);
  }

  py::dict judge(std::uint32_t edge) {
    const Edge e(held_->at(1, edge).index);
    Vertex deleted;
    const Verdict verdict = present().judge(e, deleted);
    py::dict result;
    result["accepted"] = verdict.accepted();
    result["reason"] =
        verdict.accepted() ? py::object(py::none()) : py::str(reason_name(verdict.reason));
    result["number"] = verdict.number();
    result["entity"] =
        verdict.entity.valid()
            ? py::object(py::make_tuple(verdict.entity.dimension, verdict.entity.index))
            : py::object(py::none());
    result["deleted"] =
        deleted.valid() ? py::object(py::int_(deleted.index)) : py::object(py::none());
    return result;
  }

  py::dict edges_left() {
    py::dict counts;
    for (const ReasonCount& each : by_number(present().edges_left()))
      counts[reason_name(each.reason)] = each.edges;
    return counts;
  }

  std::string why_stopped() {
    const bool volume = held_->mesh.count(3) > 0;
    return stop_words(present().edges_left(), decimation_.options(),
                      held_->mesh.count(volume ? 3 : 2), volume);
  }

  std::string sweeps() const { return cli::sweeps_json(decimation_.sweeps()).dump(); }
  bool done() { return present().done(); }
  std::string phase() { return phase_name(present().phase()); }
  double progress() { return present().progress(); }

 private:
  /// The mesh may have been changed since.
  Decimation& present() {
    if (held_->mesh.revision() != seen_) decimation_.invalidate();
    seen_ = held_->mesh.revision();
    return decimation_;
  }

  std::uint32_t count(std::uint32_t (Decimation::*pass)()) {
    const std::uint32_t made = (present().*pass)();
    seen_ = held_->mesh.revision();
    return made;
  }

  std::shared_ptr<HeldMesh> held_;
  ToldOptions told_;
  Decimation decimation_;
  std::uint64_t seen_;
};

}  // namespace

void add_stepping(py::module_& module) {
  py::class_<Stepping>(module, "Decimation")
      .def(py::init<std::shared_ptr<HeldMesh>, const std::vector<std::string>&, const py::object&,
                    const py::object&>())
      .def("step", &Stepping::step)
      .def("sweep", &Stepping::sweep, NoLock())
      .def("swap", &Stepping::swap, NoLock())
      .def("smooth", &Stepping::smooth, NoLock())
      .def("run", &Stepping::run)
      .def("why", &Stepping::why)
      .def("why_swap", &Stepping::why_swap)
      .def("why_move", &Stepping::why_move)
      .def("judge", &Stepping::judge)
      .def("edges_left", &Stepping::edges_left)
      .def("why_stopped", &Stepping::why_stopped)
      .def("sweeps", &Stepping::sweeps)
      .def("done", &Stepping::done)
      .def("phase", &Stepping::phase)
      .def("progress", &Stepping::progress);
}

}  // namespace aomd::python
