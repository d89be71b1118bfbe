// aomd sample: writes a generated mesh.

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "core/samples/samples.h"
#include "tools/aomd/command.h"
#include "tools/aomd/interrupt.h"

namespace aomd::cli {
namespace {

struct Options {
  std::string name, output;
  int size = 0;
  bool list = false;
};

int list_samples() {
  for (const SampleInfo& info : samples())
    std::cout << std::left << std::setw(14) << info.name << info.description
              << " (--size: " << info.size_meaning << "; " << info.default_size << ")\n";
  return done;
}

MeshData make(const Options& options) {
  try {
    return make_sample(options.name, options.size);
  } catch (const std::invalid_argument& e) {
    throw UsageError(e.what());
  }
}

int run(const Options& options) {
  if (options.list) return list_samples();
  if (options.name.empty() || options.output.empty())
    throw UsageError("sample: NAME and OUT are required, or --list");
  static_cast<void>(io::format_for_writing(options.output));
  const MeshData mesh = make(options);
  stop_if_interrupted();
  write_mesh(options.output, mesh);
  return done;
}

}  // namespace

void add_sample(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("sample", "Writes a generated mesh");
  const auto options = std::make_shared<Options>();
  command->add_option("NAME", options->name, "Which one; --list shows them");
  command->add_option("OUT", options->output, "Where to write it");
  command->add_option("--size", options->size, "How fine; what it counts depends on the sample")
      ->check(CLI::PositiveNumber);
  command->add_flag("--list", options->list, "Lists the samples");
  command->callback([&action, options] { action = [options] { return run(*options); }; });
}

}  // namespace aomd::cli
