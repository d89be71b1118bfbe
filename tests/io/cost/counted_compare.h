#pragma once
// Counts the steps of comparing and searching bytes, which cost/counted_compare.cpp replaces: what
// looks names up one by one shows in them, whatever the machine.

#include <cstddef>

namespace aomd::test {

/// Calls of memcmp, and bytes that memchr went over, since it was last set.
extern std::size_t compare_steps;

}  // namespace aomd::test
