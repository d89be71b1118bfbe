// aomd check: what is wrong with a mesh, by name.

#include <iostream>
#include <memory>

#include "core/base/text.h"
#include "core/measure/volume_statistics.h"
#include "core/mesh/names.h"
#include "core/mesh/verify.h"
#include "tools/aomd/command.h"
#include "tools/aomd/report.h"

namespace aomd::cli {
namespace {

struct Options {
  std::string file;
  bool json = false, unused = false;
};

std::string shown(EntityRef e) { return e.valid() ? name_of(e) : "mesh"; }

void print(const std::string& file, const std::vector<Finding>& findings) {
  for (const Finding& f : findings)
    std::cout << f.name << ": " << shown(f.entity) << ": " << f.text << '\n';
  std::cout << file << ": "
            << (findings.empty() ? "nothing found" : counted(findings.size(), "finding")) << '\n';
}

int run(const Options& options) {
  const io::ReadResult read = read_mesh(options.file);
  const Mesh mesh(read.mesh);
  std::vector<Finding> findings = verify(mesh, {options.unused});
  for (const Region r : measure::measure_volume(mesh).inverted)
    findings.push_back({"inverted region", r, "its volume is zero or negative"});
  if (options.json) {
    Json list = Json::array();
    for (const Finding& f : findings)
      list.push_back({{"name", f.name}, {"entity", shown(f.entity)}, {"text", f.text}});
    std::cout << text_of({{"schema", 1}, {"file", options.file}, {"findings", list}});
  } else {
    print(options.file, findings);
  }
  return findings.empty() ? done : says_no;
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
  CLI::App* command =
      app.add_subcommand("check", "Names what is wrong with a mesh; exit code 1 when anything is");
  const auto options = std::make_shared<Options>();
  command->add_option("FILE", options->file, "The mesh")->required();
  command->add_flag("--json", options->json, "As JSON");
  command->add_flag("--unused", options->unused,
                    "Also names vertices, edges and faces that nothing uses");
  command->callback([&action, options] { action = [options] { return run(*options); }; });
}

}  // namespace aomd::cli
