#pragma once
// Chooses a file to open, or a name to save under, inside ImGui.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "viewer/ui/frame.h"

namespace aomd::ui {

struct BrowserPurpose {
  const char* title;                    ///< "Open a mesh"
  const char* button;                   ///< "Open"
  std::vector<std::string> extensions;  ///< ".ply", lower case
  bool must_exist = true;
  std::string suggested_name = {};  ///< where a file need not exist
  /// Draws so many rows of controls below the name; what they say is wrong keeps from going on.
  std::function<void(Frame&)> options = {};
  int option_rows = 0;
  std::string problem = {};
};

/// Folders first, then files with the wanted extensions. Remembers its folder.
class FileBrowser {
 public:
  /// To be called when the dialog appears.
  void begin(const BrowserPurpose& purpose);
  void set_folder(const std::filesystem::path& folder);
  /// Draws the content of the dialog. The file that was chosen, once.
  [[nodiscard]] std::optional<std::filesystem::path> draw(Frame& frame,
                                                          const BrowserPurpose& purpose);

 private:
  struct Entry {
    std::string name;
    bool folder = false;
    std::uintmax_t bytes = 0;
  };
  void read_folder(const BrowserPurpose& purpose);
  void draw_path(const Frame& frame, const BrowserPurpose& purpose);
  void draw_entries(const Frame& frame, const BrowserPurpose& purpose);
  [[nodiscard]] bool draw_entry(const Frame& frame, const Entry& entry);
  /// Goes into a folder, or answers the file that is meant.
  [[nodiscard]] std::optional<std::filesystem::path> accept(const BrowserPurpose& purpose);

  std::filesystem::path folder_;
  std::vector<Entry> entries_;
  std::string typed_;    ///< a name in the folder, or a whole path
  std::string problem_;  ///< why the folder or the name will not do
  bool chosen_ = false;
  int times_shown_ =
      0;  ///< the field of each time is one of its own: ImGui would go on with the last one
};

}  // namespace aomd::ui
