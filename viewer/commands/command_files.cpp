#include <algorithm>
#include <cstdlib>
#include <utility>

#include "core/base/text.h"
#include "core/io/io.h"
#include "core/samples/samples.h"
#include "viewer/base/text.h"
#include "viewer/commands/command_groups.h"
#include "viewer/document/whole_data.h"

namespace aomd::scene {
namespace {

void open(Session& session, Arguments& arguments) {
  LoadRequest request;
  request.file = expanded(arguments.rest("a file"));
  request.classify = session.document().classify_options();
  session.view.dialog = Dialog::None;
  session.start_loading(std::move(request));
}

void sample(Session& session, Arguments& arguments) {
  LoadRequest request;
  request.sample = arguments.word("a sample's name");
  if (!arguments.done())
    request.sample_size = static_cast<int>(arguments.integer("a size", 0, 1'000'000'000));
  arguments.end();
  const auto known = samples();
  if (std::none_of(known.begin(), known.end(),
                   [&](const SampleInfo& s) { return s.name == request.sample; })) {
    std::string names;
    for (const SampleInfo& each : known)
      names += (names.empty() ? "" : ", ") + std::string(each.name);
    arguments.fail("there is no sample '" + request.sample + "', but " + names);
  }
  request.classify = session.document().classify_options();
  session.start_loading(std::move(request));
}

bool read_from_file(const Session& session) {
  return !session.document().empty() && !session.document().content().file.empty();
}

/// A key: where there is nothing to read a word is enough.
void reload(Session& session, Arguments& arguments) {
  arguments.end();
  if (!read_from_file(session)) {
    session.status = "The present mesh was not read from a file";
    return;
  }
  LoadRequest request;
  request.file = session.document().content().file;
  request.classify = session.document().classify_options();
  session.view.dialog = Dialog::None;
  session.start_loading(std::move(request));
}

void watch(Session& session, Arguments& arguments) {
  const bool on = arguments.flag(session.watching());
  arguments.end();
  if (on && !read_from_file(session))
    throw CommandError("the present mesh was not read from a file");
  session.watch(on);
  session.status = on ? "Watching " + session.document().content().name : "Not watching";
}

void model(Session& session, Arguments& arguments) {
  const std::string file = arguments.rest("a CAD file, or none");
  if (file == "none") {
    session.document().drop_model();
    session.status = "No model";
    return;
  }
  need_mesh(session);
  session.play(false);
  session.document().set_model(expanded(file));
  const GivenModel& given = *session.document().model();
  session.status = "Model " + given.file.filename().string() + ": " + counts_text(given.counts);
}

void save(Session& session, Arguments& arguments) {
  need_mesh(session);
  const std::filesystem::path file = expanded(arguments.rest("a file"));
  const WholeData whole = whole_data(session.document());
  const std::vector<std::string> notes = io::write(file, whole.data);
  session.document().mark_saved(file);
  session.note_written(file);
  session.view.dialog = Dialog::None;
  session.status = "Saved " + printable(file.string());
  for (const std::string& note : whole.notes) session.status += "; " + note;
  for (const std::string& note : notes) session.status += ", " + note;
  // The question about unsaved work, if there was one, is answered.
  if (!session.asked.empty()) session.next_line = std::exchange(session.asked, {});
}

void quit(Session& session, Arguments& arguments) {
  arguments.end();
  session.quit = true;
}

}  // namespace

std::filesystem::path expanded(const std::string& text) {
  const char* home = std::getenv("HOME");
  if (home != nullptr && text.rfind("~/", 0) == 0)
    return std::filesystem::path(home) / text.substr(2);
  return text;
}

void need_mesh(const Session& session) {
  if (session.document().empty())
    throw CommandError("there is no mesh yet: open a file or a sample first");
}

void need_decimable(const Session& session) {
  need_mesh(session);
  if (const std::string_view why = session.document().hindrance(); !why.empty())
    throw CommandError(std::string(why));
}

std::vector<Command> file_commands() {
  return {
      {"open",
       "FILE",
       "Reads a mesh; the present one stays until the new one is ready.",
       CommandGroup::File,
       open,
       {{"Ctrl+O", "dialog open"}}},
      {"reload",
       "",
       "Reads the file of the present mesh again. The camera stays, as whenever a file is opened "
       "that was shown before; so do clipping, shrinking and what is hidden.",
       CommandGroup::File,
       reload,
       {{"F5", "reload"}}},
      {"watch",
       "[on|off|toggle]",
       "In a window: reads the file of the present mesh again whenever it changes on disk. Where "
       "that would lose unsaved work it says so instead.",
       CommandGroup::File,
       watch,
       {}},
      {"sample",
       "NAME [SIZE]",
       "Makes one of the built-in meshes.",
       CommandGroup::File,
       sample,
       {}},
      {"model",
       "FILE|none",
       "Reads the CAD model that the present mesh lies on, with Gmsh: .step, .stp, .brep, .iges, "
       ".igs or "
       ".geo. A mesh whose file does not say on what it lies is classified on it. Another mesh "
       "drops it.",
       CommandGroup::File,
       model,
       {}},
      {"save",
       "FILE",
       "Writes the mesh with its classification; the extension chooses the format.",
       CommandGroup::File,
       save,
       {{"Ctrl+S", "dialog save"}}},
      {"quit", "", "Ends the program.", CommandGroup::File, quit, {{"Ctrl+Q", "quit"}}},
  };
}

}  // namespace aomd::scene
