#pragma once
// A session without a window, driven as scripts drive it.

#include <initializer_list>
#include <string_view>

#include "viewer/scene/commands.h"
#include "viewer/scene/session.h"

namespace aomd::scene::test {

/// Carries out each line and waits until it has come to its end.
inline void drive(Session& session, std::initializer_list<std::string_view> lines) {
  for (const std::string_view line : lines) {
    execute(session, line);
    session.finish();
    session.refresh();
  }
}

}  // namespace aomd::scene::test
