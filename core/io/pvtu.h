#pragma once
// PVTU: VTK's list of the .vtu files that a surface or a volume is cut into.

#include <filesystem>
#include <vector>

#include "core/io/source.h"

namespace aomd::io::detail {

/// The files that it names as pieces, in its order; relative names are beside it. Throws ReadError
/// with the line where it is no such list, has ghost cells, or names itself.
[[nodiscard]] std::vector<std::filesystem::path> pvtu_pieces(const Source& source);

}  // namespace aomd::io::detail
