#pragma once
// What the commands say of arrays: what they are, and what became of them.

#include <iosfwd>
#include <vector>

#include "core/fields/carry.h"
#include "tools/aomd/report.h"

namespace aomd::cli {

/// "fields" of a report: each array that went along, before and after.
[[nodiscard]] Json fields_json(const std::vector<fields::CarriedField>& list);

/// A line for each, 20 at most: its range and its integral before and after, of vectors by
/// component in JSON alone.
void print_fields(std::ostream& out, const std::vector<fields::CarriedField>& list);

}  // namespace aomd::cli
