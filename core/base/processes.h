#pragma once
// Work that several processes share: what ends one of them costs the piece that it was at.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace aomd {

/// What came of a piece of work: what it returned, or how the process ended that was at it.
struct Piece {
  std::string answer;
  std::string death;  ///< "signal 11", "exit code 3", "stopped", "not begun"; empty: it returned
};

/// How a work is shared.
struct Sharing {
  std::size_t jobs = 1;  ///< how many processes there are at a time
  /// Each piece has a process of its own. Else a process does one after the other.
  bool fresh = false;
  /// Is told of each piece as soon as it is done, in whichever order that is.
  std::function<void(std::size_t, const Piece&)> tell;
  /// A descriptor: once it can be read, no piece is begun any more, and those at work are let go.
  int stop = -1;
  /// What a process does that was let go, on a thread of its own: it must end the process. The same
  /// where this process is gone. Not set: such a process goes on to the end of its piece.
  std::function<void()> let_go;
};

/// Carries out `work(i)` for each i below `count` in other processes, and returns when all of them
/// have ended. This process must have no other thread that holds a lock. `work` must not throw.
/// Throws std::system_error where no process can be started.
[[nodiscard]] std::vector<Piece> share_among_processes(
    std::size_t count, const Sharing& how, const std::function<std::string(std::size_t)>& work);

}  // namespace aomd
