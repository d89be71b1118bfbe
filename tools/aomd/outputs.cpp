#include "tools/aomd/outputs.h"

#include <algorithm>
#include <iostream>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

#include "core/base/text.h"
#include "core/io/output_files.h"
#include "core/io/output_target.h"
#include "tools/aomd/command.h"

namespace aomd::cli {
namespace {

namespace fs = std::filesystem;

using io::detail::input_identity;
using io::detail::output_identity;

bool is_standard_output(const NamedFile& file) {
  return !file.path.empty() && output_path(file.path) == "/dev/stdout";
}

/// Files by what tells them apart; the first of several is kept.
using KnownFiles = std::unordered_map<std::string, const NamedFile*>;

KnownFiles identified(const std::vector<NamedFile>& inputs) {
  KnownFiles known;
  for (const NamedFile& input : inputs)
    if (auto identity = input_identity(input.path == "-" ? "/dev/stdin" : input.path))
      known.emplace(std::move(*identity), &input);
  return known;
}

}  // namespace

void check_files(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs) {
  KnownFiles known = identified(inputs);
  for (const NamedFile& output : outputs) {
    if (output.path.empty()) continue;
    io::OutputFiles::probe(output_path(output.path));
    const auto identity = output_identity(output_path(output.path));
    if (!identity) continue;
    const auto [other, is_new] = known.emplace(*identity, &output);
    if (!is_new)
      throw UsageError(std::string(other->second->name) + " and " + output.name +
                       " are one file: " + output.path);
  }
}

fs::path output_path(const std::string& given) { return given == "-" ? "/dev/stdout" : given; }

std::ostream& stream_beside(const std::vector<NamedFile>& outputs) {
  return std::any_of(outputs.begin(), outputs.end(), is_standard_output) ? std::cerr : std::cout;
}

CLI::Option* add_format(CLI::App& command, std::string& format) {
  const auto check = [](const std::string& text) {
    return io::format_named(text)
               ? std::string()
               : "must be obj, ply, off, stl, gltf, glb, msh, mesh, vtk, vtu or su2, not " +
                     shown(text);
  };
  CLI::Option* option = command.add_option(
      "--format", format, "The format of OUT, whatever its name; needed where OUT is -");
  option->type_name("FMT")->check(CLI::Validator(check, ""));
  return option;
}

io::Format format_of_output(const std::string& given, const std::string& format) {
  if (!format.empty()) return *io::format_named(format);
  if (given == "-") throw UsageError("OUT is -, standard output: --format says in which format");
  return io::format_for_writing(given);
}

void write_mesh(const std::string& given, io::Format format, const MeshData& mesh, bool quiet,
                const io::WriteOptions& how) {
  const fs::path path = output_path(given);
  io::EncodedMesh encoded = io::to_bytes(path, format, mesh, how);
  io::OutputFiles files;
  io::add_mesh(files, path, encoded);
  files.commit();
  if (!quiet) print_notes(given, encoded.notes);
}

}  // namespace aomd::cli
