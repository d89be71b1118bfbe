// aomd convert: from one format to another.

#include <memory>
#include <utility>

#include "core/base/text.h"
#include "tools/aomd/batch.h"
#include "tools/aomd/command.h"
#include "tools/aomd/decimate_input.h"
#include "tools/aomd/outputs.h"
#include "tools/aomd/report.h"
#include "tools/aomd/values.h"

namespace aomd::cli {
namespace {

struct ConvertArguments {
  std::string input, output, format;
  std::size_t pieces = 1;
  bool ascii = false, binary = false, msh2 = false, split_to_tets = false, json = false,
       in_one_line = false;
};

Json counted_json(const std::string& file, const MeshData& mesh) {
  return counts_json(file, measure::count_entities(Mesh(mesh)));
}

int run(const ConvertArguments& options) {
  const io::Format format = format_of_output(options.output, options.format);
  std::vector<NamedFile> inputs = named_pieces(options.input),
                         outputs = piece_files(options.output, format, options.pieces);
  inputs.push_back({"IN", options.input});
  outputs.push_back({"OUT", options.output});
  check_files(inputs, outputs);
  io::ReadResult read = read_mesh(options.input);
  const Json before = options.json ? counted_json(options.input, read.mesh) : Json();
  if (options.split_to_tets) print_notes(options.input, cut_regions(read.mesh));
  io::WriteOptions how;
  if (options.ascii || options.binary) how.binary = options.binary;
  how.msh2 = options.msh2;
  how.pieces = options.pieces;
  write_mesh(options.output, format, read.mesh, false, how);
  if (options.json)
    stream_beside(outputs) << text_of(
        {{"schema", 1}, {"input", before}, {"output", counted_json(options.output, read.mesh)}},
        options.in_one_line);
  return done;
}

}  // namespace

void add_convert(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("convert", "Writes a mesh in the format that OUT's extension names");
  const auto options = std::make_shared<ConvertArguments>();
  const auto batch = std::make_shared<Batch>();
  command->add_option("IN", batch->input, "The mesh; - is standard input")
      ->required()
      ->check(not_empty());
  command
      ->add_option(
          "OUT", batch->output,
          "Where to write it: .obj, .ply, .off, .stl, .gltf, .glb; with regions .msh, .mesh, .vtk, "
          ".vtu, .pvtu or .su2; - is "
          "standard output")
      ->required()
      ->check(not_empty());
  add_folder(*command, *batch);
  add_format(*command, batch->format);
  add_pieces(*command, options->pieces);
  CLI::Option* ascii =
      command->add_flag("--ascii", options->ascii, "As text, where the format has both");
  command->add_flag("--binary", options->binary, "As binary, where the format has both")
      ->excludes(ascii);
  command->add_flag("--msh2", options->msh2, "MSH version 2.2 instead of 4.1");
  command->add_flag("--split-to-tets", options->split_to_tets,
                    "Cuts hexahedra, prisms and pyramids into tetrahedra, and quads beside them");
  command->add_flag("--json", batch->json,
                    "Prints what was read and written as JSON; of several meshes a line each");
  command->callback([&action, options, batch] {
    action = writing(batch, [options, batch](const BatchFile& file) {
      return run(for_file(*options, *batch, file));
    });
  });
}

}  // namespace aomd::cli
