// Carries out commands of the viewer in a session of its own, without a window.

#include <exception>
#include <iostream>

#include "viewer/commands/command_error.h"
#include "viewer/commands/commands.h"
#include "viewer/session/session.h"

int main() try {
  aomd::scene::Session session;
  for (const char* line : {"sample sphere 12", "target-faces 50%", "run", "expect faces = 1440"}) {
    aomd::scene::execute(session, line);
    session.finish();
  }
  return 0;
} catch (const std::exception& e) {
  std::cerr << e.what() << '\n';
  return 1;
}
