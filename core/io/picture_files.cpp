#include "core/io/picture_files.h"

#include <algorithm>

#include "core/io/source.h"

namespace aomd::io::detail {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> bytes_of(const fs::path& file) {
  try {
    return std::string(FileBytes(file).view());
  } catch (const FileError&) {
    return {};
  }
}

bool is_there(const fs::path& file) {
  std::error_code ignored;
  return fs::exists(file, ignored);
}

}  // namespace

std::optional<std::string> picture_bytes(const Appearance& looks, const Picture& picture) {
  if (!picture.bytes.empty()) return picture.bytes;
  if (picture.name.empty()) return {};
  return bytes_of(fs::path(looks.folder) / picture.name);
}

std::string_view picture_type(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG")) return "image/png";
  return bytes.starts_with("\xff\xd8\xff") ? "image/jpeg" : "";
}

std::string FilesBeside::name_of(const std::string& file) {
  const fs::path from = fs::path(looks_.folder) / file, there = mesh_.parent_path() / file;
  std::error_code ignored;
  if (fs::equivalent(from, there, ignored)) return file;
  auto bytes = bytes_of(from);
  if (!bytes) return file;
  if (is_there(there) && bytes_of(there) == bytes) return file;
  return put(fs::path(file).filename().string(), std::move(*bytes));
}

std::string FilesBeside::name_of(const Picture& picture) {
  if (picture.bytes.empty()) return name_of(picture.name);
  const std::string_view extension = picture_type(picture.bytes) == "image/png" ? ".png" : ".jpg";
  std::string name = fs::path(picture.name).filename().replace_extension().string();
  if (name.empty()) name = "picture";
  return put(name.append(extension), picture.bytes);
}

std::string FilesBeside::own_name(std::string_view extension) const {
  const fs::path folder = mesh_.parent_path();
  const std::string stem = mesh_.stem().string(), format = mesh_.extension().string();
  const std::string usual = stem + std::string(extension);
  const std::string other =
      stem + '_' + format.substr(std::min<std::size_t>(1, format.size())) + std::string(extension);
  const bool taken = is_there(folder / usual) && !is_there(mesh_);
  return taken || is_there(folder / other) ? other : usual;
}

std::string FilesBeside::add(std::string_view extension, std::string bytes) {
  std::string name = own_name(extension);
  encoded_.beside.push_back({name, std::move(bytes)});
  return name;
}

/// Files of this name that are something else stay: the new one then starts with the mesh's name.
std::string FilesBeside::put(const std::string& name, std::string bytes) {
  auto& files = encoded_.beside;
  const auto known = [&](const std::string& taken) {
    return std::find_if(files.begin(), files.end(), [&](const auto& f) { return f.name == taken; });
  };
  const auto free = [&](const std::string& taken) {
    const auto at = known(taken);
    if (at != files.end()) return at->bytes == bytes;
    const fs::path there = mesh_.parent_path() / taken;
    return !is_there(there) || bytes_of(there) == bytes;
  };
  const std::string stem = mesh_.stem().string() + '_';
  std::string chosen = free(name) ? name : stem + name;
  for (int k = 2; known(chosen) != files.end() && known(chosen)->bytes != bytes; ++k)
    chosen = stem + std::to_string(k) + '_' + name;
  if (known(chosen) == files.end()) files.push_back({chosen, std::move(bytes)});
  return chosen;
}

}  // namespace aomd::io::detail
