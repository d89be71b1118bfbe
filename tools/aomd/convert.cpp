// aomd convert: from one format to another.

#include <memory>

#include "tools/aomd/command.h"
#include "tools/aomd/outputs.h"
#include "tools/aomd/values.h"

namespace aomd::cli {
namespace {

struct ConvertArguments {
  std::string input, output, format;
  bool ascii = false, binary = false, msh2 = false;
};

int run(const ConvertArguments& options) {
  const io::Format format = format_of_output(options.output, options.format);
  check_files({{"IN", options.input}}, {{"OUT", options.output}});
  const io::ReadResult read = read_mesh(options.input);
  io::WriteOptions how;
  if (options.ascii || options.binary) how.binary = options.binary;
  how.msh2 = options.msh2;
  write_mesh(options.output, format, read.mesh, false, how);
  return done;
}

}  // namespace

void add_convert(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("convert", "Writes a mesh in the format that OUT's extension names");
  const auto options = std::make_shared<ConvertArguments>();
  command->add_option("IN", options->input, "The mesh; - is standard input")
      ->required()
      ->check(not_empty());
  command
      ->add_option("OUT", options->output,
                   "Where to write it: .obj, .ply, .off, .stl; with regions .msh, .mesh, .vtk, "
                   ".vtu or .su2; - is "
                   "standard output")
      ->required()
      ->check(not_empty());
  add_format(*command, options->format);
  CLI::Option* ascii =
      command->add_flag("--ascii", options->ascii, "As text, where the format has both");
  command->add_flag("--binary", options->binary, "As binary, where the format has both")
      ->excludes(ascii);
  command->add_flag("--msh2", options->msh2, "MSH version 2.2 instead of 4.1");
  command->callback([&action, options] { action = [options] { return run(*options); }; });
}

}  // namespace aomd::cli
