#pragma once
// States of the mesh that are kept to be compared: what finished runs came to, and what the user
// keeps.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/decimate/options.h"
#include "core/mesh/column.h"
#include "core/mesh/mesh_data.h"
#include "viewer/document/document.h"
#include "viewer/document/run_measurement.h"

namespace aomd::scene {

/// One state. Its place in the history is that of its number in HistoryTree, as long as its branch
/// is there.
struct KeptRun {
  unsigned number = 0;   ///< in the order in which they were kept, from 1; 0: the mesh as loaded
  std::string name;      ///< "Run 1"
  std::string from;      ///< where it began: "Run 1", "operation 12"; empty: at the mesh as loaded
  std::string strategy;  ///< "paper"; this and the next two are empty for the mesh as loaded
  std::string aim;       ///< "factor 4"
  std::optional<double> angle_deg;
  std::int64_t cells = 0;               ///< faces, of a volume regions
  double worst_angle_deg = 0;           ///< the smallest in any face, of a volume between two faces
  double mean_angle_deg = 0;            ///< of the smallest of each face or region
  std::optional<double> seconds;        ///< that the run took; none for what was kept by hand
  std::optional<RunDistance> distance;  ///< none: not measured
  std::shared_ptr<const MeshData> data;
  std::shared_ptr<const std::vector<Vertex>>
      vertices;  ///< which vertex of the document each of data's is
};

/// "factor 4", "3,000 faces", "coarsest", "spacing curvature"
[[nodiscard]] std::string aim_words(const Document& document);

/// Of one document: a copy of its mesh each, about 50 bytes a face.
class KeptRuns {
 public:
  static constexpr std::size_t most = 32;  ///< the oldest makes way that is not the reference

  /// The mesh as it is now. `name` may be empty; what is kept already gets the new name. O(size).
  const KeptRun& keep(Document& document, const std::string& name, std::optional<double> seconds);
  /// A row for the mesh as loaded, which is then the first one. Nothing may run. O(size) once.
  void keep_original(Document& document);
  /// Null where there is none.
  [[nodiscard]] const KeptRun* find(unsigned number) const;
  /// The one that the document shows; null: none.
  [[nodiscard]] const KeptRun* shown(const Document& document) const;
  /// The reference is the mesh as loaded then, where it was this one.
  void remove(Document& document, unsigned number);
  void set_distance(unsigned number, const RunDistance& distance);

  /// What the present mesh is compared with, in pictures and histograms; null: the mesh as loaded.
  [[nodiscard]] const KeptRun* reference() const { return find_kept(reference_); }
  /// The number of one that is kept; 0: the mesh as loaded.
  void set_reference(unsigned number) { reference_ = number; }

  /// By ascending numbers.
  [[nodiscard]] const std::vector<KeptRun>& rows() const { return rows_; }
  /// How many there are without the mesh as loaded.
  [[nodiscard]] std::size_t size() const { return rows_.size() - (has_original() ? 1 : 0); }
  [[nodiscard]] bool has_original() const { return !rows_.empty() && rows_.front().number == 0; }

 private:
  [[nodiscard]] const KeptRun* at(const Document& document, std::size_t step) const;
  [[nodiscard]] std::string start_of_run(const Document& document) const;

  [[nodiscard]] const KeptRun* find_kept(unsigned number) const {
    return number == 0 ? nullptr : find(number);
  }
  void make_way(Document& document);

  std::vector<KeptRun> rows_;
  unsigned last_ = 0;
  unsigned reference_ = 0;
};

/// A line of titles and one a row; columns separated by tabs. `volume`: of regions.
[[nodiscard]] std::string runs_table(const KeptRuns& runs, bool volume);

}  // namespace aomd::scene
