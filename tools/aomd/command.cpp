#include "tools/aomd/command.h"

#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>

#include "core/base/text.h"
#include "tools/aomd/values.h"

namespace aomd::cli {
namespace {

bool is_pipe(const std::string& file) {
  struct stat info {};
  return ::stat(file.c_str(), &info) == 0 && S_ISFIFO(info.st_mode);
}

io::ReadResult read_stream(const std::string& name, std::istream& stream) {
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad()) throw io::ReadError(name, {}, "cannot be read");
  return io::read_bytes(name, bytes);
}

}  // namespace

void print_notes(const std::string& file, const std::vector<std::string>& notes) {
  const std::string name = printable(file);
  for (const std::string& note : limited_lines(notes))
    std::cerr << "aomd: note: " << name << ": " << note << '\n';
}

io::ReadResult read_input(const std::string& file) {
  if (file == "-") return read_stream("standard input", std::cin);
  if (!is_pipe(file)) return io::read(file);
  std::ifstream pipe(file, std::ios::binary);
  if (!pipe) throw io::ReadError(file, {}, "cannot be opened");
  return read_stream(file, pipe);
}

io::ReadResult read_mesh(const std::string& file, bool quiet) {
  io::ReadResult result = read_input(file);
  if (!quiet) print_notes(file, result.notes);
  return result;
}

CLI::Option* add_threads(CLI::App& command, int& threads) {
  CLI::Option* option = command.add_option(
      "--threads", threads,
      "On how many threads to work; 0: one for each core. The result is the same");
  option->type_name("N")->transform(whole_number(0, 1024))->capture_default_str();
  return option;
}

}  // namespace aomd::cli
