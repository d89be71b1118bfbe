#pragma once
// Work that several processes share: what ends one of them costs the piece that it was at.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace aomd::app {

/// What came of a piece of work: what it returned, or how the process ended that was at it.
struct Piece {
  std::string answer;
  std::string death;  ///< "signal 11", "exit code 3"; empty: it returned
};

/// Carries out `work(i)` for each i below `count`, in `jobs` processes of which each does one piece
/// after the other. This process must have one thread. `work` must not throw. Throws
/// std::system_error where no process can be started.
[[nodiscard]] std::vector<Piece> share_among_processes(
    std::size_t count, std::size_t jobs, const std::function<std::string(std::size_t)>& work);

}  // namespace aomd::app
