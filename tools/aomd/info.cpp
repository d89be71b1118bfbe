// aomd info: counts, topology, classification, quality and memory of a file.

#include <iomanip>
#include <iostream>
#include <memory>

#include "core/base/parallel.h"
#include "core/base/text.h"
#include "tools/aomd/batch.h"
#include "tools/aomd/command.h"
#include "tools/aomd/field_report.h"
#include "tools/aomd/in_memory.h"
#include "tools/aomd/report.h"
#include "tools/aomd/surface_lines.h"
#include "tools/aomd/volume_report.h"

namespace aomd::cli {
namespace {

struct InfoArguments {
  std::string file;
  bool json = false, in_one_line = false;
};

template <typename Value>
void row(const char* label, const Value& value) {
  std::cout << "  " << std::left << std::setw(22) << label << std::right << std::setw(12) << value
            << '\n';
}

void print(const std::string& file, const Mesh& mesh, const measure::Counts& counts,
           const measure::Quality& quality) {
  std::cout << printable(file) << '\n' << std::fixed << std::setprecision(2);
  row("vertices", counts.vertices);
  row("  used by nothing", counts.unused_vertices);
  row("edges", counts.edges);
  row("  boundary", counts.boundary_edges);
  row("  non-manifold", counts.nonmanifold_edges);
  row("faces", counts.faces);
  if (counts.regions > 0) {
    row("  boundary", counts.boundary_faces);
    row("  non-manifold", counts.nonmanifold_faces);
    row("regions", counts.regions);
    for (std::size_t s = 0; s < shape_count(); ++s)
      if (const ShapeTemplate& shape = shape_template(static_cast<Shape>(s));
          shape.dimension == 3 && counts.by_shape[s] > 0)
        row(("  " + std::string(shape.name)).c_str(), counts.by_shape[s]);
  }
  row("components", counts.components);
  row("Euler number", counts.euler);
  constexpr const char* on_model[] = {"on model vertices", "on model edges", "on model faces",
                                      "on model regions"};
  for (std::size_t dim = 0; dim < counts.by_class.size(); ++dim)
    if (counts.by_class[dim] > 0) row(on_model[dim], counts.by_class[dim]);
  if (mesh.count(2) > 0) {
    row("smallest angle, mean", quality.min_angle_mean_deg);
    row("smallest angle, worst", quality.min_angle_worst_deg);
    row("% faces below 10 deg", quality.faces_below_10deg_pct);
  }
  row("memory, MB", static_cast<double>(mesh.entity_bytes() + mesh.adjacency_bytes()) / 1e6);
}

void print(const measure::VolumeComplex& complex, const measure::VolumeQuality& quality) {
  row("smallest dihedral", quality.min_dihedral_deg);
  row("  5 % are below", quality.p5_dihedral_deg);
  row("  mean", quality.mean_dihedral_deg);
  row("% regions below 10 deg", quality.regions_below_10deg_pct);
  if (quality.tetrahedra > 0) {
    row("shape of tets, worst", quality.shape_min);
    row("  mean", quality.shape_mean);
  }
  row("inverted regions", quality.inverted.size());
  row("repeated regions", complex.repeated.size());
  row("non-conforming faces", complex.crowded.size());
  row("folded faces", complex.folded.size());
  print_regions(complex);
}

/// What is found out about a mesh, which must outlive it.
struct Facts {
  explicit Facts(const MeshData& mesh_data)
      : data(mesh_data),
        mesh(mesh_data),
        counts(measure::count_entities(mesh)),
        quality(measure::measure_quality(mesh)),
        volume(measure::measure_volume(mesh, thread_count(0))),
        complex(measure::analyse_volume(mesh, thread_count(0))),
        dirt(survey(mesh_data)) {}

  const MeshData& data;
  Mesh mesh;
  measure::Counts counts;
  measure::Quality quality;
  measure::VolumeQuality volume;
  measure::VolumeComplex complex;
  std::vector<SurfaceFinding> dirt;
};

void print(const std::string& file, const Facts& facts) {
  print(file, facts.mesh, facts.counts, facts.quality);
  if (facts.counts.regions > 0) print(facts.complex, facts.volume);
  print_arrays(std::cout, facts.data);
  print_materials(std::cout, facts.data);
  for (const SurfaceFinding& finding : facts.dirt)
    if (finding.breaks != SurfaceProperty::Closed)
      std::cout << "  " << line_of(finding, file) << '\n';
}

Json json_of(const std::string& file, const Facts& facts, double read_seconds,
             const std::vector<std::string>& notes) {
  Json json{{"schema", 1},
            {"input", counts_json(file, facts.counts)},
            {"quality", quality_json(facts.quality)},
            {"seconds", {{"read", read_seconds}}},
            {"memory_bytes",
             {{"mesh", facts.mesh.entity_bytes()},
              {"adjacency", facts.mesh.adjacency_bytes()},
              {"peak", peak_bytes()}}},
            {"surface", surface_json(facts.dirt, file)},
            {"fields", arrays_json(facts.data)},
            {"materials", materials_json(facts.data)},
            {"notes", notes}};
  add_volume_quality(json["quality"], facts.volume);
  if (facts.counts.regions > 0) json["volume"] = volume_json(facts.complex, facts.volume);
  return json;
}

int run(const InfoArguments& options) {
  Stopwatch watch;
  const io::ReadResult read = read_mesh(options.file);
  const double seconds = watch.lap();
  const Facts facts(read.mesh);
  if (options.json)
    std::cout << text_of(json_of(options.file, facts, seconds, read.notes), options.in_one_line);
  else
    print(options.file, facts);
  return done;
}

}  // namespace

Json info(const std::string& name, const MeshData& mesh) {
  return json_of(name, Facts(mesh), 0, {});
}

void add_info(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("info", "Counts, topology, classification, quality and memory of meshes");
  const auto batch = std::make_shared<Batch>();
  add_files(*command, *batch);
  command->add_flag("--json", batch->json, "As JSON; of several meshes a line each");
  command->callback([&action, batch] {
    action = reading(batch, [batch](const BatchFile& file) {
      return run(InfoArguments{file.input, batch->json, file.one_of_several()});
    });
  });
}

}  // namespace aomd::cli
