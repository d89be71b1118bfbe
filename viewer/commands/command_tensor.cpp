// Hash sets, id stacks and what the strategies of T(I,J) cost: sections of its page.

#include <string>

#include "core/mesh/names.h"
#include "viewer/base/text.h"
#include "viewer/commands/command_groups.h"
#include "viewer/explain/id_facts.h"

namespace aomd::scene {
namespace {

constexpr long long most_buckets = 100'000'000;

/// Opens or closes a section; opening it turns to the page.
void show(Session& session, bool& section, Arguments& arguments) {
  Panels& panels = session.view.panels;
  const bool up = section && panels.side && panels.page == Page::Adjacency;
  section = arguments.flag(up);
  arguments.end();
  if (!section) return;
  panels.side = true;
  panels.page = Page::Adjacency;
}

void build_set(Session& session, Arguments& arguments) {
  const int level = arguments.level(1);
  long long buckets = 0;
  if (!arguments.done()) buckets = arguments.integer("a number of buckets", 1, most_buckets);
  arguments.end();
  need_mesh(session);
  session.document().build_hash(level, static_cast<std::uint32_t>(buckets));
  const HashFacts facts = hash_facts(session.document().mesh(), level);
  session.status = "Hash set of the " + std::string(entity_plural(level)) + ": " +
                   grouped(facts.entities) + " in " + grouped(facts.statistics.buckets) +
                   " buckets, " + bytes_text(facts.bytes);
}

void release_set(Session& session, Arguments& arguments) {
  const int level = arguments.level(1);
  arguments.end();
  need_mesh(session);
  const bool built = session.document().mesh().hash(level).built();
  session.document().drop_hash(level);
  session.status = "Hash set of the " + std::string(entity_plural(level)) +
                   (built ? " is freed" : ": there was none");
}

void hash_sets(Session& session, Arguments& arguments) {
  Arguments again = arguments;
  const std::string word = again.done() ? "" : again.word("on, off, toggle, build or release");
  if (word == "build") return build_set(session, again);
  if (word == "release") return release_set(session, again);
  show(session, session.view.sections.hash_sets, arguments);
}

void id_stacks(Session& session, Arguments& arguments) {
  show(session, session.view.sections.ids, arguments);
}

void strategies(Session& session, Arguments& arguments) {
  Arguments again = arguments;
  if (again.done() || again.word("on, off, toggle or run") != "run")
    return show(session, session.view.sections.strategies, arguments);
  again.end();
  need_decimable(session);
  if (session.document().content().volume())
    throw CommandError("what T(0,2) costs is compared on surfaces, and this mesh is a volume");
  session.start_comparison();
}

}  // namespace

std::vector<Command> tensor_commands() {
  return {
      {"hash-sets",
       "[on|off|toggle] | build edge|face|region [BUCKETS] | release edge|face|region",
       "Shows the hash sets that find entities from their vertices where no stored relation can. "
       "build makes "
       "one, starting with about as many buckets as entities, or BUCKETS; it grows tenfold when "
       "more than 10 "
       "% of its used buckets hold 10 entities or more. Not part of the history.",
       CommandGroup::Options,
       hash_sets,
       {}},
      {"ids",
       "[on|off|toggle]",
       "Shows the id stack of each level: ids of deleted entities go onto it, and undo takes them "
       "back.",
       CommandGroup::Options,
       id_stacks,
       {}},
      {"strategies",
       "[on|off|toggle] | run",
       "Shows what the paper's two ways to store adjacencies cost; run decimates two copies of the "
       "present "
       "mesh by the paper's strategy in the background, keeping T(0,2), and giving it up for "
       "T(0,1) and "
       "T(1,2) while edges are swapped and vertices smoothed. cancel stops it.",
       CommandGroup::Options,
       strategies,
       {}},
  };
}

}  // namespace aomd::scene
