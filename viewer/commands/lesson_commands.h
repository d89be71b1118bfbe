#pragma once
// What a lesson does to a session: its pages are made of commands.

#include <string>

#include "viewer/session/session.h"

namespace aomd::scene {

/// Opens a page: the commands of the pages up to it are carried out from a session without options,
/// whatever the user has done, so that it always begins in the same way. Its meshes are for
/// practice: changing them is no work that could be lost. Blocks while it is made; throws
/// CommandError naming the line that failed.
void open_lesson(Session& session, const Lesson& lesson, std::size_t page);
/// Loads one of the open lesson's meshes.
void load_lesson_mesh(Session& session, const std::string& name);
/// Carries out what does the page's task.
void solve_lesson(Session& session);
/// Looks whether the task is done, where something has happened since. Cheap. To be called after
/// Session::tick and Session::finish.
void update_lesson(Session& session);

}  // namespace aomd::scene
