// aomd classify: classification from feature angles, written to a file.

#include <iostream>
#include <memory>

#include "core/model/classify.h"
#include "tools/aomd/command.h"
#include "tools/aomd/interrupt.h"

namespace aomd::cli {
namespace {

struct Options {
  std::string input, output;
  double angle_deg = 20;
  bool replace = false, quiet = false;
};

int run(const Options& options) {
  static_cast<void>(io::format_for_writing(options.output));
  const io::ReadResult read = read_mesh(options.input, options.quiet);
  Mesh mesh(read.mesh);
  ClassifyOptions how;
  how.feature_angle_deg = options.angle_deg;
  how.keep_present = !options.replace;
  const ClassifyResult result = classify(mesh, how);
  stop_if_interrupted();
  write_mesh(options.output, to_data(mesh), options.quiet);
  if (options.quiet) return done;
  if (read.mesh.classified() && !options.replace)
    print_notes(options.input, {"its own classification was kept; --replace derives all anew"});
  std::cout << options.output << ": " << result.model_vertices << " model vertices, "
            << result.model_edges << " model edges, " << result.model_faces
            << " model faces; sharp edges: " << result.features.sharp << " features, "
            << result.features.rough << " roughness\n";
  return done;
}

}  // namespace

void add_classify(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("classify", "Classifies a mesh by the angles between its faces");
  const auto options = std::make_shared<Options>();
  command->add_option("IN", options->input, "The mesh")->required();
  command
      ->add_option("OUT", options->output, "Where to write it; PLY holds all of the classification")
      ->required();
  command
      ->add_option("--angle", options->angle_deg,
                   "Edges whose faces meet at more than this become model edges")
      ->check(angle_range())
      ->capture_default_str();
  command->add_flag("--replace", options->replace,
                    "Forgets the classification that the file carries");
  command->add_flag("--quiet", options->quiet, "Prints nothing but errors");
  command->callback([&action, options] { action = [options] { return run(*options); }; });
}

}  // namespace aomd::cli
