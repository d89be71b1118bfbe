#include <exception>
#include <new>

#include "core/io/error.h"
#include "viewer/app/options.h"
#include "viewer/app/window.h"
#include "viewer/commands/command_error.h"

namespace aomd::app {

int exit_code_of(const std::exception& error) {
  try {
    std::rethrow_if_nested(error);
  } catch (const std::exception& cause) {
    return exit_code_of(cause);
  }
  if (dynamic_cast<const WindowError*>(&error) != nullptr) return exit_limit;
  if (dynamic_cast<const scene::ExpectationMissed*>(&error) != nullptr) return exit_no;
  if (dynamic_cast<const scene::CommandError*>(&error) != nullptr) return exit_usage;
  if (dynamic_cast<const io::WriteError*>(&error) != nullptr) return exit_unwritten;
  if (dynamic_cast<const io::LimitError*>(&error) != nullptr) return exit_limit;
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return exit_limit;
  return exit_unreadable;
}

}  // namespace aomd::app
