#pragma once
// What the commands come to for meshes that are in memory: for whoever calls them from within
// another program. Errors are the exceptions that main.cpp turns into exit codes; numbers come as
// the JSON that the command prints.

#include <functional>
#include <string>
#include <vector>

#include "core/mesh/mesh_data.h"
#include "core/repair/repair.h"
#include "tools/aomd/compare_arguments.h"
#include "tools/aomd/decimate_options.h"
#include "tools/aomd/progress.h"
#include "tools/aomd/report.h"

namespace aomd::cli {

/// Who is told what while a command works, on the thread that called it. Both must be set.
struct Listener {
  std::function<void(const std::string&)> note;
  ProgressListener progress;
};

/// What a decimation made: the mesh that `aomd decimate` would write, and its report. JSON moves
/// without throwing. NOLINTNEXTLINE(bugprone-exception-escape)
struct Decimated {
  MeshData mesh;
  Json report;
  std::string missed;  ///< why the target was, by more than 1 percent; empty where it was not
};

/// `aomd decimate` between reading and writing. Writes what --journal and --report ask for; the
/// names of input and output stand in messages alone. The mesh is looked at where it is, and must
/// stay what it is until the end.
[[nodiscard]] Decimated decimate(const DecimateOptions& options, const MeshData& mesh,
                                 const Listener& listener);

/// `aomd info`.
[[nodiscard]] Json info(const std::string& name, const MeshData& mesh);

/// `aomd check`; `required` are words that --require takes.
[[nodiscard]] Json check(const std::string& name, const MeshData& mesh, bool unused,
                         const std::vector<std::string>& required);

/// `aomd compare`: of volumes where both have regions. "objections" says what is beyond the limits.
[[nodiscard]] Json compare(const CompareArguments& options, const MeshData& original,
                           const MeshData& result);

}  // namespace aomd::cli
