#pragma once
// Small files in memory, for tests of readers.

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include <unistd.h>

#include "core/io/io.h"

namespace aomd::test {

/// What reading these bytes says: "" when it works.
inline std::string error_of(const std::string& name, std::string_view bytes) {
  try {
    (void)io::read_bytes(name, bytes);
    return "";
  } catch (const io::ReadError& error) {
    return error.what();
  } catch (const io::LimitError& error) {
    return std::string("limit: ") + error.what();
  }
}

/// Expects an error of one line that contains every fragment.
inline void expect_error(const std::string& name, std::string_view bytes,
                         std::initializer_list<const char*> fragments) {
  const std::string error = error_of(name, bytes);
  EXPECT_NE(error, "") << "accepted: " << bytes.substr(0, 200);
  EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  for (const char* fragment : fragments) {
    EXPECT_NE(error.find(fragment), std::string::npos) << "no \"" << fragment << "\" in: " << error;
  }
}

/// The bytes of a value as they lie in memory (little-endian here), or reversed.
template <class Value>
std::string raw(Value value, bool reversed = false) {
  char bytes[sizeof(Value)];
  std::memcpy(bytes, &value, sizeof(Value));
  std::string text(bytes, sizeof(Value));
  if (reversed) text.assign(text.rbegin(), text.rend());
  return text;
}

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A folder that vanishes with the test.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "aomd_io_XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  [[nodiscard]] std::filesystem::path operator/(const char* name) const { return path_ / name; }
  [[nodiscard]] std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_), {}));
  }

 private:
  std::filesystem::path path_;
};

using Indices = std::vector<std::uint32_t>;

}  // namespace aomd::test
