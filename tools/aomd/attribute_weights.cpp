#include "tools/aomd/attribute_weights.h"

#include <algorithm>
#include <optional>

#include "core/base/text.h"
#include "tools/aomd/command.h"
#include "tools/aomd/values.h"

namespace aomd::cli {
namespace {

constexpr double heaviest = 1e6;

/// The names of the arrays that can count.
std::vector<std::string> countable(const MeshData& mesh) {
  std::vector<std::string> names;
  for (const Attribute& a : mesh.attributes)
    if (can_count(a, false)) names.push_back(a.name);
  for (const Attribute& a : mesh.corners)
    if (can_count(a, true)) names.push_back(a.name);
  return names;
}

std::string list_of(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + printable(name);
  return text.empty() ? "none" : text;
}

/// What a name alone says: the weight that the array has anyway, else 1.
ArrayWeight usual_or_1(const std::string& name, const std::vector<ArrayWeight>& usual) {
  const auto same = std::find_if(usual.begin(), usual.end(),
                                 [&](const ArrayWeight& w) { return w.name == name; });
  return same == usual.end() ? ArrayWeight{name, 1} : *same;
}

ArrayWeight parsed(const std::string& word, const std::vector<std::string>& names,
                   const std::vector<ArrayWeight>& usual) {
  const auto known = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  const std::size_t equals = word.rfind('=');
  ArrayWeight result = usual_or_1(word, usual);
  if (!known(word) && equals != std::string::npos) {
    const auto weight = parse_number(word.substr(equals + 1));
    if (!weight || !(*weight >= 0 && *weight <= heaviest))
      throw UsageError("--attributes: a weight must be between 0 and 1000000, not " +
                       printable(word.substr(equals + 1)));
    result = {word.substr(0, equals), *weight};
  }
  if (!known(result.name))
    throw UsageError("--attributes: no array on vertices or corners that could count is named " +
                     printable(result.name) + "; there are: " + list_of(names));
  return result;
}

}  // namespace

std::vector<ArrayWeight> attribute_weights(const MeshData& mesh,
                                           const std::vector<std::string>& words) {
  const std::vector<ArrayWeight> usual = usual_weights(mesh);
  std::vector<ArrayWeight> weights = usual;
  const std::vector<std::string> names = countable(mesh);
  for (const std::string& word : words) {
    if (word == "none") {
      weights.clear();
      continue;
    }
    const ArrayWeight given = parsed(word, names, usual);
    const auto same = std::find_if(weights.begin(), weights.end(),
                                   [&](const ArrayWeight& w) { return w.name == given.name; });
    if (same == weights.end())
      weights.push_back(given);
    else
      same->weight = given.weight;
  }
  return weights;
}

}  // namespace aomd::cli
