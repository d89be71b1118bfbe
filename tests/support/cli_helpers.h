#pragma once
// Running the program `aomd` from a test, in a folder of its own.

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <nlohmann/json.hpp>

#include "tests/support/io_helpers.h"

namespace aomd::test {

/// What a run of the program left behind.
struct Outcome {
  int code = -1;
  std::string out, err;
};

/// Each test works in a folder that vanishes with it; file names below are relative to it.
class CommandLine : public testing::Test {
 protected:
  /// Runs the program with arguments as a shell would take them.
  Outcome aomd(const std::string& arguments) const {
    const std::string command = "cd '" + at("").string() + "' && '" AOMD_PROGRAM "' " + arguments +
                                " >stdout.txt 2>stderr.txt </dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, bytes_of(at("stdout.txt")),
            bytes_of(at("stderr.txt"))};
  }

  /// Expects an exit code and one line on standard error that starts with "aomd: " and contains a
  /// fragment.
  void expect_failure(const std::string& arguments, int code, const std::string& fragment) const {
    const Outcome run = aomd(arguments);
    EXPECT_EQ(run.code, code) << arguments << '\n' << run.err;
    EXPECT_EQ(run.err.rfind("aomd: ", 0), 0u) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_NE(run.err.find(fragment), std::string::npos)
        << "no \"" << fragment << "\" in: " << run.err;
  }

  void sample(const std::string& name, const std::string& file, int size) const {
    ASSERT_EQ(aomd("sample " + name + " " + file + " --size " + std::to_string(size)).code, 0);
  }

  [[nodiscard]] std::filesystem::path at(const std::string& name) const {
    return folder_ / name.c_str();
  }
  [[nodiscard]] bool exists(const std::string& name) const {
    return std::filesystem::exists(at(name));
  }
  [[nodiscard]] std::string text(const std::string& name) const { return bytes_of(at(name)); }
  void put(const std::string& name, const std::string& content) const {
    std::ofstream(at(name), std::ios::binary) << content;
  }
  [[nodiscard]] nlohmann::json json(const std::string& name) const {
    return nlohmann::json::parse(text(name));
  }

  TemporaryFolder folder_;
};

}  // namespace aomd::test
