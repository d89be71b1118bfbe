#include "viewer/app/named_files.h"

#include <map>
#include <optional>

#include "core/io/output_target.h"

namespace aomd::app {
namespace {

std::optional<std::string> identity_of(const NamedFile& file) {
  return file.path.empty() ? std::nullopt : io::detail::output_identity(file.path);
}

}  // namespace

std::string clash_of_files(const std::vector<NamedFile>& read,
                           const std::vector<NamedFile>& written) {
  std::map<std::string, std::string> option_of;  // by what tells one file from another
  for (const NamedFile& each : read)
    if (const auto identity = identity_of(each)) option_of.emplace(*identity, each.option);
  for (const NamedFile& each : written) {
    const auto identity = identity_of(each);
    if (!identity) continue;
    const auto [other, first] = option_of.emplace(*identity, each.option);
    if (!first)
      return other->second + " and " + each.option + " are one file, " + each.path.string();
  }
  return {};
}

}  // namespace aomd::app
