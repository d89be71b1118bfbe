#pragma once
// Assertions about our own mistakes. AOMD_CHECK is cheap and on in every build; AOMD_DEBUG_CHECK
// may be slow and is on in debug and sanitizer builds.

namespace aomd {

/// Prints the failed condition and its place, then aborts.
[[noreturn]] void check_failed(const char* condition, const char* file, int line);

}  // namespace aomd

#define AOMD_CHECK(condition) \
  (static_cast<bool>(condition) ? void(0) : ::aomd::check_failed(#condition, __FILE__, __LINE__))

#ifdef NDEBUG
#define AOMD_DEBUG_CHECK(condition) void(0)
#else
#define AOMD_DEBUG_CHECK(condition) AOMD_CHECK(condition)
#endif
