// What `expect` knows besides counts: what is selected and said about it, options, T and single
// entities.

#include <algorithm>
#include <array>
#include <functional>
#include <string>

#include "core/mesh/derive.h"
#include "viewer/base/text.h"
#include "viewer/commands/command_groups.h"
#include "viewer/commands/lesson_commands.h"
#include "viewer/explain/entity_facts.h"
#include "viewer/explain/measures.h"

namespace aomd::scene {
namespace {

std::string flag_word(bool on) { return on ? "on" : "off"; }

EntityRef entity(const Session& session, Arguments& arguments, int dim) {
  const long long id = arguments.integer("an id");
  const EntityRef e(dim, static_cast<std::uint32_t>(id));
  const Mesh& mesh = session.document().mesh();
  return id >= 0 && id < mesh.capacity(dim) && mesh.alive(e) ? e : EntityRef();
}

EntityRef entity(const Session& session, Arguments& arguments) {
  return entity(session, arguments, arguments.level());
}

std::string ids_text(const std::vector<std::uint32_t>& ids) {
  std::string text;
  for (const std::uint32_t id : ids) text += (text.empty() ? "" : " ") + std::to_string(id);
  return text;
}

int level(Arguments& arguments) {
  const long long value = arguments.integer("a level from 0 to 3");
  if (value < 0 || value > 3)
    arguments.fail("'" + std::to_string(value) + "' is not a level from 0 to 3");
  return static_cast<int>(value);
}

// Each reads the words of its question and gives the answer as a text.

/// "edge 12 14", "edge" alone for whatever one edge that is selected.
std::string selection(Session& session, Arguments&) {
  const auto entities = session.sheet().selection.entities();
  if (entities.empty()) return "none";
  std::string text;
  int dim = -1;
  for (const EntityRef e : entities) {
    if (e.dimension != dim)
      text += (text.empty() ? "" : " ") + std::string(entity_name(e.dimension));
    dim = e.dimension;
    text += " " + std::to_string(e.index);
  }
  return text;
}

std::string kind(Session& session, Arguments&) {
  const EntityRef e = session.sheet().selection.single();
  return e.valid() ? std::string(entity_name(e.dimension)) : "none";
}

std::string verdict(Session& session, Arguments&) {
  const EntityVerdict* judgement = session.sheet().inquiry().verdict();
  if (judgement == nullptr || judgement->ways.empty()) return "unknown";
  const Verdict& best = judgement->ways[judgement->best].outlook.verdict;
  return best.accepted() ? "accepted" : reason_word(best.reason);
}

/// Of the way in which a vertex goes.
std::string verdict_of(Session& session, Arguments& arguments) {
  const long long id = arguments.integer("the vertex that would go");
  const EntityVerdict* judgement = session.sheet().inquiry().verdict();
  if (judgement == nullptr) return "unknown";
  for (const CollapseWay& way : judgement->ways) {
    if (way.outlook.contraction.deleted.index != id) continue;
    return way.outlook.verdict.accepted() ? "accepted" : reason_word(way.outlook.verdict.reason);
  }
  return "unknown";
}

std::string color_word(Session& session, Arguments&) {
  constexpr std::array names = {"classification", "spacing", "quality", "distance",
                                "curvature",      "verdict", "none"};
  return names[static_cast<std::size_t>(session.view.coloring)];
}

std::string strategy_word(Session& session, Arguments&) {
  return session.document().options().strategy == Strategy::Paper ? "paper" : "quality";
}

std::string topology_word(Session& session, Arguments&) {
  return session.document().options().topology == TopologyRule::Safe ? "safe" : "paper";
}

std::string class_of(Session& session, Arguments& arguments) {
  const EntityRef e = entity(session, arguments);
  if (!e.valid()) return "gone";
  const std::string text = model_entity_text(session.document().mesh().classification(e));
  return text.empty() ? "none" : text;
}

std::string model_level(const Mesh& mesh, EntityRef e) {
  const ModelRef ref = mesh.classification(e);
  return ref.valid() ? std::string(entity_name(ref.dimension())) : "nothing";
}

/// The level of what the selected entity lies on.
std::string lies_on(Session& session, Arguments&) {
  const EntityRef e = session.sheet().selection.single();
  return e.valid() ? model_level(session.document().mesh(), e) : "unknown";
}

/// The model levels that the vertices of the selected entity lie on.
std::string ends(Session& session, Arguments&) {
  const EntityRef e = session.sheet().selection.single();
  const Mesh& mesh = session.document().mesh();
  if (e.dimension < 1 || explain(mesh, e.dimension, 0).kind == AdjacencyPath::Kind::None)
    return "unknown";
  std::vector<std::uint32_t> ids;
  adjacent(mesh, e, 0, ids);
  std::string text;
  for (const std::uint32_t id : ids) text += (text.empty() ? "" : " ") + model_level(mesh, {0, id});
  return text;
}

std::string alive(Session& session, Arguments& arguments) {
  return flag_word(entity(session, arguments).valid());
}

std::string derived(Session& session, Arguments& arguments) {
  const int i = level(arguments), j = level(arguments);
  if (i == j) arguments.fail("I and J are two different levels: T has no relation on its diagonal");
  return flag_word(explain(session.document().mesh(), i, j).kind != AdjacencyPath::Kind::None);
}

std::string around(Session& session, Arguments& arguments) {
  const EntityRef e = entity(session, arguments);
  const int j = level(arguments);
  if (!e.valid()) return "gone";
  const Mesh& mesh = session.document().mesh();
  if (e.dimension == j || explain(mesh, e.dimension, j).kind == AdjacencyPath::Kind::None)
    return "unknown";
  std::vector<std::uint32_t> ids;
  adjacent(mesh, e, j, ids);
  return ids_text(ids);
}

std::string direction(Session& session, Arguments& arguments) {
  const EntityRef face = entity(session, arguments, 2), edge = entity(session, arguments, 1);
  if (!face.valid() || !edge.valid()) return "gone";
  const Mesh& mesh = session.document().mesh();
  std::vector<std::uint32_t> edges;
  adjacent(mesh, face, 1, edges);
  if (std::find(edges.begin(), edges.end(), edge.index) == edges.end()) return "unused";
  return mesh.use_direction(Face(face.index), Edge(edge.index)) ? "forwards" : "backwards";
}

struct Question {
  std::string_view name;
  std::string (*answer)(Session&, Arguments&);
};
constexpr std::array<Question, 14> questions = {{{"selection", selection},
                                                 {"kind", kind},
                                                 {"verdict", verdict},
                                                 {"verdict-of", verdict_of},
                                                 {"color", color_word},
                                                 {"strategy", strategy_word},
                                                 {"topology", topology_word},
                                                 {"class", class_of},
                                                 {"lies-on", lies_on},
                                                 {"ends", ends},
                                                 {"alive", alive},
                                                 {"derived", derived},
                                                 {"around", around},
                                                 {"direction", direction}}};

/// The number that decided about the selected edge; 0 where none did.
double decided(Session& session) {
  const EntityVerdict* judgement = session.sheet().inquiry().verdict();
  if (judgement == nullptr || judgement->ways.empty()) return 0;
  return judgement->ways[judgement->best].outlook.verdict.number();
}

/// The first of what is measured on the selection; 0 where nothing is.
double measured(Session& session) {
  const Measures measures = measure_selection(session.document().mesh(), session.sheet().selection);
  return measures.values.empty() ? 0 : measures.values.front();
}

double stored_relations(Session& session) {
  double count = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) count += i != j && session.document().mesh().stored(i, j);
  return count;
}

double met(Session& session) {
  update_lesson(session);
  const auto& checks = session.lesson.met();
  return session.lesson.lesson() == nullptr
             ? 0
             : static_cast<double>(std::count(checks.begin(), checks.end(), true));
}

double lesson_done(Session& session) {
  update_lesson(session);
  return session.lesson.lesson() != nullptr && session.lesson.done() ? 1 : 0;
}

struct Measure {
  std::string_view name;
  double (*value)(Session&);
};
constexpr std::array<Measure, 13> measures = {
    {{"angle", [](Session& s) { return s.document().options().angle_deg; }},
     {"factor", [](Session& s) { return s.document().options().factor; }},
     {"feature-angle",
      [](Session& s) { return s.document().classify_options().feature_angle_deg.value_or(0); }},
     {"decided", decided},
     {"scale-start",
      [](Session& s) { return s.sheet().field() != nullptr ? s.sheet().field()->scale.low : 0.0; }},
     {"scale-end",
      [](Session& s) {
        return s.sheet().field() != nullptr ? s.sheet().field()->scale.high : 0.0;
      }},
     {"camera-distance", [](Session& s) { return s.view.camera.distance; }},
     {"measured", measured},
     {"stored", stored_relations},
     {"lesson-page",
      [](Session& s) {
        return s.lesson.lesson() == nullptr ? 0 : static_cast<double>(s.lesson.page_number() + 1);
      }},
     {"lesson-met", met},
     {"lesson-done", lesson_done},
     {"lessons-completed",
      [](Session& s) { return static_cast<double>(s.lesson.completed.size()); }}}};

void expect_answer(Session& session, const Question& question, const std::string& what,
                   Arguments& arguments) {
  session.refresh();
  const std::string answer = question.answer(session, arguments);
  const std::string sign = arguments.one_of({"=", "!="});
  const std::string wanted = arguments.rest("what it should be");
  if ((answer == wanted) != (sign == "="))
    throw ExpectationMissed("expected " + what + ", but it is " + answer);
}

void expect_measure(Session& session, const Measure& measure, const std::string& what,
                    Arguments& arguments) {
  const std::string sign = comparison(arguments);
  const double bound = arguments.number("a number");
  arguments.end();
  session.refresh();
  const double value = measure.value(session);
  if (!holds(sign, value <=> bound))
    throw ExpectationMissed("expected " + what + ", but it is " + short_number(value, 6));
}

}  // namespace

std::string comparison(Arguments& arguments) {
  return arguments.one_of({"=", "<", ">", "<=", ">="});
}

bool holds(std::string_view sign, std::partial_ordering compared) {
  if (sign == "=") return compared == 0;
  if (sign == "<") return compared < 0;
  if (sign == ">") return compared > 0;
  if (sign == "<=") return compared <= 0;
  return compared >= 0;
}

bool expect_other(Session& session, Arguments& arguments) {
  Arguments words = arguments, all = arguments;
  const std::string name = words.word("a quantity");
  const std::string what = all.rest("a quantity");
  for (const Question& each : questions) {
    if (each.name != name) continue;
    expect_answer(session, each, what, words);
    return true;
  }
  for (const Measure& each : measures) {
    if (each.name != name) continue;
    expect_measure(session, each, what, words);
    return true;
  }
  return false;
}

}  // namespace aomd::scene
