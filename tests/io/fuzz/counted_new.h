#pragma once
// Counts what the program allocates through operator new, which fuzz/counted_new.cpp replaces.

#include <atomic>
#include <cstddef>

namespace aomd::test {

extern std::atomic<std::size_t> live_bytes;
extern std::atomic<std::size_t> peak_bytes;   ///< the most since it was last set
extern std::atomic<std::size_t> total_bytes;  ///< all ever asked for: a measure of work

}  // namespace aomd::test
