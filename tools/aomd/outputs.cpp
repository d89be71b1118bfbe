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
#include "core/io/pvtu.h"
#include "tools/aomd/command.h"
#include "tools/aomd/values.h"

namespace aomd::cli {
namespace {

namespace fs = std::filesystem;

using io::detail::input_identity;
using io::detail::output_identity;

constexpr int most_pieces = 500;  // each is an open file until all are there

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
               : "must be obj, ply, off, stl, gltf, glb, msh, mesh, vtk, vtu, pvtu or su2, not " +
                     shown(text);
  };
  CLI::Option* option = command.add_option(
      "--format", format, "The format of OUT, whatever its name; needed where OUT is -");
  option->type_name("FMT")->check(CLI::Validator(check, ""));
  return option;
}

CLI::Option* add_pieces(CLI::App& command, std::size_t& pieces) {
  CLI::Option* option = command.add_option(
      "--pieces", pieces, "Of a .pvtu: cuts the result into so many .vtu files beside it");
  return option->type_name("N")->transform(whole_number(1, most_pieces))->capture_default_str();
}

std::vector<NamedFile> piece_files(const std::string& given, io::Format format,
                                   std::size_t pieces) {
  if (format != io::Format::Pvtu && pieces > 1)
    throw UsageError("--pieces is for .pvtu, and " + given + " is none");
  std::vector<NamedFile> files;
  for (std::size_t i = 0; format == io::Format::Pvtu && i < pieces; ++i)
    files.push_back({"OUT", io::piece_beside(output_path(given), i).string()});
  return files;
}

std::vector<NamedFile> named_pieces(const std::string& input) {
  std::vector<NamedFile> files;
  if (lower(fs::path(input).extension().string()) != ".pvtu") return files;
  try {
    const io::detail::FileBytes list(input);
    for (const fs::path& piece : io::detail::pvtu_pieces({input, list.view()}))
      files.push_back({"IN", piece.string()});
  } catch (const io::FileError&) {
    files.clear();  // who reads it says what is wrong
  }
  return files;
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
