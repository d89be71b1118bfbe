#pragma once
// Several files in one call: each in a process of its own, so that none matters to the others.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tools/aomd/command.h"
#include "tools/aomd/outputs.h"

namespace aomd::cli {

/// What a call was given that may be for several files.
struct Batch {
  std::string input, output, format;
  std::vector<std::string> more;  ///< all files of a command that only reads
  std::string folder;             ///< where results go; empty: to `output`
  int jobs = 0;                   ///< how many files are worked on at a time; 0: not given
  bool json = false;
};

/// One file of a call.
struct BatchFile {
  std::string input, output;
  int jobs = 0;  ///< how many such files are worked on at a time; 0: this is the only one
  [[nodiscard]] bool one_of_several() const { return jobs > 0; }
};
/// What a command is told, for one of the files: its arguments have what a Batch has, and
/// `in_one_line`.
template <typename Arguments>
[[nodiscard]] Arguments for_file(Arguments one, const Batch& batch, const BatchFile& file) {
  one.input = file.input;
  one.output = file.output;
  one.format = batch.format;
  one.json = batch.json;
  one.in_one_line = file.one_of_several();
  return one;
}

/// What a command does with one file; returns an exit code and may throw what an Action may.
using BatchWork = std::function<int(const BatchFile&)>;

/// Adds FILE... and --jobs to a command that only reads.
void add_files(CLI::App& command, Batch& batch);
/// Adds --to and --jobs to a command that has IN and OUT.
void add_folder(CLI::App& command, Batch& batch);

/// A command that only reads: several files, or one where --jobs is not given, are a batch.
[[nodiscard]] Action reading(const std::shared_ptr<Batch>& batch, const BatchWork& work);
/// A command that writes, in a batch with --to; `others` are files that it reads beside meshes.
/// Throws CLI::ParseError for more words than IN and OUT without it.
[[nodiscard]] Action writing(const std::shared_ptr<Batch>& batch, const BatchWork& work,
                             const std::vector<NamedFile>& others = {});

}  // namespace aomd::cli
