#pragma once
// Faces by what files call them: group, object, material and smoothing group.

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/io/io.h"

namespace aomd::io::detail {

/// Collects the names under which faces stand. Meanwhile a face has the class ModelRef(2, part());
/// finish() makes labels and classes of that.
class NamedParts {
 public:
  enum Level { Groups, Objects, Materials, Smoothing };

  /// The faces that follow have this name.
  void enter(Level level, const std::string& name);
  /// The number of the combination of names that holds now.
  [[nodiscard]] std::int32_t part();
  /// Gives the mesh its labels, and the faces the classes that groups, objects or materials tell:
  /// the first of these that tells faces apart.
  void finish(ReadResult& result) const;

 private:
  using Part = std::array<std::uint32_t, 4>;

  /// The names of one level, numbered as they come, and the one that holds now.
  class Names {
   public:
    void enter(const std::string& name);
    [[nodiscard]] std::uint32_t current() const { return current_; }
    [[nodiscard]] const std::string& operator[](std::uint32_t i) const { return names_[i]; }

   private:
    std::vector<std::string> names_{""};
    std::map<std::string, std::uint32_t> numbers_{{"", 0}};
    std::uint32_t current_ = 0;
  };

  void add_labels(MeshData& mesh) const;
  void classify(ReadResult& result) const;
  [[nodiscard]] std::vector<std::size_t> names_in_use(Level level,
                                                      std::vector<std::string>& names) const;

  std::array<Names, 4> names_;
  std::vector<Part> parts_;
  std::map<Part, std::int32_t> part_numbers_;
  std::int32_t part_ = 0;
  bool part_known_ = false;
};

}  // namespace aomd::io::detail
