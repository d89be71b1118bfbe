#pragma once
// `aomd decimate` on several files.

#include "tools/aomd/batch.h"
#include "tools/aomd/decimate_options.h"

namespace aomd::cli {

/// Adds what only the program has beside the options of a decimation: several files, and --json.
void add_batch_options(CLI::App& command, Batch& batch, DecimateOptions& options);

/// Tells a batch what the options say of files.
void take_files(Batch& batch, const DecimateOptions& options);

/// What is done to one file. Those that are worked on at a time share the cores.
[[nodiscard]] DecimateOptions one_of_batch(const DecimateOptions& all, const BatchFile& file);

}  // namespace aomd::cli
