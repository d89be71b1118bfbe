#include "viewer/ui/file_browser.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <utility>

#include "viewer/base/text.h"
#include "viewer/ui/widgets.h"

namespace aomd::ui {
namespace {

namespace fs = std::filesystem;

std::string lower(std::string s) {
  for (char& c : s) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return s;
}

bool wanted(const fs::path& path, const BrowserPurpose& purpose) {
  const std::string extension = lower(path.extension().string());
  return std::find(purpose.extensions.begin(), purpose.extensions.end(), extension) !=
         purpose.extensions.end();
}

/// As shells write it: below the user's own folder it begins with ~.
std::string shown_folder(const fs::path& folder) {
  const char* home = std::getenv("HOME");
  if (home == nullptr || *home == 0) return folder.string();
  const fs::path below = folder.lexically_relative(home);
  if (below.empty() || *below.begin() == "..") return folder.string();
  return below == "." ? "~" : "~/" + below.string();
}

fs::path below_home(const std::string& typed) {
  const char* home = std::getenv("HOME");
  const bool meant = home != nullptr && (typed == "~" || typed.rfind("~/", 0) == 0);
  return meant ? fs::path(home) / typed.substr(std::min<std::size_t>(2, typed.size()))
               : fs::path(typed);
}

}  // namespace

void FileBrowser::set_folder(const fs::path& folder) {
  std::error_code error;
  if (fs::is_directory(folder, error)) folder_ = folder;
}

void FileBrowser::begin(const BrowserPurpose& purpose) {
  std::error_code error;
  if (folder_.empty() || !fs::is_directory(folder_, error)) folder_ = fs::current_path(error);
  typed_ = purpose.suggested_name;
  chosen_ = false;
  ++times_shown_;
  read_folder(purpose);
}

void FileBrowser::read_folder(const BrowserPurpose& purpose) {
  entries_.clear();
  problem_.clear();
  std::error_code error;
  fs::directory_iterator it(folder_, fs::directory_options::skip_permission_denied, error);
  if (error) problem_ = "This folder cannot be read: " + error.message();
  for (; !error && it != fs::directory_iterator(); it.increment(error)) {
    const std::string name = it->path().filename().string();
    if (name.empty() || name.front() == '.') continue;
    std::error_code unknown;
    if (it->is_directory(unknown))
      entries_.push_back({name, true, 0});
    else if (wanted(it->path(), purpose))
      entries_.push_back({name, false, it->file_size(unknown)});
  }
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    return a.folder != b.folder ? a.folder : lower(a.name) < lower(b.name);
  });
}

std::optional<fs::path> FileBrowser::accept(const BrowserPurpose& purpose) {
  problem_.clear();
  if (typed_.empty()) return {};
  const fs::path path =
      (folder_ / below_home(typed_)).lexically_normal();  // an absolute name replaces the folder
  std::error_code error;
  if (fs::is_directory(path, error)) {
    folder_ = path;
    typed_ = purpose.suggested_name;
    read_folder(purpose);
    return {};
  }
  if (purpose.must_exist && !fs::exists(path, error)) {
    problem_ = "There is no file " + path.string();
    return {};
  }
  folder_ = path.parent_path();
  return path;
}

void FileBrowser::draw_path(const Frame& frame, const BrowserPurpose& purpose) {
  ImGui::BeginDisabled(!folder_.has_relative_path());
  if (ImGui::Button("Up")) {
    folder_ = folder_.parent_path();
    read_folder(purpose);
  }
  ImGui::EndDisabled();
  tooltip("To the folder above");
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  muted(frame, fitted(shown_folder(folder_), ImGui::GetContentRegionAvail().x));
}

bool FileBrowser::draw_entry(const Frame& frame, const Entry& entry) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const std::string label = entry.folder ? entry.name + "/" : entry.name;
  const auto flags = ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowDoubleClick;
  const bool pressed = ImGui::Selectable(label.c_str(), typed_ == entry.name, flags);
  ImGui::TableNextColumn();
  if (!entry.folder) {
    ImGui::PushStyleColor(ImGuiCol_Text, frame.colors.text_muted);
    text_right(scene::bytes_text(entry.bytes));
    ImGui::PopStyleColor();
  }
  return pressed;
}

void FileBrowser::draw_entries(const Frame& frame, const BrowserPurpose& purpose) {
  const float below =
      static_cast<float>(2 + purpose.option_rows) * ImGui::GetFrameHeightWithSpacing();
  const float height = std::max(5 * em(), ImGui::GetContentRegionAvail().y - below);
  const auto flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersOuter;
  if (!ImGui::BeginTable("entries", 2, flags, {0, height})) return;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("size", ImGuiTableColumnFlags_WidthFixed, 5 * em());
  std::optional<std::string> enter;
  for (const Entry& entry : entries_) {
    if (!draw_entry(frame, entry)) continue;
    if (entry.folder && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) enter = entry.name;
    typed_ = entry.folder ? purpose.suggested_name : entry.name;
    chosen_ = chosen_ || (!entry.folder && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left));
  }
  if (entries_.empty()) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    muted(frame, "Nothing to open here");
  }
  ImGui::EndTable();
  if (!enter) return;
  folder_ /= *enter;
  read_folder(purpose);
}

std::optional<fs::path> FileBrowser::draw(Frame& frame, const BrowserPurpose& purpose) {
  draw_path(frame, purpose);
  draw_entries(frame, purpose);
  ImGui::SetNextItemWidth(-1);
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::PushID(times_shown_);
  chosen_ = text_input("##name", typed_, "A name in this folder, or a whole path") || chosen_;
  ImGui::PopID();
  tooltip("A name in this folder, or a whole path");
  if (purpose.options) purpose.options(frame);
  const float width = 6 * em();
  const float rest = ImGui::GetContentRegionAvail().x - 2 * width - ImGui::GetStyle().ItemSpacing.x;
  ImGui::PushStyleColor(ImGuiCol_Text, frame.colors.bad);
  ImGui::AlignTextToFramePadding();
  text(fitted(problem_.empty() ? purpose.problem : problem_, std::max(0.0f, rest - em())));
  ImGui::PopStyleColor();
  same_line_right(2 * width + ImGui::GetStyle().ItemSpacing.x);
  if (ImGui::Button("Cancel", {width, 0})) frame.emit("dialog none");
  ImGui::SameLine();
  const bool ready = !typed_.empty() && purpose.problem.empty();
  ImGui::BeginDisabled(!ready);
  chosen_ = ImGui::Button(purpose.button, {width, 0}) || chosen_;
  ImGui::EndDisabled();
  if (!std::exchange(chosen_, false) || !ready) return {};
  return accept(purpose);
}

}  // namespace aomd::ui
