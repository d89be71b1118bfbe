#include "tools/aomd/batch.h"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <optional>
#include <sstream>
#include <system_error>

#include "core/base/processes.h"
#include "core/base/text.h"
#include "core/io/output_files.h"
#include "tools/aomd/failures.h"
#include "tools/aomd/report.h"
#include "tools/aomd/signals.h"
#include "tools/aomd/values.h"

namespace aomd::cli {
namespace {

namespace fs = std::filesystem;

/// What the work on one file came to.
struct FileResult {
  int code = done;
  std::string out, err;
};

std::string packed(const FileResult& result) {
  return std::to_string(result.code) + ' ' + std::to_string(result.out.size()) + ' ' + result.out +
         result.err;
}

FileResult unpacked(const std::string& text) {
  std::istringstream numbers(text.substr(0, 64));
  FileResult result;
  std::size_t size = 0;
  numbers >> result.code >> size;
  const std::size_t begin = text.find(' ', text.find(' ') + 1) + 1;
  result.out = text.substr(begin, size);
  result.err = text.substr(begin + size);
  return result;
}

/// What is told of a file that failed: a line for people, and with --json one for programs.
FileResult failed(const std::string& file, const std::string& words, int code, bool json) {
  const bool named = words.starts_with(printable(file)) || file == "-";
  FileResult result{code, {}, "aomd: " + printable(named ? words : file + ": " + words) + '\n'};
  if (json)
    result.out = text_of(
        {{"schema", 1}, {"file", file}, {"error", printable(words)}, {"exit_code", code}}, true);
  return result;
}

/// Sends what is written to a stream elsewhere for a while.
class Diverted {
 public:
  explicit Diverted(std::ostream& stream) : stream_(stream), before_(stream.rdbuf(text_.rdbuf())) {}
  ~Diverted() { stream_.rdbuf(before_); }
  Diverted(const Diverted&) = delete;
  Diverted& operator=(const Diverted&) = delete;
  [[nodiscard]] std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
  std::ostream& stream_;
  std::streambuf* before_;
};

/// Works on one file and keeps what is printed.
FileResult worked_on(const BatchFile& file, const BatchWork& work, bool json) {
  const Diverted out(std::cout), err(std::cerr);
  std::optional<FileResult> failure;
  const int code = run_caught(
      [&] { return work(file); },
      [&](const std::string& words, int why) { failure = failed(file.input, words, why, json); });
  if (!failure) return {code, out.text(), err.text()};
  return {code, out.text() + failure->out, err.text() + failure->err};
}

/// A process that a system without memory left has killed is no fault of this program.
FileResult result_of(const Piece& piece, const std::string& file, bool json) {
  if (piece.death.empty()) return unpacked(piece.answer);
  const bool killed = piece.death == "signal " + std::to_string(SIGKILL);
  const std::string words = "the process that worked on it ended with " + piece.death;
  return failed(file, killed ? words + ", as where memory runs out" : fault_words(words),
                killed ? out_of_limits : internal_fault, json);
}

/// The files of a call and what they come to, which is printed in their order.
class BatchRun {
 public:
  BatchRun(std::vector<BatchFile> files, bool json)
      : files_(std::move(files)), json_(json), results_(files_.size()) {}

  int run(const BatchWork& work) {
    Sharing how;
    how.jobs = static_cast<std::size_t>(files_.front().jobs);
    how.fresh = true;
    how.stop = signals_from_here_on();
    how.tell = [this](std::size_t i, const Piece& piece) {
      take(i, result_of(piece, files_[i].input, json_));
    };
    how.let_go = [] {
      static_cast<void>(io::abandon_outputs());
      ::_exit(signalled);
    };
    const auto pieces =
        share(how, [&](std::size_t i) { return packed(worked_on(files_[i], work, json_)); });
    if (next_ < results_.size()) return cancelled(how.stop);
    return worst_;
  }

 private:
  std::vector<Piece> share(const Sharing& how,
                           const std::function<std::string(std::size_t)>& work) const {
    try {
      return share_among_processes(files_.size(), how, work);
    } catch (const std::system_error& e) {
      throw io::LimitError(files_[next_].input, {}, std::string("no process for it: ") + e.what());
    }
  }
  void take(std::size_t i, FileResult result) {
    worst_ = std::max(worst_, result.code);
    results_[i] = std::move(result);
    for (; next_ < results_.size() && results_[next_]; ++next_) {
      std::cerr << results_[next_]->err << std::flush;
      std::cout << results_[next_]->out << std::flush;
      results_[next_] = FileResult();
    }
    ++done_;
  }
  [[nodiscard]] int cancelled(int signals) const {
    char signal = 0;
    static_cast<void>(!::read(signals, &signal, 1));
    say("aomd: cancelled after " + std::to_string(done_) + " of " + counted(files_.size(), "file") +
        "; all outputs are as they were or complete");
    return signalled + signal;
  }

  std::vector<BatchFile> files_;
  bool json_;
  std::vector<std::optional<FileResult>> results_;
  std::size_t next_ = 0, done_ = 0;  ///< the next to be printed; how many there are
  int worst_ = done;
};

CLI::Option* add_jobs(CLI::App& command, Batch& batch) {
  CLI::Option* option = command.add_option(
      "--jobs", batch.jobs, "Works on so many files at a time, each in a process of its own");
  return option->type_name("N")->transform(whole_number(1, 1024));
}

/// Where the result for a file goes: it keeps its name but for the extension of another format.
std::string output_in(const Batch& batch, const std::string& input) {
  fs::path name = fs::path(input).filename();
  if (!batch.format.empty()) name.replace_extension(lower(batch.format));
  return (fs::path(batch.folder) / name).string();
}

std::vector<BatchFile> batch_of(const Batch& batch, std::vector<std::string> inputs) {
  std::vector<BatchFile> files;
  files.reserve(inputs.size());
  for (std::string& input : inputs) {
    std::string output = batch.folder.empty() ? std::string() : output_in(batch, input);
    files.push_back({std::move(input), std::move(output), std::max(1, batch.jobs)});
  }
  return files;
}

void check_folder(const std::string& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored))
    throw io::WriteError(folder, {}, "is not there, or no folder: --to names one");
}

/// No result is an input or another result, and all can be written.
void check_batch(const std::vector<BatchFile>& files, std::vector<NamedFile> inputs) {
  std::vector<std::string> names;
  names.reserve(files.size());
  std::vector<NamedFile> outputs;
  for (const BatchFile& file : files) {
    if (file.input == "-") throw UsageError("- has no name, which --to needs");
    names.push_back("the result of " + file.input);
    inputs.push_back({file.input.c_str(), file.input});
    outputs.push_back({names.back().c_str(), file.output});
  }
  check_files(inputs, outputs);
}

}  // namespace

void add_files(CLI::App& command, Batch& batch) {
  command.add_option("FILE", batch.more, "The meshes; - is standard input")->required();
  add_jobs(command, batch);
}

void add_folder(CLI::App& command, Batch& batch) {
  CLI::Option* out = command.get_option("OUT");
  command.add_option("MORE", batch.more, "With --to: more meshes, as OUT is one then")
      ->type_name("FILE");
  CLI::Option* to = command.add_option(
      "--to", batch.folder,
      "Takes several meshes, and writes each into this folder, under its name;\n--format then "
      "changes the extensions");
  to->type_name("DIR")->check(not_empty())->each([out](const std::string&) {
    out->required(false);
  });
  add_jobs(command, batch)->needs(to);
}

Action reading(const std::shared_ptr<Batch>& batch, const BatchWork& work) {
  return [batch, work] {
    if (batch->more.size() == 1 && batch->jobs == 0) return work({batch->more.front(), {}});
    return BatchRun(batch_of(*batch, batch->more), batch->json).run(work);
  };
}

Action writing(const std::shared_ptr<Batch>& batch, const BatchWork& work,
               const std::vector<NamedFile>& others) {
  if (batch->folder.empty() && !batch->more.empty())
    throw CLI::ParseError(
        "one argument too many: " + batch->more.front() + "; several meshes go with --to DIR",
        CLI::ExitCodes::ExtrasError);
  if (batch->folder.empty()) return [batch, work] { return work({batch->input, batch->output}); };
  return [batch, work, others] {
    std::vector<std::string> inputs = {batch->input};
    if (!batch->output.empty()) inputs.push_back(batch->output);
    inputs.insert(inputs.end(), batch->more.begin(), batch->more.end());
    const std::vector<BatchFile> files = batch_of(*batch, std::move(inputs));
    check_folder(batch->folder);
    check_batch(files, others);
    return BatchRun(files, batch->json).run(work);
  };
}

}  // namespace aomd::cli
