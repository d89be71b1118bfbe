#pragma once
// The options of a decimation: keyword arguments, in the words of the command line.

#include <memory>
#include <string>
#include <vector>

#include "tools/aomd/decimate_options.h"
#include "tools/python/binding.h"

namespace aomd::python {

/// What the command line would make of these words ("--factor=4"), and arrays beside them.
class ToldOptions {
 public:
  /// For a mesh of so many vertices. `keep` holds those that stay, `spacing` a length for each;
  /// either may be None. Throws UsageError as the command line would.
  ToldOptions(const std::vector<std::string>& words, const py::object& keep,
              const py::object& spacing, std::size_t vertices);
  ToldOptions(const ToldOptions&) = delete;
  ToldOptions& operator=(const ToldOptions&) = delete;

  [[nodiscard]] const cli::DecimateOptions& options() const { return options_; }
  /// All that the library is told of a mesh that is there.
  [[nodiscard]] DecimationOptions for_mesh(const Mesh& mesh, double diagonal) const;

 private:
  void take_keep(const py::object& keep, std::size_t vertices);
  void take_spacing(const py::object& spacing, std::size_t vertices);

  CLI::App app_;  ///< the options ask it what was given
  cli::DecimateOptions options_;
};

}  // namespace aomd::python
