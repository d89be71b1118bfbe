#include "tools/aomd/command.h"

#include <charconv>
#include <iostream>

#include "core/io/left_out.h"
#include "tools/aomd/interrupt.h"

namespace aomd::cli {

void print_notes(const std::string& file, const std::vector<std::string>& notes) {
  for (const std::string& note : notes) std::cerr << "aomd: note: " << file << ": " << note << '\n';
}

io::ReadResult read_mesh(const std::string& file, bool quiet) {
  io::ReadResult result = io::read(file);
  if (!quiet) print_notes(file, result.notes);
  stop_if_interrupted();
  return result;
}

void write_mesh(const std::string& file, const MeshData& mesh, bool quiet,
                const io::WriteOptions& how) {
  const std::vector<std::string> left_out = io::leaves_out(file, mesh);
  io::write(file, mesh, how);
  if (!quiet) print_notes(file, left_out);
}

std::optional<double> parse_number(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return {};
  return value;
}

CLI::Option* add_threads(CLI::App& command, int& threads) {
  CLI::Option* option = command.add_option(
      "--threads", threads,
      "On how many threads to work; 0: one for each core. The result is the same");
  option->type_name("N")->check(CLI::Range(0, 1024).description(""))->capture_default_str();
  return option;
}

CLI::Validator angle_range() {
  const auto check = [](const std::string& text) -> std::string {
    const auto angle = parse_number(text);
    return angle && *angle > 0 && *angle < 180
               ? ""
               : "must be more than 0 and less than 180 degrees, not " + text;
  };
  return CLI::Validator(check, "DEG");
}

}  // namespace aomd::cli
