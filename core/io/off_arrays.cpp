#include "core/io/off_arrays.h"

#include <algorithm>
#include <utility>

#include "core/base/text.h"
#include "core/io/stored_numbers.h"

namespace aomd::io::detail {

std::optional<OffHeader> off_header(std::string_view word) {
  if (word.starts_with('n') && word.ends_with("OFF")) return {};
  const std::string small = lower(word);
  word = small;
  OffHeader header;
  const auto take = [&](std::string_view prefix, bool& there) {
    if (there || !word.starts_with(prefix)) return false;
    word.remove_prefix(prefix.size());
    return there = true;
  };
  while (take("st", header.texture) || take("c", header.colour) || take("n", header.normal) ||
         take("4", header.weight)) {
  }
  if (word != "off") return {};
  return header;
}

void OffArrays::Colours::add(Numbers numbers) {
  mixed = mixed || (known && numbers.size() != components);
  known = true;
  components = numbers.size();
  for (const Number& x : numbers) {
    whole = whole && x.whole && x.value >= 0 && x.value <= 255;
    values.push_back(x.value);
  }
}

Attribute OffArrays::Colours::array(int dimension, NumberType type) const {
  Attribute a{"color", dimension, static_cast<int>(components), false, values};
  a.meaning = Meaning::Colour;
  store_as(a, whole ? NumberType::UInt8 : type);
  return a;
}

void OffArrays::add_vertex(Numbers numbers) {
  const std::size_t others = header_.extra() - (header_.colour ? 4 : 0);
  const std::size_t colour = numbers.size() < others ? 0 : numbers.size() - others;
  if (numbers.size() < others || (header_.colour && colour < 3)) {
    vertex_.mixed = true;
    return;
  }
  if (header_.normal) {
    for (const Number& x : numbers.first(3)) normals_.push_back(x.value);
    numbers = numbers.subspan(3);
  }
  if (header_.colour) vertex_.add(numbers.first(colour));
  if (header_.texture)
    for (const Number& x : numbers.last(2)) texture_.push_back(x.value);
}

void OffArrays::finish(MeshData& mesh, const FaceSink& faces, NumberType type, ItemList& left_out) {
  if (vertex_.mixed) give_up(left_out);
  const auto add = [&](const char* name, int components, std::vector<double>& values, Meaning m) {
    if (values.empty()) return;
    Attribute a{name, 0, components, false, std::move(values), {}, m};
    store_as(a, type);
    mesh.attributes.push_back(std::move(a));
  };
  add("normal", 3, normals_, Meaning::Normal);
  if (!vertex_.values.empty()) mesh.attributes.push_back(vertex_.array(0, type));
  add("uv", 2, texture_, Meaning::Texture);
  if (face_.values.empty()) return;
  if (face_.mixed || face_.components < 3 || face_.components > 4)
    return left_out.add("face colours");
  Attribute colours = face_.array(2, type);
  spread_to_faces(colours, faces.origins());
  mesh.attributes.push_back(std::move(colours));
}

/// Vertices that lack some of the numbers leave those of all in the dark.
void OffArrays::give_up(ItemList& left_out) {
  if (header_.texture) left_out.add("texture coordinates");
  if (header_.colour) left_out.add("vertex colours");
  if (header_.normal) left_out.add("normals");
  normals_.clear();
  texture_.clear();
  vertex_.values.clear();
}

}  // namespace aomd::io::detail
