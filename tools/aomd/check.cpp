// aomd check: what is wrong with a mesh, by name.

#include <algorithm>
#include <iostream>
#include <memory>

#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/mesh/names.h"
#include "core/mesh/verify.h"
#include "tools/aomd/batch.h"
#include "tools/aomd/command.h"
#include "tools/aomd/in_memory.h"
#include "tools/aomd/report.h"
#include "tools/aomd/surface_lines.h"
#include "tools/aomd/volume_report.h"

namespace aomd::cli {
namespace {

struct CheckArguments {
  std::string file;
  bool json = false, in_one_line = false, unused = false;
  std::vector<std::string> required;  ///< names of properties
};

std::string entity_text(EntityRef e) { return e.valid() ? name_of(e) : "mesh"; }

std::vector<std::string> property_names() {
  std::vector<std::string> names;
  names.reserve(surface_property_count + 1);
  for (int i = 0; i < surface_property_count; ++i)
    names.emplace_back(property_name(static_cast<SurfaceProperty>(i)));
  names.emplace_back("clean");
  return names;
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

void check_property(const std::string& word) {
  const std::vector<std::string> words = property_names();
  if (std::find(words.begin(), words.end(), word) == words.end())
    throw UsageError("require: " + shown(word) + " is none of " + listed(words));
}

// What a mesh is found to be. Moving JSON asserts its invariants, which clang-tidy takes for
// throwing. NOLINTNEXTLINE(bugprone-exception-escape)
struct Checked {
  std::vector<Finding> mesh;
  std::vector<SurfaceFinding> surface;
  std::vector<std::string> missing;  ///< of the required properties
  Json volume;                       ///< null without regions
};

bool is_required(const CheckArguments& options, SurfaceProperty property) {
  const auto names = [&](const char* name) {
    return std::find(options.required.begin(), options.required.end(), name) !=
           options.required.end();
  };
  return names(property_name(property)) || (names("clean") && property != SurfaceProperty::Closed);
}

// A border is no dirt: it is told where the surface is to be closed.
void look_at_surface(const CheckArguments& options, const MeshData& data, const Mesh& mesh,
                     Checked& result) {
  const auto add = [&](const std::vector<SurfaceFinding>& findings) {
    result.surface.insert(result.surface.end(), findings.begin(), findings.end());
  };
  for (const SurfaceFinding& finding : survey(data))
    if (finding.breaks != SurfaceProperty::Closed || is_required(options, finding.breaks))
      add({finding});
  add(hanging_findings(mesh, thread_count(0), measure::Skin::Derived));
  if (data.regions.empty()) add(self_intersection_findings(mesh));
  for (const SurfaceFinding& finding : result.surface)
    if (is_required(options, finding.breaks)) {
      const std::string name = property_name(finding.breaks);
      if (result.missing.empty() || result.missing.back() != name) result.missing.push_back(name);
    }
  std::sort(result.missing.begin(), result.missing.end());
  result.missing.erase(std::unique(result.missing.begin(), result.missing.end()),
                       result.missing.end());
}

void look_at_volume(const Mesh& mesh, Checked& result) {
  if (mesh.count(3) == 0) return;
  const int threads = thread_count(0);
  const measure::VolumeQuality quality = measure::measure_volume(mesh, threads);
  const measure::VolumeComplex complex = measure::analyse_volume(mesh, threads);
  const std::vector<Finding> findings = volume_findings(complex, quality);
  result.mesh.insert(result.mesh.end(), findings.begin(), findings.end());
  result.volume = volume_json(complex, quality);
}

// `turned` are the regions that were renumbered when the file was read.
Checked checked(const CheckArguments& options, const MeshData& data,
                const std::vector<std::uint32_t>& turned = {}) {
  const Mesh mesh(data);
  Checked result;
  result.mesh = verify(mesh, {options.unused});
  for (const std::uint32_t region : turned)
    result.mesh.push_back({"inverted region", Region(region), "the file lists it inside out"});
  look_at_volume(mesh, result);
  look_at_surface(options, data, mesh, result);
  return result;
}

// What is dirty on the surface stands beside what is wrong with the mesh: it may be meant.
std::string summary(const Checked& result) {
  std::string text = result.mesh.empty() ? "nothing found" : counted(result.mesh.size(), "finding");
  if (!result.surface.empty())
    text += (result.mesh.empty() ? " in the mesh, " : ", ") +
            counted(result.surface.size(), "kind") + " of dirt on the surface";
  for (std::size_t i = 0; i < result.missing.size(); ++i)
    text += (i == 0 ? ": not " : ", ") + result.missing[i];
  return text;
}

void print(const std::string& file, const Checked& result) {
  for (const Finding& f : result.mesh)
    std::cout << f.name << ": " << entity_text(f.entity) << ": " << f.text << '\n';
  for (const SurfaceFinding& f : result.surface) std::cout << line_of(f, file) << '\n';
  std::cout << printable(file) << ": " << summary(result) << '\n';
}

Json json_of(const CheckArguments& options, const Checked& result) {
  Json list = Json::array();
  for (const Finding& f : result.mesh)
    list.push_back({{"name", f.name}, {"entity", entity_text(f.entity)}, {"text", f.text}});
  return {{"schema", 1},
          {"file", options.file},
          {"findings", list},
          {"surface", surface_json(result.surface, options.file)},
          {"volume", result.volume},
          {"required", options.required},
          {"missing", result.missing}};
}

int run(const CheckArguments& options) {
  const io::ReadResult read = read_mesh(options.file);
  const Checked result = checked(options, read.mesh, read.turned);
  if (options.json)
    std::cout << text_of(json_of(options, result), options.in_one_line);
  else
    print(options.file, result);
  return result.mesh.empty() && result.missing.empty() ? done : says_no;
}

}  // namespace

Json check(const std::string& name, const MeshData& mesh, bool unused,
           const std::vector<std::string>& required) {
  for (const std::string& word : required) check_property(word);
  const CheckArguments options{name, true, false, unused, required};
  return json_of(options, checked(options, mesh));
}

void add_check(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "check",
      "Names what is wrong with a mesh, exit code 1 when anything is, and what is dirty in a "
      "surface");
  const auto options = std::make_shared<CheckArguments>();
  const auto batch = std::make_shared<Batch>();
  add_files(*command, *batch);
  command->add_flag("--json", batch->json, "As JSON; of several meshes a line each");
  command->add_flag("--unused", options->unused,
                    "Also names vertices, edges and faces that nothing uses");
  const std::vector<std::string> words = property_names();
  command
      ->add_option("--require", options->required,
                   "Exit code 1 also where the surface is not: " + listed(words) +
                       ".\nclean is all but closed")
      ->type_name("WORD,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->transform(CLI::IsMember(words, CLI::ignore_case).description(""));
  command->callback([&action, options, batch] {
    action = reading(batch, [options, batch](const BatchFile& file) {
      CheckArguments one = *options;
      one.file = file.input;
      one.json = batch->json;
      one.in_one_line = file.one_of_several();
      return run(one);
    });
  });
}

}  // namespace aomd::cli
