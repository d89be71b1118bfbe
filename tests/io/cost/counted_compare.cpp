#include "tests/io/cost/counted_compare.h"

namespace aomd::test {

std::size_t compare_steps = 0;

}  // namespace aomd::test

using Byte = const unsigned char*;

extern "C" int memcmp(const void* a, const void* b, std::size_t n) {
  ++aomd::test::compare_steps;
  for (std::size_t i = 0; i < n; ++i) {
    const int difference = static_cast<Byte>(a)[i] - static_cast<Byte>(b)[i];
    if (difference != 0) return difference;
  }
  return 0;
}

extern "C" void* memchr(const void* bytes, int value, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) {
    ++aomd::test::compare_steps;
    if (static_cast<Byte>(bytes)[i] == static_cast<unsigned char>(value))
      return const_cast<void*>(static_cast<const void*>(static_cast<Byte>(bytes) + i));
  }
  return nullptr;
}
