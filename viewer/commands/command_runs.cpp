// States that are kept to be compared.

#include <string>

#include "viewer/base/entity_text.h"
#include "viewer/commands/command_groups.h"

namespace aomd::scene {
namespace {

void go_to(Session& session, const KeptRun& run, Arguments& arguments) {
  session.play(false);
  if (run.number == 0)
    session.document().seek(0);
  else if (!session.document().go_to_place(run.number))
    arguments.fail("the branch of " + run.name + " is gone");
  session.status = run.name + ": " + size_words(session.document().mesh());
}

void remove(Session& session, Arguments& arguments) {
  Arguments again = arguments;
  if (again.word("a number, or all") != "all") {
    const KeptRun run = kept_run(session, arguments);
    arguments.end();
    session.sheet().runs.remove(session.document(), run.number);
    session.status = "Forgot " + run.name;
    return;
  }
  again.end();
  while (!session.sheet().runs.rows().empty())
    session.sheet().runs.remove(session.document(), session.sheet().runs.rows().back().number);
  session.status = "Forgot all runs";
}

void runs(Session& session, Arguments& arguments) {
  need_decimable(session);
  const std::string what = arguments.one_of({"keep", "go", "remove", "measure"});
  if (what == "keep") {
    session.document().cancel_run();
    session.keep_run(arguments.done() ? "" : arguments.rest("a name"));
  } else if (what == "go") {
    const KeptRun run = kept_run(session, arguments);
    arguments.end();
    go_to(session, run, arguments);
  } else if (what == "remove") {
    remove(session, arguments);
  } else {
    arguments.end();
    session.start_measuring();
  }
}

}  // namespace

KeptRun kept_run(const Session& session, Arguments& arguments) {
  const long long number = arguments.integer("a run's number");
  const KeptRun* run = number < 0 || number > 1'000'000'000
                           ? nullptr
                           : session.sheet().runs.find(static_cast<unsigned>(number));
  if (run == nullptr) arguments.fail("there is no run " + std::to_string(number));
  return *run;
}

std::vector<Command> run_commands() {
  return {
      {"runs",
       "keep [NAME] | go N | remove N|all | measure",
       "The table of runs (panel runs): each that has ended is kept, keep adds the present state "
       "or names "
       "it. "
       "go leads back to number N, on whichever branch it is; measure finds out how far each is "
       "from the "
       "mesh "
       "as loaded, in the background.",
       CommandGroup::History,
       runs,
       {}},
  };
}

}  // namespace aomd::scene
