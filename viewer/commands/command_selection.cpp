// What is selected and pointed at.

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "viewer/base/text.h"
#include "viewer/commands/command_groups.h"
#include "viewer/drawing/selection_drawing.h"

namespace aomd::scene {
namespace {

/// With the way to what is known of it, where that is not on the screen.
void say(Session& session) {
  session.status = "Selected: " + selection_text(session.sheet().selection);
  const Panels& panels = session.view.panels;
  if (session.sheet().selection.single().valid() &&
      !(panels.side && panels.page == Page::Selection))
    session.status += ". P tells about it, and why it stays";
}

// Edges and faces that a volume's file does not list are entities once it is prepared.
EntityRef entity(Session& session, Arguments& arguments, int dim) {
  const long long id = arguments.integer("an id");
  const EntityRef e(dim, static_cast<std::uint32_t>(id));
  const Mesh& mesh = session.document().mesh();
  const auto is_there = [&] { return id >= 0 && id < mesh.capacity(dim) && mesh.alive(e); };
  if (!is_there() && (dim == 1 || dim == 2)) session.document().prepare();
  if (!is_there())
    arguments.fail("there is no " + std::string(entity_name(dim)) + " " + std::to_string(id));
  return e;
}

glm::dvec2 place(Arguments& arguments) {
  const double x = arguments.number("a place from left (-1) to right (1)", -1, 1);
  return {x, arguments.number("a place from bottom (-1) to top (1)", -1, 1)};
}

void select_box(Session& session, Arguments& arguments) {
  const glm::dvec2 low = place(arguments), high = place(arguments);
  const bool adds = !arguments.done();
  if (adds && arguments.word("add") != "add") arguments.fail("only 'add' may follow the box");
  arguments.end();
  const std::vector<EntityRef> found = session.pick(low, high);
  adds ? session.sheet().selection.add(found) : session.sheet().selection.replace(found);
}

void select_class(Session& session, Arguments& arguments) {
  const ModelRef ref = arguments.model_entity();
  arguments.end();
  const auto ids = session.document().mesh().class_lists()->entities(ref.dimension(), ref);
  std::vector<EntityRef> entities;
  for (const std::uint32_t id : ids) entities.emplace_back(ref.dimension(), id);
  session.sheet().selection.replace(std::move(entities));
}

void select_refused(Session& session, Arguments& arguments) {
  const std::string word = arguments.word("a reason");
  arguments.end();
  need_decimable(session);
  std::string names;
  for (int i = 0; i < reason_count; ++i) {
    const auto reason = static_cast<Reason>(i);
    if (word == reason_word(reason))
      return session.sheet().selection.replace(find_edges_refused_for(session.document(), reason));
    names += (i == 0 ? "" : ", ") + reason_word(reason);
  }
  arguments.fail("'" + word + "' is none of " + names);
}

void select_bar(Session& session, Arguments& arguments) {
  const MarkedBar bar = bar_of_histogram(arguments);
  if (session.document().running()) arguments.fail("nothing is counted before the run has ended");
  session.sheet().selection.replace(session.sheet().measure_counted_in(bar));
}

void select(Session& session, Arguments& arguments) {
  need_mesh(session);
  Arguments again = arguments;
  const std::string word = arguments.word("what to select");
  Selection& selection = session.sheet().selection;
  if (word == "none") {
    arguments.end();
    selection.clear();
  } else if (word == "add" || word == "remove") {
    const auto entities = listed_entities(session, arguments);
    word == "add" ? selection.add(entities) : selection.remove(entities);
  } else if (word == "box") {
    select_box(session, arguments);
  } else if (word == "class") {
    select_class(session, arguments);
  } else if (word == "refused") {
    select_refused(session, arguments);
  } else if (word == "bar") {
    select_bar(session, arguments);
  } else if (word == "grow") {
    arguments.end();
    session.refresh();
    selection.replace(grown(session.document().mesh(), selection));
  } else {
    selection.replace(listed_entities(session, again));
  }
  say(session);
}

/// Where colours say that an edge is refused, a click asks why.
void open_reason(Session& session, EntityRef picked) {
  if (session.view.coloring != Coloring::Verdict || picked.dimension != 1 || !picked.valid())
    return;
  session.view.panels.side = true;
  session.view.panels.page = Page::Selection;
}

void pick(Session& session, Arguments& arguments) {
  const glm::dvec2 at = place(arguments);
  const bool adds = !arguments.done();
  if (adds && arguments.word("add") != "add") arguments.fail("only 'add' may follow the place");
  arguments.end();
  need_mesh(session);
  const EntityRef found = session.pick(at);
  if (found.valid() && adds) session.sheet().selection.toggle(found);
  if (!adds)
    session.sheet().selection.replace(found.valid() ? std::vector{found}
                                                    : std::vector<EntityRef>());
  if (!adds) open_reason(session, found);
  say(session);
}

/// As file managers do: what is selected already is what the menu is for, with all the rest.
void menu(Session& session, Arguments& arguments) {
  constexpr std::array<std::pair<std::string_view, const char*>, 5> bar = {
      {{"off", ""}, {"file", "File"}, {"edit", "Edit"}, {"view", "View"}, {"help", "Help"}}};
  Arguments again = arguments;
  const std::string word = again.done() ? "" : again.word("a place, off or the name of a menu");
  const auto named =
      std::find_if(bar.begin(), bar.end(), [&](const auto& each) { return each.first == word; });
  if (named != bar.end()) {
    again.end();
    session.view.menu.reset();
    session.view.bar_menu = named->second;
    return;
  }
  const glm::dvec2 at = place(arguments);
  arguments.end();
  need_mesh(session);
  const EntityRef found = session.pick(at);
  if (found.valid() && !session.sheet().selection.contains(found))
    session.sheet().selection.replace({found});
  session.view.menu = at;
  say(session);
}

void pick_level(Session& session, Arguments& arguments) {
  constexpr std::array<std::pair<std::string_view, PickLevel>, 5> levels = {
      {{"automatic", PickLevel::Automatic},
       {"vertex", PickLevel::Vertex},
       {"edge", PickLevel::Edge},
       {"face", PickLevel::Face},
       {"region", PickLevel::Region}}};
  session.view.pick_level = arguments.choice(levels);
  arguments.end();
}

void hover(Session& session, Arguments& arguments) {
  need_mesh(session);
  Arguments again = arguments;
  if (!again.done() && again.word("off") == "off") {
    again.end();
    session.hover({});
    return;
  }
  const glm::dvec2 at = place(arguments);
  arguments.end();
  session.hover(at);
}

void labels(Session& session, Arguments& arguments) {
  Arguments again = arguments;
  session.view.labels_everywhere = !again.done() && again.word("on, off, toggle or all") == "all";
  if (session.view.labels_everywhere) {
    session.view.labels = true;
    return again.end();
  }
  session.view.labels = arguments.flag(session.view.labels);
  arguments.end();
}

void preview(Session& session, Arguments& arguments) {
  constexpr std::array<std::string_view, 4> ways = {"best", "1", "2", "swap"};
  const std::string word = arguments.one_of({"on", "off", "best", "1", "2", "swap"});
  arguments.end();
  session.view.preview = word != "off";
  if (const auto way = std::find(ways.begin(), ways.end(), word); way != ways.end())
    session.view.previewed = static_cast<PreviewedWay>(way - ways.begin());
}

void why(Session& session, Arguments& arguments) {
  arguments.end();
  need_mesh(session);
  session.refresh();
  if (!session.sheet().inquiry().facts()) arguments.fail("select one entity first");
  session.log =
      entity_facts_text(*session.sheet().inquiry().facts(), session.sheet().inquiry().verdict());
}

}  // namespace

std::vector<EntityRef> listed_entities(Session& session, Arguments& arguments) {
  const int dim = arguments.level();
  std::vector<EntityRef> entities;
  do entities.push_back(entity(session, arguments, dim));
  while (!arguments.done());
  return entities;
}

std::vector<Command> selection_commands() {
  return {
      {"select",
       "vertex|edge|face|region ID [ID...] | add|remove KIND ID [ID...] | none | grow | box X0 Y0 "
       "X1 Y1 "
       "[add] | class KIND:TAG | refused REASON | bar angle|length|valence VALUE",
       "Selects entities by their ids, or what can be seen in a box (-1..1), or what lies on a "
       "model entity; "
       "grow takes what touches them too, refused the edges that decimation would refuse now for a "
       "reason: "
       "spacing, classification, topology, flat, angle, quality, kept, shape, distance, "
       "intersection, inverted, overshoot, volume, or "
       "none; bar what the bar of a histogram counts that VALUE lies in. What is selected stays so "
       "while it "
       "lives.",
       CommandGroup::Selection,
       select,
       {{"Ctrl+G", "select grow"}}},
      {"pick",
       "X Y [add]",
       "Selects what lies at a place (-1..1), as a click does; add is a click with Shift, which "
       "also takes "
       "away. While colours show why edges are refused it takes edges, and opens the page that "
       "says why.",
       CommandGroup::Selection,
       pick,
       {}},
      {"menu",
       "X Y | file | edit | view | help | off",
       "Opens the menu of a right click at a place (-1..1): for what lies there, which is then "
       "selected, or "
       "for the selection that it is part of; or one of the menu bar.",
       CommandGroup::Selection,
       menu,
       {}},
      {"pick-level",
       "automatic|vertex|edge|face|region",
       "What a click takes; automatic is the vertex or edge that is near, else the face, else the "
       "region.",
       CommandGroup::Selection,
       pick_level,
       {}},
      {"hover",
       "X Y | off",
       "Points at a place (-1..1), as the mouse does.",
       CommandGroup::Selection,
       hover,
       {}},
      {"why",
       "",
       "Prints what is known of the selected entity: where it lies, what is adjacent, and why "
       "decimation "
       "leaves it.",
       CommandGroup::Selection,
       why,
       {}},
      {"preview",
       "on|off|best|1|2|swap",
       "Draws what collapsing the selected edge would lead to, or smoothing the selected vertex: "
       "the best "
       "way, or the first or second end. swap draws the faces that swapping the edge would make. "
       "Before both comes the best way of the edge that the mouse points at. Of an edge inside a "
       "volume that nothing cuts, through glass that ends there: blue goes, turquoise stretches, "
       "red decides.",
       CommandGroup::Selection,
       preview,
       {}},
      {"labels",
       "[on|off|toggle|all]",
       "Ids at what is selected and around what the mouse points at; all: at everything, on small "
       "surfaces.",
       CommandGroup::Selection,
       labels,
       {{"L", "labels toggle"}}},
  };
}

}  // namespace aomd::scene
