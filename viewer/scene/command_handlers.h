#pragma once
// What the rows of the command table call; one source file for each group.

#include "viewer/scene/arguments.h"
#include "viewer/scene/commands.h"
#include "viewer/scene/session.h"

namespace aomd::scene::handle {

// command_files.cpp
void open(Session& session, Arguments& arguments);
void sample(Session& session, Arguments& arguments);
void model(Session& session, Arguments& arguments);
void save(Session& session, Arguments& arguments);
void screenshot(Session& session, Arguments& arguments);
void quit(Session& session, Arguments& arguments);

// command_adjacency.cpp
void adjacency(Session& session, Arguments& arguments);
/// The rest of `expect adjacency I J = on|off`.
void expect_adjacency(Session& session, Arguments& arguments);

// command_options.cpp
void strategy(Session& session, Arguments& arguments);
void regularity(Session& session, Arguments& arguments);
void factor(Session& session, Arguments& arguments);
void coarsest(Session& session, Arguments& arguments);
void target_faces(Session& session, Arguments& arguments);
void spacing(Session& session, Arguments& arguments);
void angle(Session& session, Arguments& arguments);
void min_angle(Session& session, Arguments& arguments);
void feature_angle(Session& session, Arguments& arguments);
void topology(Session& session, Arguments& arguments);
void improve_passes(Session& session, Arguments& arguments);
void snap(Session& session, Arguments& arguments);

// command_edits.cpp
void step(Session& session, Arguments& arguments);
void sweep(Session& session, Arguments& arguments);
void swap(Session& session, Arguments& arguments);
void smooth(Session& session, Arguments& arguments);
void improve(Session& session, Arguments& arguments);
void run(Session& session, Arguments& arguments);
void cancel(Session& session, Arguments& arguments);

// command_history.cpp
void reset(Session& session, Arguments& arguments);
void undo(Session& session, Arguments& arguments);
void redo(Session& session, Arguments& arguments);
void seek(Session& session, Arguments& arguments);
void play(Session& session, Arguments& arguments);
void pause(Session& session, Arguments& arguments);

// command_views.cpp
void color(Session& session, Arguments& arguments);
void camera(Session& session, Arguments& arguments);
void fit(Session& session, Arguments& arguments);
void orbit(Session& session, Arguments& arguments);
void pan(Session& session, Arguments& arguments);
void zoom(Session& session, Arguments& arguments);
void show(Session& session, Arguments& arguments);
void highlight(Session& session, Arguments& arguments);
void hide(Session& session, Arguments& arguments);
void theme(Session& session, Arguments& arguments);
void panel(Session& session, Arguments& arguments);
void dialog(Session& session, Arguments& arguments);
void dismiss(Session& session, Arguments& arguments);

// command_scripts.cpp
void expect(Session& session, Arguments& arguments);
void wait_idle(Session& session, Arguments& arguments);
void log(Session& session, Arguments& arguments);

/// A file as a line names it: ~/ is the user's own folder.
[[nodiscard]] std::filesystem::path expanded(const std::string& text);
/// Throws CommandError where there is no mesh yet.
void need_mesh(const Session& session);
/// The same, and for a mesh that cannot be decimated.
void need_decimable(const Session& session);

}  // namespace aomd::scene::handle
