// The program `aomd`: reads the command line, runs one command, and turns failures into exit codes.

#include <algorithm>
#include <iostream>
#include <new>

#include "core/io/error.h"
#include "core/model/model.h"
#include "tools/aomd/command.h"
#include "tools/aomd/interrupt.h"
#include "tools/aomd/weld_option.h"

namespace aomd::cli {
namespace {

int fail(const std::string& what, int code) {
  std::cerr << "aomd: " << what << std::endl;
  return code;
}

/// CLI11's own messages span lines: the first is the one that says what is wrong.
std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

bool has_command(CLI::App& app, const std::string& name) {
  const auto commands = app.get_subcommands([](CLI::App*) { return true; });
  return std::any_of(commands.begin(), commands.end(),
                     [&](const CLI::App* c) { return c->check_name(name); });
}

int run(const Action& action) {
  try {
    const int code = action();
    std::cout.flush();
    return std::cout ? code : fail("standard output: cannot be written", not_written);
  } catch (const io::ReadError& e) {
    return fail(e.what(), bad_input);
  } catch (const ModelError& e) {
    return fail(e.what(), bad_input);
  } catch (const io::WriteError& e) {
    return fail(e.what(), not_written);
  } catch (const io::LimitError& e) {
    return fail(e.what(), out_of_limits);
  } catch (const UsageError& e) {
    return fail(e.what(), wrong_usage);
  } catch (const std::bad_alloc&) {
    return fail("out of memory", out_of_limits);
  } catch (const Cancelled&) {
    return fail("cancelled; nothing was written", cancelled);
  }
}

int parse_and_run(int argc, char** argv) {
  CLI::App app(
      "AOMD Studio on the command line: an algorithm-oriented mesh database and decimation on top "
      "of it.",
      "aomd");
  app.set_version_flag("--version", "aomd " AOMD_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 done, 1 the check or comparison says no, 2 wrong usage, 3 input unreadable or "
      "invalid,\n"
      "4 output not written, 5 out of memory or another limit, 130 cancelled.\n"
      "`aomd COMMAND --help` lists the options of a command.");
  Action action;
  for (auto* add : {add_info, add_decimate, add_check, add_classify, add_convert, add_compare,
                    add_repair, add_replay, add_sample, add_image_diff})
    add(app, action);
  if (argc > 1 && argv[1][0] != '-' && !has_command(app, argv[1]))
    return fail("no command \"" + std::string(argv[1]) + "\" (aomd --help lists what there is)",
                wrong_usage);
  try {
    app.parse(arguments_of(argc, argv));
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);  // --help and --version
    return fail(first_line(e.what()) + " (aomd --help lists what there is)", wrong_usage);
  }
  return run(action);
}

}  // namespace
}  // namespace aomd::cli

int main(int argc, char** argv) {
  aomd::cli::catch_interrupts();
  try {
    return aomd::cli::parse_and_run(argc, argv);
  } catch (const std::bad_alloc&) {
    return aomd::cli::fail("out of memory", aomd::cli::out_of_limits);
  }
}
