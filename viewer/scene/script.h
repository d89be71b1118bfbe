#pragma once
// A script: commands from a file, one a line.

#include <filesystem>
#include <string>
#include <vector>

#include "viewer/scene/session.h"

namespace aomd::scene {

/// A script's line that failed; what() is "FILE:LINE: why". The cause is nested.
class ScriptError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Script {
 public:
  Script() = default;
  /// Throws io::ReadError.
  explicit Script(const std::filesystem::path& file);

  [[nodiscard]] bool done() const { return next_ >= lines_.size(); }
  /// Carries out the next line once the session is idle, or asks for pictures that are not taken
  /// yet; `cancel`, `pause` and `log` do not wait. Returns false where it had to wait. Throws
  /// ScriptError.
  bool advance(Session& session);
  /// To be called while what the last line started has thrown: throws ScriptError with that nested.
  [[noreturn]] void fail() const;

 private:
  std::string name_;
  std::vector<std::string> lines_;
  std::size_t next_ = 0;
};

}  // namespace aomd::scene
