// Decimation of a mesh at once: what `aomd decimate` does between reading and writing.

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "core/decimate/spacing/spacing.h"
#include "tools/aomd/attribute_weights.h"
#include "tools/aomd/keep_file.h"
#include "tools/python/arrays.h"
#include "tools/python/listening.h"
#include "tools/python/told_options.h"

namespace aomd::python {
namespace {

std::vector<std::string> with_meshes(const std::vector<std::string>& words) {
  std::vector<std::string> all = words;
  all.emplace_back("mesh");
  all.emplace_back("result");
  std::reverse(all.begin(), all.end());  // CLI11 takes them from the end
  return all;
}

py::dict described(const CLI::Option& option) {
  py::dict entry;
  entry["name"] = option.get_lnames().front();
  entry["flag"] = option.get_items_expected_max() == 0;
  entry["value"] = option.get_type_name();
  entry["default"] = option.get_default_str();
  entry["group"] = option.get_group();
  entry["help"] = option.get_description();
  return entry;
}

py::list option_table() {
  CLI::App app;
  cli::DecimateOptions options;
  cli::add_decimate_options(app, options);
  py::list table;
  for (const CLI::Option* option : app.get_options())
    if (!option->get_lnames().empty() && option->get_lnames().front() != "help")
      table.append(described(*option));
  return table;
}

py::tuple decimated(const MeshData& mesh, const std::vector<std::string>& words,
                    const py::object& keep, const py::object& spacing, py::object progress) {
  const ToldOptions told(words, keep, spacing, mesh.positions.size());
  Listening listening(std::move(progress));
  cli::Decimated result;
  {
    const py::gil_scoped_release unlocked;
    result = cli::decimate(told.options(), mesh, listening.listener());
  }
  if (!keep.is_none()) result.report["options"]["keep"] = "array";
  if (!spacing.is_none()) result.report["options"]["spacing"] = "array";
  if (!spacing.is_none()) result.report["options"]["factor"] = nullptr;
  return py::make_tuple(std::make_shared<MeshData>(std::move(result.mesh)), result.report.dump(),
                        listening.notes(), result.missed);
}

}  // namespace

ToldOptions::ToldOptions(const std::vector<std::string>& words, const py::object& keep,
                         const py::object& spacing, std::size_t vertices) {
  cli::add_decimate_options(app_, options_);
  try {
    app_.parse(with_meshes(words));
  } catch (const CLI::ParseError& e) {
    const std::string text = e.what();
    throw cli::UsageError(text.substr(0, text.find('\n')));
  }
  take_keep(keep, vertices);
  take_spacing(spacing, vertices);
}

void ToldOptions::take_keep(const py::object& keep, std::size_t vertices) {
  if (keep.is_none()) return;
  const auto ids = py::array_t<std::int64_t, py::array::forcecast>(py::array::ensure(keep));
  Column<Vertex, std::uint8_t> stays(vertices, 0);
  for (py::ssize_t i = 0; i < ids.size(); ++i) {
    const std::int64_t id = ids.data()[i];
    if (id < 0 || static_cast<std::size_t>(id) >= vertices)
      throw cli::UsageError("--keep: there is no vertex " + std::to_string(id) + ": the mesh has " +
                            std::to_string(vertices) + ", counted from 0");
    stays[Vertex(static_cast<std::uint32_t>(id))] = 1;
  }
  options_.decimation.keep = std::make_shared<const Column<Vertex, std::uint8_t>>(std::move(stays));
}

void ToldOptions::take_spacing(const py::object& spacing, std::size_t vertices) {
  if (spacing.is_none()) return;
  if (options_.factor_given)
    throw cli::UsageError("--factor excludes --spacing, unless that is surface");
  if (options_.decimation.coarsest) throw cli::UsageError("--spacing excludes --coarsest");
  const auto lengths = py::array_t<double, py::array::forcecast>(py::array::ensure(spacing));
  if (static_cast<std::size_t>(lengths.size()) != vertices)
    throw cli::UsageError("--spacing: " + std::to_string(lengths.size()) + " lengths for " +
                          std::to_string(vertices) + " vertices");
  auto wanted = std::make_shared<Column<Vertex, double>>(vertices);
  for (std::size_t i = 0; i < vertices; ++i) {
    const double length = lengths.data()[i];
    if (!(length > 0))
      throw cli::UsageError("--spacing: vertex " + std::to_string(i) + " has no positive length");
    (*wanted)[Vertex(static_cast<std::uint32_t>(i))] = length;
  }
  options_.decimation.spacing = std::move(wanted);
}

DecimationOptions ToldOptions::for_mesh(const Mesh& mesh, double diagonal) const {
  DecimationOptions steps = options_.for_library();
  const bool volume = mesh.count(3) > 0;
  steps.target_faces = options_.target_count(volume, mesh.count(volume ? 3 : 2));
  steps.max_distance = options_.max_distance_pct / 100 * diagonal;
  if (!options_.keep.empty()) steps.keep = cli::read_keep_file(options_.keep, mesh);
  if (!options_.only.empty()) steps.keep = cli::read_only_file(options_.only, mesh, steps.keep);
  if (!volume && !options_.paper()) {
    const MeshData data = to_data(mesh);
    steps.values = counted_values(data, mesh, cli::attribute_weights(data, options_.attributes));
  }
  options_.check_spacing();
  if (const auto source = options_.spacing_source())
    steps.spacing = std::make_shared<Column<Vertex, double>>(evaluate_spacing(mesh, *source));
  return steps;
}

void add_decimation(py::module_& module) {
  module.def("decimate", &decimated);
  module.def("decimate_options", &option_table);
}

}  // namespace aomd::python
