#include "core/io/named_parts.h"

#include <algorithm>
#include <cstdlib>

#include "core/base/text.h"
#include "core/io/class_names.h"
#include "core/io/named_faces.h"

namespace aomd::io::detail {
namespace {

/// Smoothing groups have no names but numbers.
void use_numbers(Attribute& label) {
  for (double& x : label.values)
    x = std::strtod(label.names[static_cast<std::size_t>(x)].c_str(), nullptr);
  label.names.clear();
}

}  // namespace

void NamedParts::Names::enter(const std::string& name) {
  current_ = numbers_.try_emplace(name, static_cast<std::uint32_t>(names_.size())).first->second;
  if (current_ == names_.size()) names_.push_back(name);
}

void NamedParts::enter(Level level, const std::string& name) {
  names_[level].enter(name);
  part_known_ = false;
}

std::int32_t NamedParts::part() {
  if (part_known_) return part_;
  const Part part{names_[Groups].current(), names_[Objects].current(), names_[Materials].current(),
                  names_[Smoothing].current()};
  part_ = part_numbers_.try_emplace(part, static_cast<std::int32_t>(parts_.size())).first->second;
  if (static_cast<std::size_t>(part_) == parts_.size()) parts_.push_back(part);
  part_known_ = true;
  return part_;
}

void NamedParts::finish(ReadResult& result) const {
  add_labels(result.mesh);
  classify(result);
}

/// What faces are called, as arrays; groups that say no more than our classes are none.
void NamedParts::add_labels(MeshData& mesh) const {
  constexpr const char* words[] = {obj_group, obj_object, obj_material, obj_smoothing};
  for (const Level level : {Groups, Objects, Materials, Smoothing}) {
    std::vector<std::string> names;
    const std::vector<std::size_t> name_of_part = names_in_use(level, names);
    const bool says_nothing = std::all_of(names.begin(), names.end(), [&](const std::string& n) {
      return n.empty() || (level == Groups && class_of_name(n));
    });
    if (says_nothing) continue;
    Attribute label{words[level], 2, 1, true, {}};
    for (const ModelRef m : mesh.faces.classes)
      label.values.push_back(static_cast<double>(name_of_part[static_cast<std::size_t>(m.tag())]));
    label.names = std::move(names);
    if (level == Smoothing) use_numbers(label);
    mesh.attributes.push_back(std::move(label));
  }
}

void NamedParts::classify(ReadResult& result) const {
  constexpr const char* words[] = {"group", "object", "material"};
  for (const Level level : {Groups, Objects, Materials}) {
    std::vector<std::string> names;
    const std::vector<std::size_t> name_of_part = names_in_use(level, names);
    const std::vector<ModelRef> classes = classes_of_parts(names);
    const bool useful =
        std::any_of(classes.begin(), classes.end(), [](ModelRef m) { return m.valid(); });
    if (!useful && level != Materials) continue;
    for (ModelRef& m : result.mesh.faces.classes)
      m = classes[name_of_part[static_cast<std::size_t>(m.tag())]];
    if (useful)
      result.notes.push_back("faces classified by " + counted(names.size(), words[level]));
    return;
  }
}

/// The names that faces carry at one level, in order of first use, and for each part the position
/// of its own.
std::vector<std::size_t> NamedParts::names_in_use(Level level,
                                                  std::vector<std::string>& names) const {
  std::vector<std::size_t> position;
  std::map<std::uint32_t, std::size_t> seen;
  for (const Part& part : parts_) {
    const auto [at, is_new] = seen.try_emplace(part[level], names.size());
    if (is_new) names.push_back(names_[level][part[level]]);
    position.push_back(at->second);
  }
  return position;
}

}  // namespace aomd::io::detail
