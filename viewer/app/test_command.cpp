#include "viewer/app/test_command.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <tuple>
#include <utility>

#include "core/base/processes.h"
#include "core/base/text.h"
#include "core/io/output_files.h"
#include "viewer/app/case_runner.h"
#include "viewer/app/options.h"
#include "viewer/app/test_options.h"
#include "viewer/suite/report.h"

namespace aomd::app {
namespace {

namespace fs = std::filesystem;
using suite::Finished;

/// A folder for pictures, gone when the program is done.
class WorkFolder {
 public:
  WorkFolder() {
    std::string name = (fs::temp_directory_path() / "aomd-view-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw io::WriteError(name, {}, "no folder can be made here");
    path_ = name;
  }
  ~WorkFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// The cases that were asked for; none and a line on standard error where a name is unknown.
std::vector<const suite::Case*> chosen_cases(const suite::Suite& suite,
                                             const std::vector<std::string>& names) {
  std::vector<const suite::Case*> chosen;
  for (const suite::Case& each : suite.cases)
    if (names.empty() || std::find(names.begin(), names.end(), each.name) != names.end())
      chosen.push_back(&each);
  for (const std::string& name : names) {
    const auto is_it = [&](const suite::Case* each) { return each->name == name; };
    if (std::any_of(chosen.begin(), chosen.end(), is_it)) continue;
    std::cerr << "aomd-view: " << printable(suite.file.string()) << " has no case " << shown(name)
              << "\n";
    return {};
  }
  return chosen;
}

suite::CaseResult result_of(const Piece& piece) {
  if (piece.death.empty()) return suite::from_json(piece.answer);
  suite::CaseResult result;
  result.exit_code = exit_fault;
  result.why = "the process that drew it ended with " + piece.death;
  return result;
}

/// Those of one size and one mesh follow one another: what drawing takes is then made once.
void sort_by_mesh(std::vector<const suite::Case*>& cases) {
  const auto key = [](const suite::Case* each) {
    return std::tuple(each->size.x, each->size.y, (each->folder / each->mesh).lexically_normal());
  };
  std::stable_sort(cases.begin(), cases.end(),
                   [&](const suite::Case* a, const suite::Case* b) { return key(a) < key(b); });
}

/// In the order of the suite.
std::vector<Finished> carry_out(const suite::Suite& suite, std::vector<const suite::Case*> cases,
                                const TestOptions& options, const fs::path& work) {
  CaseRunner runner(suite, work, options.update);
  sort_by_mesh(cases);
  Sharing how;
  how.jobs = options.jobs;
  const auto pieces = share_among_processes(
      cases.size(), how, [&](std::size_t i) { return suite::to_json(runner.run(*cases[i])); });
  std::vector<Finished> finished;
  for (std::size_t i = 0; i < cases.size(); ++i)
    finished.push_back({cases[i], result_of(pieces[i])});
  std::sort(finished.begin(), finished.end(),
            [](const Finished& a, const Finished& b) { return a.what < b.what; });
  return finished;
}

void keep_pictures(const std::vector<Finished>& finished, const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  for (const Finished& each : finished)
    for (const fs::path& file : {each.result.picture, each.result.difference})
      if (!error && !each.result.well() && !file.empty())
        fs::copy_file(file, folder / file.filename(), fs::copy_options::overwrite_existing, error);
  if (error) throw io::WriteError(folder.string(), {}, error.message());
}

void write_reports(const suite::Suite& suite, const std::vector<Finished>& finished,
                   const TestOptions& options) {
  io::OutputFiles files;
  if (!options.junit.empty()) files.add(options.junit, report_junit(suite, finished));
  if (!options.html.empty()) files.add(options.html, report_page(suite, finished));
  files.commit();
  if (!options.results.empty()) keep_pictures(finished, options.results);
}

void tell(const suite::Suite& suite, const std::vector<Finished>& finished) {
  std::cout << report_table(finished) << std::flush;
  for (const Finished& each : finished)
    if (!each.result.well())
      std::cerr << "aomd-view: " << printable(suite.place_of(*each.what)) << ": " << each.what->name
                << ": " << each.result.why << "\n";
}

}  // namespace

int test_command(int argc, char** argv) {
  int code = exit_done;
  const auto options = parse_test_options(argc, argv, code);
  if (!options) return code;
  const suite::Suite suite = suite::read_suite(options->suite);
  const auto cases = chosen_cases(suite, options->names);
  if (cases.empty()) return exit_usage;
  for (const fs::path& file : {options->junit, options->html})
    if (!file.empty()) io::OutputFiles::probe(file);
  const WorkFolder work;
  const std::vector<Finished> finished = carry_out(suite, cases, *options, work.path());
  tell(suite, finished);
  write_reports(suite, finished, *options);
  for (const Finished& each : finished) code = std::max(code, each.result.exit_code);
  return code;
}

}  // namespace aomd::app
