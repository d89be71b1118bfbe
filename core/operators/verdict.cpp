#include "core/operators/verdict.h"

namespace aomd {

const char* reason_name(Reason reason) {
  constexpr const char* names[] = {"None", "Spacing", "Classification", "Topology",
                                   "Flat", "Angle",   "Quality"};
  return names[static_cast<int>(reason)];
}

}  // namespace aomd
