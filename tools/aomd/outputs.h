#pragma once
// What a command writes: looked at before the work, so that complaints come before it.

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "core/io/io.h"

namespace aomd::cli {

/// A file by what the command line calls it: "IN", "--journal".
struct NamedFile {
  const char* name;
  std::string path;  ///< as given; empty where it was not
};

/// Throws UsageError where an output is also an input or another output, however the paths are
/// spelled, and io::WriteError where one cannot be written.
void check_files(const std::vector<NamedFile>& inputs, const std::vector<NamedFile>& outputs);

/// Where an output goes: "-" stands for standard output.
[[nodiscard]] std::filesystem::path output_path(const std::string& given);

/// Where what people read goes: to standard error where standard output takes an output.
[[nodiscard]] std::ostream& stream_beside(const std::vector<NamedFile>& outputs);

/// Adds --format FMT.
CLI::Option* add_format(CLI::App& command, std::string& format);

/// Adds --pieces N, of a .pvtu.
CLI::Option* add_pieces(CLI::App& command, std::size_t& pieces);

/// The files of the pieces of an output, each by the name OUT; none but of a .pvtu. Throws
/// UsageError for several pieces in another format.
[[nodiscard]] std::vector<NamedFile> piece_files(const std::string& given, io::Format format,
                                                 std::size_t pieces);
/// The files that an input names as its pieces, each by the name IN; none where it cannot be read.
[[nodiscard]] std::vector<NamedFile> named_pieces(const std::string& input);

/// The format of an output: the one that --format names, else that of its extension. Throws
/// UsageError for standard output without --format, io::WriteError for an unknown extension.
[[nodiscard]] io::Format format_of_output(const std::string& given, const std::string& format);

/// Writes a mesh as the only output of a command; what the format cannot hold goes to standard
/// error as notes unless `quiet`.
void write_mesh(const std::string& given, io::Format format, const MeshData& mesh,
                bool quiet = false, const io::WriteOptions& how = {});

}  // namespace aomd::cli
