// aomd repair: mends what is safe to mend in a dirty surface.

#include <iostream>
#include <memory>

#include "core/base/text.h"
#include "tools/aomd/batch.h"
#include "tools/aomd/command.h"
#include "tools/aomd/outputs.h"
#include "tools/aomd/repair_items.h"
#include "tools/aomd/values.h"
#include "tools/aomd/weld_option.h"

namespace aomd::cli {
namespace {

struct RepairArguments {
  std::string input, output, format;
  RepairOptions repair;
  WeldOption weld;
  bool json = false, in_one_line = false, quiet = false;
};

void print(std::ostream& out, const std::string& file, const std::vector<RepairItem>& items) {
  for (const RepairItem& item : items) out << printable(file) << ": " << line_of(item) << '\n';
}

/// What welding and removing have left behind is told: other files may count on the numbers.
void tell_unused(const MeshData& mesh, RepairReport& report) {
  std::vector<std::uint8_t> used(mesh.positions.size(), 0);
  for (const EntityList* list : {&mesh.edges, &mesh.faces})
    for (const std::uint32_t v : list->vertices) used[v] = 1;
  RepairItem item{"unused vertices", "", 0, 0, {}};
  for (std::uint32_t v = 0; v < used.size(); ++v)
    if (!used[v] && ++item.count <= 8) item.first.push_back(v);
  if (item.count == 0) return;
  item.text = counted(item.count, "vertex") + " that nothing uses left: --drop-unused drops " +
              (item.count == 1 ? "it" : "them");
  report.left.push_back(std::move(item));
}

int run(RepairArguments& options) {
  const io::Format format = format_of_output(options.output, options.format);
  const std::vector<NamedFile> outputs = {{"OUT", options.output}};
  check_files({{"IN", options.input}}, outputs);
  Stopwatch watch;
  io::ReadResult read = read_mesh(options.input, options.quiet || options.json);
  check_mendable(options.input, read.mesh);
  const double reading = watch.lap();
  const measure::Counts before =
      options.json ? measure::count_entities(Mesh(read.mesh)) : measure::Counts();
  watch.lap();
  options.weld.apply(options.repair, read.mesh);
  RepairReport report = repair(read.mesh, options.repair);
  if (!report.done.empty()) tell_unused(read.mesh, report);
  const double repairing = watch.lap();
  write_mesh(options.output, format, read.mesh, options.quiet || options.json);
  std::ostream& out = stream_beside(outputs);
  if (options.json) {
    out << text_of(
        {{"schema", 1},
         {"input", counts_json(options.input, before)},
         {"output", counts_json(options.output, measure::count_entities(Mesh(read.mesh)))},
         {"done", items_json(report.done)},
         {"left", items_json(report.left)},
         {"seconds", {{"read", reading}, {"repair", repairing}}}},
        options.in_one_line);
  } else if (!options.quiet) {
    print(out, options.output, report.done);
    print(out, options.output, report.left);
    if (report.done.empty()) out << printable(options.output) << ": nothing to mend\n";
  }
  return done;
}

void add_switches(CLI::App& command, RepairOptions& repair) {
  command.add_flag("!--no-repeated-vertices", repair.repeated_vertices,
                   "Keeps faces that name a vertex twice");
  command.add_flag("!--no-repeated-faces", repair.repeated_faces,
                   "Keeps all of the faces on the same vertices");
  command.add_flag("!--no-opposite-faces", repair.opposite_faces,
                   "Keeps pairs of faces that lie on each other, back to back");
  command.add_flag("!--no-orient", repair.orient, "Keeps the directions of the faces");
  command.add_flag("!--no-split", repair.split,
                   "Keeps edges of three or more faces and vertices of several fans");
  command.add_flag("!--no-zero-area", repair.zero_area, "Keeps triangles without area");
  command
      .add_option("--min-piece", repair.min_piece_pct,
                  "Removes pieces smaller than this, percent of the diagonal")
      ->type_name("PCT")
      ->transform(percent())
      ->check(between(0, 100));
  command.add_flag("--drop-unused", repair.drop_unused, "Drops vertices that nothing uses");
}

}  // namespace

void add_repair(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "repair", "Mends what is safe to mend in a dirty surface, and says what it did");
  const auto options = std::make_shared<RepairArguments>();
  const auto batch = std::make_shared<Batch>();
  command->add_option("IN", batch->input, "The mesh; - is standard input")
      ->required()
      ->check(not_empty());
  command->add_option("OUT", batch->output, "Where to write it; - is standard output")
      ->required()
      ->check(not_empty());
  add_folder(*command, *batch);
  add_format(*command, batch->format);
  add_weld(*command, options->weld);
  add_switches(*command, options->repair);
  command->add_flag("--json", batch->json,
                    "Prints what was done as JSON; of several meshes a line each");
  command->add_flag("--quiet", options->quiet, "Prints nothing but errors");
  command->callback([&action, options, batch] {
    action = writing(batch, [options, batch](const BatchFile& file) {
      RepairArguments one = for_file(*options, *batch, file);
      return run(one);
    });
  });
}

}  // namespace aomd::cli
