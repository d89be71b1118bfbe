#include "tools/aomd/decimate_batch.h"

#include <algorithm>

#include "core/base/parallel.h"

namespace aomd::cli {

void add_batch_options(CLI::App& command, Batch& batch, DecimateOptions& options) {
  add_folder(command, batch);
  CLI::Option* json = command.add_flag(
      "--json", options.prints_json,
      "Prints the report as JSON instead of a summary; of several meshes a line each");
  CLI::Option* to = command.get_option("--to");
  for (const char* of_one : {"--report", "--journal"}) to->excludes(command.get_option(of_one));
  for (CLI::Option* each : {to, command.get_option("--jobs"), json}) each->group("Output");
}

void take_files(Batch& batch, const DecimateOptions& options) {
  batch.input = options.input;
  batch.output = options.output;
  batch.format = options.format;
  batch.json = options.prints_json;
}

DecimateOptions one_of_batch(const DecimateOptions& all, const BatchFile& file) {
  DecimateOptions one = all;
  one.input = file.input;
  one.output = file.output;
  one.one_of_several = file.one_of_several();
  if (one.threads == 0 && file.jobs > 1) one.threads = std::max(1, thread_count(0) / file.jobs);
  return one;
}

}  // namespace aomd::cli
