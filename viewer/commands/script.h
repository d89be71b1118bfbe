#pragma once
// A script: commands from a file, one a line.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "viewer/session/session.h"

namespace aomd::scene {

/// A script's line that failed; what() is "FILE:LINE: why". The cause is nested.
class ScriptError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Script {
 public:
  Script() = default;
  /// Throws io::ReadError for what is no file or cannot be read to its end.
  explicit Script(const std::filesystem::path& file);

  /// Has lines carried out after all others; `place` is what errors in them begin with.
  void add(const std::string& place, const std::vector<std::string>& lines);

  [[nodiscard]] bool done() const { return next_ >= lines_.size(); }
  /// Has the next line carried out once the session is idle and the pictures that it asked for are
  /// taken; `cancel`, `pause` and `log` do not wait. Returns false where it had to wait. Throws
  /// ScriptError.
  bool advance(const Session& session, const std::function<void(const std::string&)>& carry_out);
  /// To be called while what the last line started has thrown: throws ScriptError with that nested.
  [[noreturn]] void fail() const;

 private:
  struct Line {
    std::string text;
    std::string place;  ///< "FILE:LINE"
  };

  std::vector<Line> lines_;
  std::size_t next_ = 0;
};

}  // namespace aomd::scene
