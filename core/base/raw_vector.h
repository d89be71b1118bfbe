#pragma once
// Arrays that are about to be overwritten need no zeros first.

#include <memory>
#include <utility>
#include <vector>

#pragma GCC visibility push(default)

namespace aomd {

/// Leaves trivial elements uninitialised where std::allocator would write zeros.
template <typename T>
struct RawAllocator : std::allocator<T> {
  template <typename U>
  struct rebind {
    using other = RawAllocator<U>;
  };
  template <typename U, typename... Arguments>
  void construct(U* p, Arguments&&... arguments) {
    if constexpr (sizeof...(arguments) == 0)
      ::new (static_cast<void*>(p)) U;
    else
      ::new (static_cast<void*>(p)) U(std::forward<Arguments>(arguments)...);
  }
};

/// resize() leaves new elements uninitialised; assign() and resize(n, value) fill them.
template <typename T>
using RawVector = std::vector<T, RawAllocator<T>>;

}  // namespace aomd

#pragma GCC visibility pop
