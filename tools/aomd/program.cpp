#include "tools/aomd/program.h"

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "core/base/text.h"
#include "tools/aomd/failures.h"
#include "tools/aomd/signals.h"
#include "tools/aomd/weld_option.h"

namespace aomd::cli {
namespace {

int fail(const std::string& what, int code) {
  std::cerr << "aomd: " << printable(what) << std::endl;
  return code;
}

/// The first word that no option and no file stands for; CLI11 names all of them, backwards.
std::string unexpected_word(const CLI::App& app, int argc, char** argv) {
  const std::vector<std::string> words = app.remaining(true);
  const auto left_over = [&](const char* word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  char** const found = std::find_if(argv + 1, argv + argc, left_over);
  if (found == argv + argc) return "one argument too many";
  const std::string word = *found;
  return word.starts_with('-') ? "there is no option " + word : "one argument too many: " + word;
}

/// One line of what CLI11 says.
std::string words_of(const CLI::ParseError& error, const CLI::App& app, int argc, char** argv) {
  const std::string text = error.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
    return unexpected_word(app, argc, argv);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr)
    return text.substr(0, text.find(':')) + " needs a value";
  return text.substr(0, text.find('\n'));
}

/// "aomd decimate --help lists what there is", once a command is known.
std::string hint(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return " (aomd " + (chosen.empty() ? "" : chosen.front()->get_name() + " ") +
         "--help lists what there is)";
}

bool has_command(CLI::App& app, const std::string& name) {
  const auto commands = app.get_subcommands([](CLI::App*) { return true; });
  return std::any_of(commands.begin(), commands.end(),
                     [&](const CLI::App* c) { return c->check_name(name); });
}

int run(const Action& action) {
  const int code = run_caught(action, fail);
  std::cout.flush();
  return std::cout || code > says_no ? code
                                     : fail("standard output: cannot be written", not_written);
}

int parse_and_run(const char* name, const std::vector<AddCommand>& commands, int argc,
                  char** argv) {
  CLI::App app(
      "AOMD Studio on the command line: an algorithm-oriented mesh database and decimation on top "
      "of it.",
      name);
  app.set_version_flag("--version", std::string(name) + " " AOMD_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 done, 1 the check or comparison says no, 2 wrong usage, 3 input unreadable or "
      "invalid,\n"
      "4 output not written, 5 out of memory or another limit, 70 internal fault, 130 cancelled by "
      "Ctrl-C\n(143 by SIGTERM, 129 by SIGHUP); of several files the largest.\n"
      "`aomd COMMAND --help` lists the options of a command.");
  Action action;
  for (const AddCommand& add : commands) add(app, action);
  if (argc > 1 && argv[1][0] != '-' && !has_command(app, argv[1]))
    return fail("no command \"" + std::string(argv[1]) + "\" (aomd --help lists what there is)",
                wrong_usage);
  try {
    app.parse(arguments_of(argc, argv));
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);  // --help and --version
    return fail(words_of(e, app, argc, argv) + hint(app), wrong_usage);
  }
  return action();
}

}  // namespace

int run_program(const char* name, const std::vector<AddCommand>& commands, int argc, char** argv) {
#ifdef __GLIBC__
  // Large arrays go back to the system as soon as they are freed, so that what one stage needs does
  // not add to what the next one does.
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
#endif
  end_on_signals();
  name_internal_faults();
  return run([&] { return parse_and_run(name, commands, argc, argv); });
}

}  // namespace aomd::cli
