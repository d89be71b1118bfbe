#pragma once
// --weld [TOL] of `aomd repair` and `aomd decimate`.

#include <string>
#include <vector>

#include "core/io/streamed_surface.h"
#include "core/repair/repair.h"
#include "tools/aomd/command.h"

namespace aomd::cli {

/// A tolerance as given: nothing, a length, or percent of the diagonal.
struct WeldOption {
  std::string text;
  CLI::Option* option = nullptr;

  /// Whether it was given, with a value or without.
  [[nodiscard]] bool on() const { return option != nullptr && option->count() > 0; }
  /// Welds with a tolerance in the units of the mesh.
  void apply(RepairOptions& repair, const MeshData& mesh) const;
  /// The same for tiles of a surface.
  [[nodiscard]] io::StreamedSurface::Weld for_tiles() const;
};

/// Adds --weld to the command.
CLI::Option* add_weld(CLI::App& command, WeldOption& weld);

/// The arguments of the program for CLI11, last one first. A --weld without a tolerance gets that
/// of 0: CLI11 would take whatever follows for its value.
[[nodiscard]] std::vector<std::string> arguments_of(int argc, char** argv);

}  // namespace aomd::cli
