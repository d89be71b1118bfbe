// Named places of the history, and other ways on from it.

#include <string>

#include "viewer/base/text.h"
#include "viewer/commands/command_groups.h"
#include "viewer/document/history_places.h"

namespace aomd::scene {
namespace {

std::string free_name(const HistoryTree& tree) {
  std::size_t n = tree.bookmarks().size() + 1;
  while (tree.find_bookmark("Place " + std::to_string(n)) != nullptr) ++n;
  return "Place " + std::to_string(n);
}

void bookmark(Session& session, Arguments& arguments) {
  need_mesh(session);
  Document& document = session.document();
  Arguments again = arguments;
  if (!again.done() && again.word("a name") == "remove" && !again.done()) {
    const std::string name = again.rest("a bookmark's name");
    if (!document.remove_bookmark(name)) arguments.fail("there is no bookmark '" + name + "'");
    session.status = "Bookmark " + name + " is removed";
    return;
  }
  const std::string name = arguments.done() ? free_name(document.tree()) : arguments.rest("a name");
  document.set_bookmark(name);
  session.status = "Bookmark " + name + ": operation " + grouped(document.journal().cursor());
}

unsigned number_of(const HistoryTree& tree, Arguments& arguments) {
  const long long id = arguments.integer("a branch's number");
  arguments.end();
  const bool known = id > 0 && id < 1'000'000'000 &&
                     (id == tree.present() || tree.find(static_cast<unsigned>(id)) != nullptr);
  if (!known) arguments.fail("there is no branch " + std::to_string(id));
  return static_cast<unsigned>(id);
}

std::string branch_list(const Document& document) {
  const HistoryTree& tree = document.tree();
  std::string text = "Branch " + std::to_string(tree.present()) +
                     " (the present one): " + counted(document.journal().size(), "operation");
  for (const HistoryBranch& b : tree.branches())
    text += "\nBranch " + std::to_string(b.id) + ": " + counted(b.size(), "operation") +
            ", leaves branch " + std::to_string(b.from == 0 ? tree.present() : b.from) +
            " at operation " + grouped(b.fork) + ", " + bytes_text(b.part.bytes());
  return text;
}

void branch(Session& session, Arguments& arguments) {
  need_mesh(session);
  Document& document = session.document();
  const std::string what = arguments.one_of({"list", "switch", "remove"});
  if (what == "list") {
    arguments.end();
    session.log = branch_list(document);
    session.status = counted(document.tree().branches().size(), "branch") +
                     " besides the present one, " + bytes_text(document.tree().bytes());
  } else if (what == "switch") {
    const unsigned id = number_of(document.tree(), arguments);
    session.play(false);
    document.switch_branch(id);
    session.status = "Branch " + std::to_string(id) + ": " + place_words(document.journal());
  } else {
    const unsigned id = number_of(document.tree(), arguments);
    if (id == document.tree().present()) arguments.fail("the present branch cannot be removed");
    const std::size_t removed = document.remove_branch(id);
    session.status = "Branch " + std::to_string(id) + " is removed" +
                     (removed > 1 ? ", and " + grouped(removed - 1) + " that left it" : "");
  }
}

}  // namespace

std::vector<Command> branch_commands() {
  return {
      {"bookmark",
       "[NAME] | remove NAME",
       "Gives the present place of the history a name, for seek bookmark NAME. It survives undo "
       "and stays "
       "with its branch.",
       CommandGroup::History,
       bookmark,
       {{"Ctrl+B", "bookmark"}}},
      {"branch",
       "list|switch N|remove N",
       "What was ahead where something new was done stays as a branch. switch goes back to where "
       "branch N "
       "leaves and forward to its end; remove forgets it with those that leave it; list prints "
       "all.",
       CommandGroup::History,
       branch,
       {}},
  };
}

}  // namespace aomd::scene
