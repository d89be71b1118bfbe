#pragma once
// What commands have set for operations to come. There is one copy of it, which outlives documents.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "core/decimate/options.h"
#include "core/model/classify.h"

namespace aomd::scene {

class DocumentOptions {
 public:
  [[nodiscard]] const DecimationOptions& decimation() const { return decimation_; }
  /// Grows with each change of decimation(): whoever keeps what follows from it keeps this number.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  void set(const DecimationOptions& options) {
    if (options == decimation_) return;
    decimation_ = options;
    ++revision_;
  }
  /// Wanted lengths at the vertices of the present mesh, and what they come from.
  void set_spacing(std::shared_ptr<const Column<Vertex, double>> lengths, std::string source) {
    decimation_.spacing = std::move(lengths);
    spacing_source_ = std::move(source);
    ++revision_;
  }
  /// A file, a formula, "curvature" or "surface"; empty where lengths are not set.
  [[nodiscard]] std::string_view spacing_source() const {
    return decimation_.spacing ? std::string_view(spacing_source_) : std::string_view();
  }
  /// What is in the units of a mesh, or by its vertices, goes with it.
  void let_go_of_mesh() {
    DecimationOptions rest = decimation_;
    rest.spacing.reset();
    rest.max_distance = 0;
    set(rest);
  }

  ClassifyOptions classify;  ///< of the next mesh, or the next classification
  bool snaps = false;        ///< smoothing keeps vertices on the model

 private:
  DecimationOptions decimation_;
  std::uint64_t revision_ = 1;
  std::string spacing_source_;
};

}  // namespace aomd::scene
