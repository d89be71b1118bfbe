#include "tests/io/fuzz/counted_new.h"

#include <malloc.h>

#include <cstdlib>
#include <new>

namespace aomd::test {

std::atomic<std::size_t> live_bytes{0}, peak_bytes{0}, total_bytes{0};

}  // namespace aomd::test

using aomd::test::live_bytes;
using aomd::test::peak_bytes;
using aomd::test::total_bytes;

void* operator new(std::size_t size) {
  void* p = std::malloc(size);
  if (!p) throw std::bad_alloc();
  const std::size_t usable = malloc_usable_size(p), now = live_bytes += usable;
  total_bytes += usable;
  if (now > peak_bytes) peak_bytes = now;
  return p;
}

// std::stable_sort asks for its buffer this way.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  try {
    return ::operator new(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void operator delete(void* p) noexcept {
  if (p) live_bytes -= malloc_usable_size(p);
  std::free(p);
}

void operator delete(void* p, std::size_t) noexcept { operator delete(p); }
