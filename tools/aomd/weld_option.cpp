#include "tools/aomd/weld_option.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/extent.h"
#include "tools/aomd/values.h"

namespace aomd::cli {
namespace {

bool in_percent(const std::string& text) { return !text.empty() && text.back() == '%'; }

std::optional<double> number_of(std::string text) {
  if (in_percent(text)) text.pop_back();
  return parse_number(text);
}

}  // namespace

void WeldOption::apply(RepairOptions& repair, const MeshData& mesh) const {
  if (!on()) return;
  const double value = number_of(text).value_or(0);
  repair.weld = true;
  repair.weld_tolerance = in_percent(text) ? value / 100 * diagonal_of(mesh) : value;
}

io::StreamedSurface::Weld WeldOption::for_tiles() const {
  if (!on()) return {};
  const double value = number_of(text).value_or(0);
  return in_percent(text) ? io::StreamedSurface::Weld{value / 100, true}
                          : io::StreamedSurface::Weld{value, false};
}

CLI::Option* add_weld(CLI::App& command, WeldOption& weld) {
  const auto check = [](const std::string& text) {
    const auto value = number_of(text);
    return value && *value >= 0 && std::isfinite(*value)
               ? std::string()
               : "must be a length or a share (0.01%), not " + text;
  };
  weld.option = command.add_option(
      "--weld", weld.text,
      "Joins vertices at the same position, and border vertices within a tolerance:\na length in "
      "the units of the mesh, or percent of the diagonal of its box");
  return weld.option->type_name("[TOL|P%]")->check(CLI::Validator(check, ""));
}

std::vector<std::string> arguments_of(int argc, char** argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  for (std::size_t i = 0; i < arguments.size(); ++i)
    if (arguments[i] == "--weld" && (i + 1 == arguments.size() || !number_of(arguments[i + 1])))
      arguments[i] = "--weld=0";
  std::reverse(arguments.begin(), arguments.end());
  return arguments;
}

}  // namespace aomd::cli
