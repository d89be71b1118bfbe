// What leaves the program besides the mesh: pictures, series of them, tables.

#include <algorithm>
#include <string>

#include "core/io/io.h"
#include "core/io/png.h"
#include "viewer/commands/command_groups.h"
#include "viewer/commands/tables.h"

namespace aomd::scene {
namespace {

constexpr long long most_pictures = 100'000;

/// A picture that can be read again (io::max_image_pixels).
glm::ivec2 picture_size(Arguments& arguments) {
  const glm::ivec2 size = arguments.size();
  if (static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y) >
      io::max_image_pixels)
    arguments.fail("a picture has at most " + std::to_string(io::max_image_pixels >> 20) +
                   " million pixels (8192x8192)");
  return size;
}

void screenshot(Session& session, Arguments& arguments) {
  ScreenshotRequest request;
  request.file = expanded(arguments.word("a file"));
  while (!arguments.done()) {
    Arguments again = arguments;
    const std::string word = again.word("a size, transparent, no-ui or scale");
    if (word == "transparent")
      request.transparent = true;
    else if (word == "no-ui")
      request.interface = false;
    else if (word == "scale")
      request.scale = again.number("a factor", 0.25, 8);
    else
      request.size = picture_size(again = arguments);
    arguments = again;
  }
  session.screenshots.push_back(std::move(request));
}

void export_series(Session& session, Arguments& arguments) {
  const std::string kind = arguments.one_of({"turntable", "history"});
  const std::filesystem::path folder = expanded(arguments.word("a folder"));
  const auto is_size = [&] {
    Arguments again = arguments;
    return again.word("a size").find('x') != std::string::npos;
  };
  int count = 60;
  if (!arguments.done() && !is_size())
    count = static_cast<int>(arguments.integer("a number of pictures", 1, most_pictures));
  std::optional<glm::ivec2> size;
  if (!arguments.done()) size = picture_size(arguments);
  arguments.end();
  need_mesh(session);
  session.view.dialog = Dialog::None;
  session.start_series(
      kind == "history" ? PictureSeries::Kind::History : PictureSeries::Kind::Turntable, folder,
      count, size);
}

void copy(Session& session, Arguments& arguments) {
  const auto names = table_names();
  const std::string table = arguments.one_of({names.begin(), names.end()});
  const std::string file = arguments.done() ? "" : arguments.rest("a file");
  need_mesh(session);
  session.refresh();
  const bool json = table == "strategies" && std::filesystem::path(file).extension() == ".json";
  if (json && !session.sheet().storage())
    arguments.fail("nothing has been compared yet: 'strategies run'");
  const std::string text =
      json ? storage_json(*session.sheet().storage()) : table_text(session, table);
  if (file.empty())
    session.clipboard.set(text);
  else
    io::write_file(expanded(file), text);
  session.status = file.empty() ? "Copied the table " + table : "Saved " + file;
}

}  // namespace

std::vector<Command> output_commands() {
  return {
      {"screenshot",
       "FILE [WxH] [transparent] [no-ui] [scale F]",
       "Writes a PNG of everything that is shown, as large as the window or WxH, which may be "
       "larger; "
       "transparent leaves out what is behind the mesh, no-ui the panels. scale makes text, lines "
       "and dots F times as large; without it they are as in the window, but larger in pictures "
       "without panels of more than 1080 pixels each way.",
       CommandGroup::File,
       screenshot,
       {{"Ctrl+P", "dialog screenshot"}}},
      {"export",
       "turntable|history DIR [N] [WxH]",
       "Writes N numbered PNGs, 60 where no number is given, without panels: of one turn around "
       "the mesh, or "
       "of its history from the mesh as loaded to the last operation. cancel stops it.",
       CommandGroup::File,
       export_series,
       {}},
      {"copy",
       "counts|legend|adjacency|hashes|ids|strategies|refusals|sweeps|runs|selection [FILE]",
       "Copies a table as text, columns separated by tabs, to the clipboard or into a file; "
       "strategies into "
       "a file named .json as JSON.",
       CommandGroup::File,
       copy,
       {}},
  };
}

}  // namespace aomd::scene
