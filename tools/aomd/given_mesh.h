#pragma once
// The mesh that a decimation is given.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/blocks/exchange.h"
#include "core/decimate/original_samples.h"
#include "core/mesh/mesh_data.h"
#include "tools/aomd/decimate_options.h"
#include "tools/aomd/decimate_report.h"
#include "tools/aomd/progress.h"

namespace aomd::cli {

/// From a file, from blocks of one, or in the memory of another program, which stays what it is.
class GivenMesh {
 public:
  using Notes = std::vector<std::string>;

  explicit GivenMesh(const DecimateOptions& options) : options_(options) {}
  GivenMesh(const GivenMesh&) = delete;
  GivenMesh& operator=(const GivenMesh&) = delete;

  /// Reads the input; of an exchange as the first process.
  Notes read(Exchange& exchange, Progress& progress);
  void take(const MeshData& of_another) { mesh_ = &of_another; }

  [[nodiscard]] const MeshData& mesh() const { return *mesh_; }
  /// The same to be changed: what another program holds is copied first.
  [[nodiscard]] MeshData& own();
  [[nodiscard]] bool is_volume() const { return !mesh().regions.empty(); }
  /// Where it was read in blocks: what the file has, ...
  [[nodiscard]] const std::optional<InBlocks>& in_blocks() const { return in_blocks_; }
  /// ... and what the mesh still knows of it, once, for the first decimation.
  [[nodiscard]] std::shared_ptr<const OriginalSamples> take_samples() {
    return std::move(samples_);
  }

  /// Lets the vertices of the regions go, a fifth of what a decimation takes, unless they are asked
  /// for later or cannot be read again.
  void forget_regions();
  /// They are there again.
  void recall_regions();
  /// The mesh with its regions.
  [[nodiscard]] MeshData whole() const;

 private:
  Notes read_blocks(Exchange& exchange, Progress& progress);
  [[nodiscard]] bool can_be_read_again() const;
  [[nodiscard]] bool data_need_regions() const;

  const DecimateOptions& options_;
  MeshData own_;  ///< as read, or as repaired
  const MeshData* mesh_ = &own_;
  std::optional<InBlocks> in_blocks_;
  std::shared_ptr<const OriginalSamples> samples_;
  bool from_file_ = false;
  bool forgotten_ = false;  ///< the vertices of the regions of `own_`
};

}  // namespace aomd::cli
