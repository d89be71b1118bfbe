#include "core/io/gltf_accessors.h"

#include <array>
#include <cstring>
#include <optional>
#include <utility>

#include "core/base/text.h"

namespace aomd::io::detail {
namespace {

constexpr std::array<std::pair<int, NumberType>, 6> component_types{
    {{TINYGLTF_COMPONENT_TYPE_BYTE, NumberType::Int8},
     {TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, NumberType::UInt8},
     {TINYGLTF_COMPONENT_TYPE_SHORT, NumberType::Int16},
     {TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, NumberType::UInt16},
     {TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, NumberType::UInt32},
     {TINYGLTF_COMPONENT_TYPE_FLOAT, NumberType::Float32}}};

std::optional<NumberType> number_type(int component) {
  for (const auto& [known, type] : component_types)
    if (known == component) return type;
  return {};
}

/// Rows and columns of each type: columns of matrices start at multiples of four bytes.
struct Layout {
  int rows = 1, columns = 1;
};

Layout layout_of(int type) {
  if (type == TINYGLTF_TYPE_MAT2) return {2, 2};
  if (type == TINYGLTF_TYPE_MAT3) return {3, 3};
  if (type == TINYGLTF_TYPE_MAT4) return {4, 4};
  return {type == TINYGLTF_TYPE_SCALAR ? 1 : type, 1};
}

template <class Value>
double value_at(const char* bytes) {
  Value value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<double>(value);
}

double number_at(NumberType type, const char* bytes) {
  switch (type) {
    case NumberType::Int8:
      return value_at<std::int8_t>(bytes);
    case NumberType::UInt8:
      return value_at<std::uint8_t>(bytes);
    case NumberType::Int16:
      return value_at<std::int16_t>(bytes);
    case NumberType::UInt16:
      return value_at<std::uint16_t>(bytes);
    case NumberType::UInt32:
      return value_at<std::uint32_t>(bytes);
    default:
      return value_at<float>(bytes);
  }
}

/// Equal elements in a view.
class Elements {
 public:
  /// Throws ReadError where the view is too short for so many. `stride` 0: one lies at the other.
  Elements(const GltfFile& file, const std::string& what, int view, std::int64_t offset,
           std::uint64_t count, NumberType type, Layout layout, std::size_t stride = 0)
      : type_(type), layout_(layout), bytes_(file.view(view)) {
    const std::size_t each = size_of(type) * static_cast<std::size_t>(layout.rows);
    column_ = layout.columns > 1 ? (each + 3) / 4 * 4 : each;
    const std::size_t size = column_ * static_cast<std::size_t>(layout.columns - 1) + each;
    stride_ = stride == 0 ? column_ * static_cast<std::size_t>(layout.columns) : stride;
    const std::uint64_t length = bytes_.size();
    const bool fits =
        offset >= 0 && static_cast<std::uint64_t>(offset) <= length && stride_ >= size &&
        (count == 0 ||
         (length - static_cast<std::uint64_t>(offset) >= size &&
          (length - static_cast<std::uint64_t>(offset) - size) / stride_ >= count - 1));
    if (!fits)
      file.source().fail(what + " of " + counted(count, "element") + " goes beyond its view of " +
                         counted(length, "byte"));
    bytes_.remove_prefix(static_cast<std::size_t>(offset));
  }

  /// Writes the numbers of one element.
  void get(std::size_t i, double* out) const {
    const char* const start = bytes_.data() + i * stride_;
    for (int c = 0; c < layout_.columns; ++c)
      for (int r = 0; r < layout_.rows; ++r)
        *out++ = number_at(type_, start + static_cast<std::size_t>(c) * column_ +
                                      static_cast<std::size_t>(r) * size_of(type_));
  }

 private:
  NumberType type_;
  Layout layout_;
  std::string_view bytes_;
  std::size_t column_ = 0, stride_ = 0;
};

class AccessorReader {
 public:
  AccessorReader(const GltfFile& file, int index)
      : file_(file), what_("accessor " + std::to_string(index)) {
    const auto& all = file.model().accessors;
    if (index < 0 || static_cast<std::size_t>(index) >= all.size())
      file.source().fail("there is no " + what_);
    accessor_ = &all[static_cast<std::size_t>(index)];
    const auto type = number_type(accessor_->componentType);
    if (!type)
      file.source().fail(what_ + " has numbers of type " +
                         std::to_string(accessor_->componentType) + ", which glTF does not know");
    type_ = *type;
    layout_ = layout_of(accessor_->type);
  }

  GltfNumbers read() {
    GltfNumbers numbers{layout_.rows * layout_.columns, type_, accessor_->normalized, {}};
    const auto n = static_cast<std::size_t>(numbers.components);
    if (accessor_->bufferView < 0) {
      check_zeros();
      numbers.values.resize(n * accessor_->count);
    } else {
      const tinygltf::BufferView* const view = view_of(accessor_->bufferView);
      const Elements elements(file_, what_, accessor_->bufferView, offset(), accessor_->count,
                              type_, layout_, view ? view->byteStride : 0);
      numbers.values.resize(n * accessor_->count);
      for (std::size_t i = 0; i < accessor_->count; ++i) elements.get(i, &numbers.values[n * i]);
    }
    if (accessor_->sparse.isSparse) replace_some(numbers);
    return numbers;
  }

  [[noreturn]] void fail(const std::string& what) const { file_.source().fail(what_ + what); }

 private:
  [[nodiscard]] std::int64_t offset() const {
    return accessor_->byteOffset > file_.size() ? -1
                                                : static_cast<std::int64_t>(accessor_->byteOffset);
  }

  [[nodiscard]] const tinygltf::BufferView* view_of(int index) const {
    const auto& all = file_.model().bufferViews;
    return index >= 0 && static_cast<std::size_t>(index) < all.size()
               ? &all[static_cast<std::size_t>(index)]
               : nullptr;
  }

  /// An accessor without a view is full of zeros: as many as the file says.
  void check_zeros() const {
    constexpr std::uint64_t most_for_a_byte = 16;
    if (accessor_->count > most_for_a_byte * file_.size())
      fail(" of " + counted(accessor_->count, "element") + " has no data");
  }

  void replace_some(GltfNumbers& numbers) const {
    const auto& sparse = accessor_->sparse;
    const auto type = number_type(sparse.indices.componentType);
    if (!type || !is_integer(*type) || sparse.count < 0) fail(" is sparse without sound indices");
    const auto count = static_cast<std::uint64_t>(sparse.count);
    const Elements indices(file_, what_, sparse.indices.bufferView, sparse.indices.byteOffset,
                           count, *type, {});
    const Elements values(file_, what_, sparse.values.bufferView, sparse.values.byteOffset, count,
                          type_, layout_);
    for (std::size_t i = 0; i < count; ++i) {
      double at = 0;
      indices.get(i, &at);
      if (at < 0 || at >= static_cast<double>(accessor_->count))
        fail(" has a sparse value at " + number_text(at, 12) + ", and " +
             counted(accessor_->count, "element"));
      values.get(i, &numbers.values[static_cast<std::size_t>(numbers.components) *
                                    static_cast<std::size_t>(at)]);
    }
  }

  const GltfFile& file_;
  std::string what_;
  const tinygltf::Accessor* accessor_;
  NumberType type_;
  Layout layout_;
};

}  // namespace

GltfNumbers read_accessor(const GltfFile& file, int index) {
  return AccessorReader(file, index).read();
}

std::vector<std::uint32_t> read_indices(const GltfFile& file, int index) {
  AccessorReader reader(file, index);
  const GltfNumbers numbers = reader.read();
  if (numbers.components != 1 || !is_integer(numbers.type) || numbers.type == NumberType::Int8 ||
      numbers.type == NumberType::Int16)
    reader.fail(" lists vertices, and its elements are no indices");
  return {numbers.values.begin(), numbers.values.end()};
}

void use_floats(GltfNumbers& numbers) {
  if (!numbers.normalized || !is_integer(numbers.type)) return;
  double full = 0;
  use_as(numbers.type, 1e300, [&](auto most) { full = static_cast<double>(most); });
  for (double& x : numbers.values)
    x = static_cast<double>(static_cast<float>(std::max(x / full, -1.0)));
  numbers.type = NumberType::Float32;
  numbers.normalized = false;
}

int gltf_component(NumberType type) {
  for (const auto& [component, known] : component_types)
    if (known == type) return component;
  return 0;
}

int gltf_type(int components) {
  if (components >= 1 && components <= 4)
    return components == 1 ? TINYGLTF_TYPE_SCALAR : components;
  if (components == 9) return TINYGLTF_TYPE_MAT3;
  return components == 16 ? TINYGLTF_TYPE_MAT4 : 0;
}

}  // namespace aomd::io::detail
