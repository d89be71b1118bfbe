#include "viewer/app/test_options.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "viewer/app/named_files.h"
#include "viewer/app/options.h"

namespace aomd::app {
namespace {

constexpr const char* footer =
    "\nA suite lists pictures, one a line; docs/REGRESSION.md says how:\n\n"
    "  [defaults]\n"
    "  size = \"640x480\"\n"
    "  [cases]\n"
    "  part = \"part.ply\"\n"
    "  part-back = { mesh = \"part.ply\", camera = \"back\", expect = \"faces = 1200\" }\n\n"
    "Exit codes: 0 all are as their baselines; 1 one is not, or an expectation does not hold;\n"
    "2 wrong usage; 3 the suite, a file or a baseline is missing or wrong; 4 a file cannot be\n"
    "written; 5 too large; 70 an internal fault. Of several the largest counts.";

void add_options(CLI::App& app, TestOptions& options, std::vector<std::string>& only) {
  app.add_option("SUITE", options.suite, "The list of pictures, a TOML file")
      ->required()
      ->option_text("TOML");
  app.add_option("--jobs", options.jobs, "How many processes share the work (default 1)")
      ->check(CLI::Range(1, 256))
      ->option_text("N");
  app.add_option("--update", options.names,
                 "Make the baselines of these cases, or of all, from what is drawn now")
      ->type_name("NAME...")
      ->expected(0, 1 << 20);
  app.add_option("--only", only, "Carry out these cases alone")
      ->type_name("NAME...")
      ->expected(1, 1 << 20);
  app.add_option("--junit", options.junit, "Write the results as JUnit XML")->type_name("FILE");
  app.add_option("--html", options.html,
                 "Write a page that shows baseline, result and difference of each case")
      ->type_name("FILE");
  app.add_option("--results", options.results,
                 "Write what was drawn where it is not as the baseline, and the difference, into "
                 "this folder")
      ->type_name("DIR");
  app.footer(footer);
}

}  // namespace

std::optional<TestOptions> parse_test_options(int argc, char** argv, int& exit_code) {
  CLI::App app("Draws the pictures of a suite and compares them with their baselines.",
               "aomd-view test");
  TestOptions options;
  std::vector<std::string> only;
  add_options(app, options, only);
  std::string wrong;
  try {
    app.parse(argc, argv);
    options.update = app.count("--update") > 0;
    std::erase(options.names, "");  // what CLI11 has for no name at all
    if (options.update && !only.empty()) wrong = "--update names the cases itself, without --only";
    if (wrong.empty())
      wrong = clash_of_files({{"SUITE", options.suite}},
                             {{"--junit", options.junit}, {"--html", options.html}});
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
      exit_code = app.exit(error);
      return {};
    }
    wrong = std::string(error.what()) + " (aomd-view test --help lists the options)";
  }
  if (!only.empty()) options.names = std::move(only);
  if (wrong.empty()) return options;
  std::cerr << "aomd-view: " << wrong << "\n";
  exit_code = exit_usage;
  return {};
}

}  // namespace aomd::app
