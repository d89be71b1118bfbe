// aomd replay: makes the operations of a journal again.

#include <iostream>
#include <memory>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/decimate/decimation.h"
#include "core/fields/seams.h"
#include "core/io/journal_file.h"
#include "core/io/left_out.h"
#include "core/mesh/split_tets.h"
#include "core/mesh/verify.h"
#include "core/model/classify.h"
#include "core/repair/repair.h"
#include "core/repair/triangulate.h"
#include "tools/aomd/command.h"
#include "tools/aomd/given_classes.h"
#include "tools/aomd/outputs.h"
#include "tools/aomd/repair_items.h"
#include "tools/aomd/values.h"
#include "tools/aomd/weld_option.h"

namespace aomd::cli {
namespace {

struct ReplayArguments {
  std::string model, journal, output, format;
  std::optional<std::size_t> step;
  bool triangulate = false, split_to_tets = false, repair = false, quiet = false;
  WeldOption weld;  ///< with repair
};

void mend(const ReplayArguments& options, MeshData& mesh) {
  if (options.triangulate) triangulate_quads(mesh);
  if (options.split_to_tets) mesh = split_to_tets(std::move(mesh)).mesh;
  if (!options.repair) return;
  check_mendable(options.model, mesh);
  RepairOptions how;
  options.weld.apply(how, mesh);
  repair(mesh, how);
}

std::size_t last_step(const ReplayArguments& options, const Journal& journal) {
  const std::size_t step = options.step.value_or(journal.size());
  if (step > journal.size())
    throw UsageError("--step " + std::to_string(step) + ": the journal has " +
                     counted(journal.size(), "step"));
  return step;
}

int run(const ReplayArguments& options) {
  const io::Format format = format_of_output(options.output, options.format);
  const std::vector<NamedFile> outputs = {{"OUT", options.output}};
  check_files({{"MODEL", options.model}, {"JOURNAL", options.journal}}, outputs);
  io::JournalFile file = io::read_journal(options.journal);
  const std::size_t step = last_step(options, file.journal);
  io::ReadResult read = read_mesh(options.model, options.quiet);
  mend(options, read.mesh);
  Mesh mesh(read.mesh);
  if (file.seams) file.classify.seams = fields::seams_of(read.mesh);
  classify(mesh, file.classify);
  if (mesh.count(3) > 0 && file.start.counts[2] < mesh.count(2))
    mesh.keep_model_faces_only();  // as volumes are recorded where no model looks at them
  if (file.start.counts[1] < mesh.count(1))
    keep_edges_for_quality(mesh);  // as the strategy quality records it
  io::check_journal(file, options.journal, mesh);
  file.journal.seek(mesh, step);
  if (const auto findings = verify(mesh); !findings.empty())
    throw io::ReadError(options.journal, {},
                        "the journal leads to a broken mesh: " + findings.front().text);
  MeshData result = to_data(mesh);
  GivenClasses(read.mesh).apply(result);
  const io::CarriedAlong along = io::carry_along(read.mesh, result, thread_count(0));
  if (!options.quiet) print_notes(options.output, along.notes);
  write_mesh(options.output, format, result, options.quiet);
  if (!options.quiet)
    stream_beside(outputs) << printable(options.output) << ": " << counted(step, "step") << " of "
                           << file.journal.size() << " replayed, "
                           << (mesh.count(3) > 0 ? counted(mesh.count(3), "region")
                                                 : counted(mesh.count(2), "face"))
                           << '\n';
  return done;
}

}  // namespace

void add_replay(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("replay", "Makes the operations of a journal again");
  const auto options = std::make_shared<ReplayArguments>();
  command
      ->add_option("MODEL", options->model,
                   "The mesh that the journal started from; - is standard input")
      ->required()
      ->check(not_empty());
  command->add_option("JOURNAL", options->journal, "What aomd decimate --journal wrote")
      ->required();
  command->add_option("OUT", options->output, "Where to write the result; - is standard output")
      ->required()
      ->check(not_empty());
  add_format(*command, options->format);
  command->add_option("--step", options->step, "Stops after so many operations")
      ->type_name("N")
      ->transform(whole_number(0, std::uint64_t{1} << 32));
  command->add_flag("--triangulate", options->triangulate,
                    "First cuts quads, as aomd decimate --triangulate did");
  command->add_flag("--split-to-tets", options->split_to_tets,
                    "First cuts regions, as aomd decimate --split-to-tets did");
  CLI::Option* repair = command->add_flag("--repair", options->repair,
                                          "First mends the mesh, as aomd decimate --repair did");
  add_weld(*command, options->weld)->needs(repair);
  command->add_flag("--quiet", options->quiet, "Prints nothing but errors");
  command->callback([&action, options] { action = [options] { return run(*options); }; });
}

}  // namespace aomd::cli
