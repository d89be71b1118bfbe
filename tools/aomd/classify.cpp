// aomd classify: classification from feature angles, written to a file.

#include <iostream>
#include <memory>

#include "core/base/text.h"
#include "core/fields/seams.h"
#include "core/io/left_out.h"
#include "core/mesh/verify.h"
#include "core/model/classify.h"
#include "tools/aomd/command.h"
#include "tools/aomd/outputs.h"
#include "tools/aomd/values.h"

namespace aomd::cli {
namespace {

struct ClassifyArguments {
  std::string input, output, format;
  double angle_deg = 20;
  std::string seams = "keep";
  bool replace = false, quiet = false;
};

int run(const ClassifyArguments& options) {
  const io::Format format = format_of_output(options.output, options.format);
  const std::vector<NamedFile> outputs = {{"OUT", options.output}};
  check_files({{"IN", options.input}}, outputs);
  const io::ReadResult read = read_mesh(options.input, options.quiet);
  Mesh mesh(read.mesh);
  ClassifyOptions how;
  how.feature_angle_deg = options.angle_deg;
  how.keep_present = !options.replace;
  if (options.seams == "keep") how.seams = fields::seams_of(read.mesh);
  const ClassifyResult result = classify(mesh, how);
  if (const auto findings = verify(mesh); !findings.empty())
    throw io::ReadError(options.input, {}, "cannot be classified: " + findings.front().text);
  MeshData classified = to_data(mesh);
  const io::CarriedAlong along = io::carry_along(read.mesh, classified);
  if (!options.quiet) print_notes(options.output, along.notes);
  write_mesh(options.output, format, classified, options.quiet);
  if (options.quiet) return done;
  if (read.mesh.classified() && !options.replace)
    print_notes(options.input, {"its own classification was kept; --replace derives all anew"});
  stream_beside(outputs) << printable(options.output) << ": " << result.model_vertices
                         << " model vertices, " << result.model_edges << " model edges, "
                         << result.model_faces
                         << " model faces; sharp edges: " << result.features.sharp << " features, "
                         << result.features.rough << " roughness, " << result.features.steps
                         << " steps of rounds\n";
  return done;
}

}  // namespace

void add_classify(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("classify", "Classifies a mesh by the angles between its faces");
  const auto options = std::make_shared<ClassifyArguments>();
  command->add_option("IN", options->input, "The mesh; - is standard input")
      ->required()
      ->check(not_empty());
  command
      ->add_option("OUT", options->output,
                   "Where to write it; PLY holds all of the classification; - is standard output")
      ->required()
      ->check(not_empty());
  add_format(*command, options->format);
  command
      ->add_option("--angle", options->angle_deg,
                   "Edges whose faces meet at more than this become model edges")
      ->type_name("DEG")
      ->check(angle())
      ->capture_default_str();
  command
      ->add_option("--seams", options->seams,
                   "Whether edges where texture coordinates jump become model edges")
      ->type_name("keep|ignore")
      ->transform(one_of({"keep", "ignore"}))
      ->capture_default_str();
  command->add_flag("--replace", options->replace,
                    "Forgets the classification that the file carries, but for that of regions");
  command->add_flag("--quiet", options->quiet, "Prints nothing but errors");
  command->callback([&action, options] { action = [options] { return run(*options); }; });
}

}  // namespace aomd::cli
