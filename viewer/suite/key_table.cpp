#include "viewer/suite/key_table.h"

#include <algorithm>
#include <array>

#include "viewer/base/picture_size.h"
#include "viewer/base/text.h"

namespace aomd::suite {
namespace {

[[noreturn]] void wrong(std::string_view key, const toml::node& node, const std::string& what) {
  throw WrongEntry(node, "'" + std::string(key) + "' is " + what);
}

bool flag_of(std::string_view key, const toml::node& node) {
  if (!node.is_boolean()) wrong(key, node, "true or false");
  return *node.value<bool>();
}

double number_of(std::string_view key, const toml::node& node, double low, double high) {
  const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
  if (!value || !(*value >= low && *value <= high))
    wrong(key, node, "a number from " + number_text(low) + " to " + number_text(high));
  return *value;
}

int whole_of(std::string_view key, const toml::node& node, int low, int high) {
  const std::optional<std::int64_t> value =
      node.is_integer() ? node.value<std::int64_t>() : std::nullopt;
  if (!value || *value < low || *value > high)
    wrong(key, node, "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  return static_cast<int>(*value);
}

/// One text or several.
std::vector<std::string> texts_of(std::string_view key, const toml::node& node) {
  if (node.is_string()) return {text_of(key, node)};
  if (!node.is_array()) wrong(key, node, "a text, or several in brackets");
  std::vector<std::string> texts;
  for (const toml::node& each : *node.as_array()) texts.push_back(text_of(key, each));
  return texts;
}

constexpr const char* form_of_masks = "rectangles of pixels: [[LEFT, TOP, WIDTH, HEIGHT], ...]";

measure::PixelArea mask_of(std::string_view key, const toml::node& node) {
  constexpr int most = 16384;
  const toml::array* sides = node.as_array();
  if (sides == nullptr || sides->size() != 4) wrong(key, node, form_of_masks);
  return {whole_of(key, (*sides)[0], 0, most), whole_of(key, (*sides)[1], 0, most),
          whole_of(key, (*sides)[2], 1, most), whole_of(key, (*sides)[3], 1, most)};
}

std::vector<measure::PixelArea> masks_of(std::string_view key, const toml::node& node) {
  if (!node.is_array()) wrong(key, node, form_of_masks);
  std::vector<measure::PixelArea> masks;
  for (const toml::node& each : *node.as_array()) masks.push_back(mask_of(key, each));
  return masks;
}

glm::ivec2 size_of(std::string_view key, const toml::node& node) {
  glm::ivec2 size;
  if (const std::string why = scene::read_picture_size(text_of(key, node), size); !why.empty())
    throw WrongEntry(node, why);
  return size;
}

bool dark_of(std::string_view key, const toml::node& node) {
  const std::string text = text_of(key, node);
  if (text != "light" && text != "dark")
    wrong(key, node, "\"light\" or \"dark\", not " + shown(text));
  return text == "dark";
}

/// With a threshold of 1 nothing is forgiven, unless other keys say so.
void take_threshold(Case& c, std::string_view key, const toml::node& node) {
  std::vector<measure::PixelArea> masks = std::move(c.limits.masks);
  c.limits = measure::PictureLimits::with_threshold(number_of(key, node, -1, 1));
  c.limits.masks = std::move(masks);
  c.panels_threshold = c.limits.threshold;
}

struct Key {
  std::string_view name;
  void (*take)(Case&, std::string_view, const toml::node&);
};
using Name = std::string_view;
using Node = const toml::node&;

// In the order in which they are taken: the threshold sets what the keys after it change.
constexpr std::array<Key, 19> keys = {{
    {"mesh", [](Case& c, Name k, Node n) { c.mesh = text_of(k, n); }},
    {"model", [](Case& c, Name k, Node n) { c.model = text_of(k, n); }},
    {"script", [](Case& c, Name k, Node n) { c.script = text_of(k, n); }},
    {"commands", [](Case& c, Name k, Node n) { c.commands = texts_of(k, n); }},
    {"expect", [](Case& c, Name k, Node n) { c.expect = texts_of(k, n); }},
    {"folder", [](Case& c, Name k, Node n) { c.folder = text_of(k, n); }},
    {"size", [](Case& c, Name k, Node n) { c.size = size_of(k, n); }},
    {"camera", [](Case& c, Name k, Node n) { c.camera = text_of(k, n); }},
    {"theme", [](Case& c, Name k, Node n) { c.dark = dark_of(k, n); }},
    {"scale", [](Case& c, Name k, Node n) { c.scale = number_of(k, n, 0.5, 4); }},
    {"panels", [](Case& c, Name k, Node n) { c.panels = flag_of(k, n); }},
    {"transparent", [](Case& c, Name k, Node n) { c.transparent = flag_of(k, n); }},
    {"threshold", take_threshold},
    {"panels-threshold",
     [](Case& c, Name k, Node n) { c.panels_threshold = number_of(k, n, -1, 1); }},
    {"largest", [](Case& c, Name k, Node n) { c.limits.largest = whole_of(k, n, 0, 255); }},
    {"share", [](Case& c, Name k, Node n) { c.limits.share = number_of(k, n, 0, 1); }},
    {"noise", [](Case& c, Name k, Node n) { c.limits.noise = whole_of(k, n, 0, 255); }},
    {"edges", [](Case& c, Name k, Node n) { c.limits.edges = flag_of(k, n); }},
    {"masks", [](Case& c, Name k, Node n) { c.limits.masks = masks_of(k, n); }},
}};

std::vector<std::string_view> key_names() {
  std::vector<std::string_view> names;
  names.reserve(keys.size());
  for (const Key& each : keys) names.push_back(each.name);
  return names;
}

void check_mask(const toml::node& at, const Case& each, const measure::PixelArea& mask) {
  if (mask.x + mask.width <= each.size.x && mask.y + mask.height <= each.size.y) return;
  throw WrongEntry(at, "the mask [" + std::to_string(mask.x) + ", " + std::to_string(mask.y) +
                           ", " + std::to_string(mask.width) + ", " + std::to_string(mask.height) +
                           "] reaches out of a picture of " + std::to_string(each.size.x) + "x" +
                           std::to_string(each.size.y));
}

bool good_name(std::string_view name) {
  constexpr std::string_view usual =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.-";
  return !name.empty() && name.size() <= 200 && name.front() != '.' && name.front() != '-' &&
         name.find_first_not_of(usual) == std::string_view::npos;
}

}  // namespace

std::string text_of(std::string_view key, const toml::node& node) {
  const std::optional<std::string> text =
      node.is_string() ? node.value<std::string>() : std::nullopt;
  if (!text || text->empty()) wrong(key, node, "a text");
  if (text->find_first_of("\n\r") != std::string::npos || text->find('\0') != std::string::npos)
    wrong(key, node, "a text of one line");
  return *text;
}

void refuse_unknown(const toml::table& table, std::span<const std::string_view> known) {
  for (const auto& [key, node] : table)
    if (std::find(known.begin(), known.end(), key.str()) == known.end())
      throw WrongEntry(
          node, "there is no key " + shown(key.str()) + "; there are " + joined(known, " and "));
}

void apply_keys(const toml::table& table, Case& into) {
  refuse_unknown(table, key_names());
  for (const Key& each : keys)
    if (const toml::node* node = table.get(each.name)) each.take(into, each.name, *node);
}

void check_case(const toml::node& at, const Case& each) {
  if (!good_name(each.name))
    throw WrongEntry(at, "the name " + shown(each.name) +
                             " names no file: letters, digits, '_', '-' and '.' do");
  if (each.mesh.empty() && each.script.empty() && each.commands.empty())
    throw WrongEntry(at, "give 'mesh', 'script' or 'commands': what the picture shows");
  for (const measure::PixelArea& mask : each.limits.masks) check_mask(at, each, mask);
}

}  // namespace aomd::suite
