#pragma once
// Loops over independent items on several threads.

#include <cstddef>
#include <functional>

namespace aomd {

/// The number of threads that a user means: 0 stands for all cores. At least 1.
[[nodiscard]] int thread_count(int wanted);

/// Calls body(begin, end) for pieces that cover [0, count) once, on at most so many threads, the
/// caller's among them. A piece has at least `grain` items: give as many as take some tenths of a
/// millisecond, since starting a thread takes one tenth; with no more than that, or one thread, all
/// is one piece and the caller's. Where the pieces begin and who takes them is open, so the result
/// does not depend on the number of threads exactly if each item writes to places of its own and
/// reads none of the others'. Rethrows an exception of a piece.
void parallel_for(std::size_t count, int threads, std::size_t grain,
                  const std::function<void(std::size_t begin, std::size_t end)>& body);

}  // namespace aomd
