#pragma once
// The arrays of legacy VTK files: on points, on cells, and on the whole.

#include <string>
#include <string_view>
#include <vector>

#include "core/io/notes.h"
#include "core/io/vtk_dataset.h"
#include "core/io/vtk_legacy.h"

namespace aomd::io::detail {

/// Reads what follows POINT_DATA and CELL_DATA, and fields before them.
class LegacyArrays : protected LegacyInput {
 public:
  explicit LegacyArrays(const Source& source) : LegacyInput(source) {}

 protected:
  /// The cursor stands behind POINT_DATA or CELL_DATA: what follows has so many tuples and goes
  /// into `target`.
  void begin_data(std::vector<VtkArray>& target, std::uint64_t tuples);
  [[nodiscard]] bool data_begun() const { return target_ != nullptr; }
  /// The array, or table of colours, that this keyword starts. False where it starts none.
  bool attribute(const std::string& keyword);
  /// FIELD. Before any data, what is of no use here is left out of `of_the_whole`.
  void fields(std::vector<VtkArray>& of_the_whole);
  /// Up to an empty line.
  void skip_metadata();
  /// Arrays that are not made of numbers.
  [[nodiscard]] const ItemList& passed_over() const { return passed_over_; }

 private:
  void mean(Meaning meaning);
  void scalars();
  void color_scalars();
  void lookup_table();
  void field(std::vector<VtkArray>& of_the_whole);
  void array(std::vector<VtkArray>& into, const std::string& name, std::uint64_t components,
             std::uint64_t tuples);
  void array(std::vector<VtkArray>& into, const std::string& name, std::uint64_t components,
             std::uint64_t tuples, std::string_view type_name);
  void bits(std::uint64_t n, std::vector<double>& out);
  void skip_strings(const std::string& name, std::uint64_t n);
  void skip_binary_string();

  std::vector<VtkArray>* target_ = nullptr;
  std::uint64_t tuples_ = 0;
  ItemList passed_over_;
};

}  // namespace aomd::io::detail
