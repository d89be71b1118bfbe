// aomd convert: from one format to another.

#include <memory>

#include "tools/aomd/command.h"
#include "tools/aomd/interrupt.h"

namespace aomd::cli {
namespace {

struct Options {
  std::string input, output;
  bool ascii = false, binary = false, msh2 = false;
};

int run(const Options& options) {
  static_cast<void>(
      io::format_for_writing(options.output));  // complain before the work, not after it
  const io::ReadResult read = read_mesh(options.input);
  io::WriteOptions how;
  if (options.ascii || options.binary) how.binary = options.binary;
  how.msh2 = options.msh2;
  stop_if_interrupted();
  write_mesh(options.output, read.mesh, false, how);
  return done;
}

}  // namespace

void add_convert(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("convert", "Writes a mesh in the format that OUT's extension names");
  const auto options = std::make_shared<Options>();
  command->add_option("IN", options->input, "The mesh")->required();
  command
      ->add_option(
          "OUT", options->output,
          "Where to write it: .obj, .ply, .off, .stl; with regions .msh, .mesh, .vtk, .vtu or .su2")
      ->required();
  CLI::Option* ascii =
      command->add_flag("--ascii", options->ascii, "As text, where the format has both");
  command->add_flag("--binary", options->binary, "As binary, where the format has both")
      ->excludes(ascii);
  command->add_flag("--msh2", options->msh2, "MSH version 2.2 instead of 4.1");
  command->callback([&action, options] { action = [options] { return run(*options); }; });
}

}  // namespace aomd::cli
