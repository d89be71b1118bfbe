#include <array>
#include <string>

#include "viewer/base/text.h"
#include "viewer/commands/command_groups.h"
#include "viewer/commands/lesson_commands.h"
#include "viewer/explain/id_facts.h"

namespace aomd::scene {
namespace {

using Quantity = std::int64_t (*)(const Session&);

std::int64_t models(const Session& s, int dim) {
  std::int64_t count = 0;
  for (const ModelRef ref : s.document().mesh().class_lists()->models(dim))
    count += ref.dimension() == dim;
  return count;
}

std::int64_t refused(const Session& s, Reason reason) {
  const SweepStatistics* sweep = s.document().last_sweep();
  return sweep == nullptr ? 0 : sweep->refused[static_cast<std::size_t>(reason)];
}

std::int64_t neighbours(const Session& s) {
  return s.sheet().inquiry().neighbours()
             ? static_cast<std::int64_t>(s.sheet().inquiry().neighbours()->entities.size())
             : 0;
}

std::int64_t signed_count(std::size_t n) { return static_cast<std::int64_t>(n); }

template <typename Of>
std::int64_t hash_sum(const Session& s, Of&& of) {
  std::int64_t sum = 0;
  for (int level = 1; level < 4; ++level) {
    const HashFacts facts = hash_facts(s.document().mesh(), level);
    sum += static_cast<std::int64_t>(of(facts));
  }
  return sum;
}

std::int64_t free_ids(const Session& s, int level) {
  return signed_count(s.document().mesh().ids(level).free_ids().size());
}

struct Named {
  std::string_view name;
  Quantity value;
};

constexpr std::array<Named, 33> quantities = {{
    {"selected",
     [](const Session& s) { return static_cast<std::int64_t>(s.sheet().selection.size()); }},
    {"neighbours", [](const Session& s) { return neighbours(s); }},
    {"adjacency-bytes",
     [](const Session& s) { return signed_count(s.document().mesh().adjacency_bytes()); }},
    {"hash-entities",
     [](const Session& s) { return hash_sum(s, [](auto& f) { return f.entities; }); }},
    {"hash-buckets",
     [](const Session& s) { return hash_sum(s, [](auto& f) { return f.statistics.buckets; }); }},
    {"hash-rehashes",
     [](const Session& s) { return hash_sum(s, [](auto& f) { return f.rehashes.size(); }); }},
    {"free-vertices", [](const Session& s) { return free_ids(s, 0); }},
    {"free-edges", [](const Session& s) { return free_ids(s, 1); }},
    {"free-faces", [](const Session& s) { return free_ids(s, 2); }},
    {"same-result",
     [](const Session& s) {
       return std::int64_t{s.sheet().storage() && s.sheet().storage()->same};
     }},
    {"vertices", [](const Session& s) { return s.sheet().facts().vertices; }},
    {"edges", [](const Session& s) { return s.sheet().facts().edges; }},
    {"faces", [](const Session& s) { return s.sheet().facts().faces; }},
    {"regions", [](const Session& s) { return s.sheet().facts().regions; }},
    {"outer-faces", [](const Session& s) { return s.sheet().facts().outer_faces; }},
    {"euler", [](const Session& s) { return s.sheet().facts().euler(); }},
    {"boundary", [](const Session& s) { return s.sheet().facts().boundary; }},
    {"nonmanifold", [](const Session& s) { return s.sheet().facts().nonmanifold; }},
    {"unused", [](const Session& s) { return s.sheet().facts().unused; }},
    {"model-vertices", [](const Session& s) { return models(s, 0); }},
    {"model-edges", [](const Session& s) { return models(s, 1); }},
    {"model-faces", [](const Session& s) { return models(s, 2); }},
    {"model-regions", [](const Session& s) { return models(s, 3); }},
    {"steps",
     [](const Session& s) { return static_cast<std::int64_t>(s.document().journal().size()); }},
    {"cursor",
     [](const Session& s) { return static_cast<std::int64_t>(s.document().journal().cursor()); }},
    {"commands",
     [](const Session& s) { return static_cast<std::int64_t>(s.document().marks().size()); }},
    {"branches",
     [](const Session& s) {
       return static_cast<std::int64_t>(s.document().tree().branches().size());
     }},
    {"bookmarks",
     [](const Session& s) {
       return static_cast<std::int64_t>(s.document().tree().bookmarks().size());
     }},
    {"runs", [](const Session& s) { return signed_count(s.sheet().runs.size()); }},
    {"refused-classification", [](const Session& s) { return refused(s, Reason::Classification); }},
    {"refused-topology", [](const Session& s) { return refused(s, Reason::Topology); }},
    {"refused-angle", [](const Session& s) { return refused(s, Reason::Angle); }},
    {"refused-shape", [](const Session& s) { return refused(s, Reason::Shape); }},
}};

Quantity quantity(Arguments& arguments) {
  const std::string name = arguments.word("a quantity");
  std::string names;
  for (const Named& each : quantities) {
    if (each.name == name) return each.value;
    names += (names.empty() ? "" : ", ") + std::string(each.name);
  }
  arguments.fail("'" + name + "' is none of " + names);
}

void expect(Session& session, Arguments& arguments) {
  need_mesh(session);
  Arguments again = arguments;
  const std::string what = again.rest("a quantity");
  if (what.rfind("adjacency ", 0) == 0) return expect_adjacency(session, arguments);
  if (expect_other(session, arguments)) return;
  const Quantity of = quantity(arguments);
  const std::string sign = comparison(arguments);
  const long long bound = arguments.integer("a whole number");
  arguments.end();
  session.refresh();
  const std::int64_t value = of(session);
  if (!holds(sign, value <=> bound))
    throw ExpectationMissed("expected " + what + ", but it is " + std::to_string(value));
}

void wait_idle(Session& session, Arguments& arguments) {
  arguments.end();
  session.finish();
  update_lesson(session);
}

void log(Session& session, Arguments& arguments) { session.log = arguments.rest("a text"); }

}  // namespace

std::vector<Command> script_commands() {
  return {
      {"expect",
       "QUANTITY = N",
       "Ends a script with exit code 1 unless it holds; also <, >, <=, >=. Quantities: vertices, "
       "edges, "
       "faces, regions, selected, neighbours (that light up), adjacency-bytes, hash-entities, "
       "hash-buckets, "
       "hash-rehashes (of all levels), free-vertices, free-edges, free-faces (on the id stacks), "
       "same-result "
       "(1 where both strategies led to the same mesh), outer-faces (of a volume), euler (over "
       "used "
       "vertices), boundary, nonmanifold, unused, model-vertices, model-edges, model-faces, "
       "model-regions, "
       "steps, cursor, commands, branches (others than the present one), bookmarks, runs (that are "
       "kept), "
       "refused-classification, "
       "refused-topology, refused-angle, refused-shape. Also: expect adjacency I J = on|off; "
       "angle, factor, "
       "feature-angle, stored (relations), decided (the number of the verdict on what is "
       "selected), "
       "scale-start, scale-end (of the colours), measured (the first number of what is measured on "
       "the "
       "selection), camera-distance, lesson-page, lesson-met, lesson-done; and with = or != a "
       "word: "
       "kind, "
       "selection, verdict, verdict-of VERTEX, lies-on, ends, color, strategy, topology, class "
       "KIND ID, "
       "alive KIND ID, derived I J, around KIND ID LEVEL, direction FACE EDGE.",
       CommandGroup::Scripts,
       expect,
       {}},
      {"wait-idle",
       "",
       "Waits until loading, running and playing have ended.",
       CommandGroup::Scripts,
       wait_idle,
       {}},
      {"log", "TEXT", "Prints a line.", CommandGroup::Scripts, log, {}},
  };
}

}  // namespace aomd::scene
