#include "core/base/assertion.h"

#include <cstdio>
#include <cstdlib>

namespace aomd {

void check_failed(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "aomd: internal error at %s:%d: %s\n", file, line, condition);
  std::abort();
}

}  // namespace aomd
