// aomd sample: writes a generated mesh.

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <limits>
#include <memory>
#include <stdexcept>

#include "core/samples/samples.h"
#include "tools/aomd/command.h"
#include "tools/aomd/outputs.h"
#include "tools/aomd/values.h"

namespace aomd::cli {
namespace {

struct SampleArguments {
  std::string name, output, format;
  int size = 0;
  bool list = false;
};

int list_samples() {
  for (const SampleInfo& info : samples())
    std::cout << std::left << std::setw(14) << info.name << info.description
              << " (--size: " << info.size_meaning << "; " << info.default_size << ")\n";
  return done;
}

MeshData make(const SampleArguments& options) {
  try {
    return make_sample(options.name, options.size);
  } catch (const std::invalid_argument& e) {
    throw UsageError(e.what());
  }
}

int run(const SampleArguments& options) {
  if (options.list) return list_samples();
  if (options.name.empty() || options.output.empty())
    throw UsageError("sample: NAME and OUT are required, or --list");
  const io::Format format = format_of_output(options.output, options.format);
  check_files({}, {{"OUT", options.output}});
  const MeshData mesh = make(options);
  write_mesh(options.output, format, mesh);
  return done;
}

}  // namespace

void add_sample(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("sample", "Writes a generated mesh");
  const auto options = std::make_shared<SampleArguments>();
  command->add_option("NAME", options->name, "Which one; --list shows them");
  command->add_option("OUT", options->output, "Where to write it; - is standard output");
  add_format(*command, options->format);
  command->add_option("--size", options->size, "How fine; what it counts depends on the sample")
      ->type_name("N")
      ->transform(whole_number(1, std::numeric_limits<int>::max()));
  command->add_flag("--list", options->list, "Lists the samples");
  command->callback([&action, options] { action = [options] { return run(*options); }; });
}

}  // namespace aomd::cli
