#pragma once
// The records of a journal, applied to a mesh in either direction.

#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/mesh.h"

namespace aomd {

/// Applies records to all levels of a mesh, or to some of a bare one.
class JournalReplay {
 public:
  explicit JournalReplay(Mesh& mesh) : mesh_(mesh) {}
  /// Passes over the records of other levels, and neither reads nor writes anything of theirs: each
  /// level can have a thread of its own. The mesh must be bare (Mesh::release_derived).
  JournalReplay(Mesh& bare, int first_level, int last_level)
      : mesh_(bare), first_(first_level), last_(last_level), bare_(true) {}

  /// The records of one step, which must follow, or be the last that led to, the state of these
  /// levels. O(records).
  void redo(std::span<const std::uint32_t> records);
  void undo(std::span<const std::uint32_t> records);

 private:
  [[nodiscard]] bool mine(int level) const { return first_ <= level && level <= last_; }
  void apply(const std::uint32_t* record, bool forward);
  void create(const std::uint32_t* record);
  void destroy(const std::uint32_t* record);
  void rebind(const std::uint32_t* record, bool forward);

  Mesh& mesh_;
  int first_ = 0, last_ = 3;
  bool bare_ = false;
  // Scratch
  std::vector<const std::uint32_t*> records_;
  std::vector<Rebinding> rebindings_;
};

}  // namespace aomd
