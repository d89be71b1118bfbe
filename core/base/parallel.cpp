#include "core/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace aomd {

int thread_count(int wanted) {
  return std::max(1, wanted > 0 ? wanted : static_cast<int>(std::thread::hardware_concurrency()));
}

// More pieces than threads, taken as they come: cores are not equally fast when others use them
// too.
void parallel_for(std::size_t count, int threads, std::size_t grain,
                  const std::function<void(std::size_t begin, std::size_t end)>& body) {
  constexpr std::size_t pieces_each = 8;
  const auto most = static_cast<std::size_t>(std::max(threads, 1));
  const std::size_t pieces = most == 1 ? 1 : std::min(count / grain, most * pieces_each);
  if (pieces <= 1) return count > 0 ? body(0, count) : void();
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex mutex;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < pieces; i = next++)
        body(count * i / pieces, count * (i + 1) / pieces);
    } catch (...) {
      const std::scoped_lock lock(mutex);
      failure = std::current_exception();
      next = pieces;
    }
  };
  {
    std::vector<std::jthread> others;
    others.reserve(most - 1);
    try {
      while (others.size() + 1 < std::min(most, pieces)) others.emplace_back(work);
    } catch (const std::system_error&) {  // the system has no more threads: fewer do it too
    }
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace aomd
