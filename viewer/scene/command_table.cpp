// The table of commands.

#include "viewer/scene/command_handlers.h"

namespace aomd::scene {
namespace {

constexpr auto File = CommandGroup::File;
constexpr auto Options = CommandGroup::Options;
constexpr auto Operations = CommandGroup::Operations;
constexpr auto History = CommandGroup::History;
constexpr auto Viewing = CommandGroup::View;
constexpr auto Scripts = CommandGroup::Scripts;

std::vector<Command> make_table() {
  return {
      {"open",
       "FILE",
       "Reads a mesh; the present one stays until the new one is ready.",
       File,
       handle::open,
       {{"Ctrl+O", "dialog open"}}},
      {"sample", "NAME [SIZE]", "Makes one of the built-in meshes.", File, handle::sample, {}},
      {"save",
       "FILE",
       "Writes the mesh with its classification; the extension chooses the format.",
       File,
       handle::save,
       {{"Ctrl+S", "dialog save"}}},
      {"screenshot",
       "FILE [WxH]",
       "Writes a PNG of everything that is shown, as large as the window or WxH.",
       File,
       handle::screenshot,
       {{"Ctrl+P", "dialog screenshot"}}},
      {"quit", "", "Ends the program.", File, handle::quit, {{"Ctrl+Q", "quit"}}},

      {"factor",
       "F",
       "How many times longer edges become where the angle does not bind; 1 and up, 4 at first.",
       Options,
       handle::factor,
       {}},
      {"coarsest", "[on|off]", "No limit on length: the factor is ignored.", Options, handle::coarsest, {}},
      {"angle",
       "DEG",
       "How far a face's normal may turn in one operation, degrees; 10 at first.",
       Options,
       handle::angle,
       {}},
      {"feature-angle",
       "DEG|off",
       "Derives the classification anew: edges past this angle become model edges. What the file says still "
       "wins.",
       Options,
       handle::feature_angle,
       {}},
      {"topology",
       "safe|paper",
       "safe keeps the topology (link condition); paper leaves that check out, and edges with more than two "
       "faces are "
       "not model edges.",
       Options,
       handle::topology,
       {}},
      {"improve-passes",
       "N",
       "How many sweeps are followed by swaps and smoothing; 2 at first.",
       Options,
       handle::improve_passes,
       {}},

      {"adjacency",
       "I J [on|off|toggle]",
       "Stores the relation T(I,J) of levels 0 (vertices) to 3 (regions), or lets go of it. It stays stored "
       "while an algorithm needs it or where it defines entities. Not part of the history.",
       Options,
       handle::adjacency,
       {}},

      {"step",
       "[N]",
       "N single operations; -N takes back as many.",
       Operations,
       handle::step,
       {{"Right", "step"}, {"Left", "step -1"}, {"Shift+Right", "step 100"}, {"Shift+Left", "step -100"}}},
      {"sweep",
       "[N]",
       "Collapses edges to the end of the present sweep.",
       Operations,
       handle::sweep,
       {{"S", "sweep"}}},
      {"swap", "", "One pass of edge swaps.", Operations, handle::swap, {{"W", "swap"}}},
      {"smooth", "", "One pass of vertex smoothing.", Operations, handle::smooth, {{"M", "smooth"}}},
      {"improve",
       "",
       "One pass of swaps, then one of smoothing.",
       Operations,
       handle::improve,
       {{"I", "improve"}}},
      {"run",
       "",
       "Sweeps and improves until nothing is left to do. The window stays live.",
       Operations,
       handle::run,
       {{"R", "run"}}},
      {"cancel",
       "",
       "Stops a run between two operations, drops what is being loaded, stops playing.",
       Operations,
       handle::cancel,
       {{"Escape", "cancel"}}},

      {"undo", "", "Takes back the last command as a whole.", History, handle::undo, {{"Ctrl+Z", "undo"}}},
      {"redo", "", "Does it again.", History, handle::redo, {{"Ctrl+Shift+Z", "redo"}, {"Ctrl+Y", "redo"}}},
      {"seek",
       "N|end",
       "Moves to where N operations are applied.",
       History,
       handle::seek,
       {{"Home", "seek 0"}, {"End", "seek end"}}},
      {"play",
       "[on|off|toggle]",
       "Plays the history from where it stands; from the start when it is at the end.",
       History,
       handle::play,
       {{"Space", "play toggle"}}},
      {"pause", "", "Stops playing.", History, handle::pause, {}},
      {"reset",
       "",
       "Back to the mesh as it was loaded; redo leads forward again.",
       History,
       handle::reset,
       {{"Ctrl+R", "reset"}}},

      {"camera",
       "VIEW|SPEC",
       "iso, front, back, left, right, top, bottom; or azimuth=DEG elevation=DEG distance=L target=X,Y,Z "
       "zoom=F fov=DEG "
       "up=y|z perspective orthographic fit.",
       Viewing,
       handle::camera,
       {{"1", "camera front"},
        {"2", "camera right"},
        {"3", "camera back"},
        {"4", "camera left"},
        {"5", "camera top"},
        {"6", "camera bottom"},
        {"7", "camera iso"}}},
      {"fit", "", "Shows the whole mesh from the present direction.", Viewing, handle::fit, {{"F", "fit"}}},
      {"orbit", "X Y", "Turns the camera to the right and upward, degrees.", Viewing, handle::orbit, {}},
      {"pan",
       "X Y",
       "Shifts the picture to the right and upward, as parts of its width and height.",
       Viewing,
       handle::pan,
       {}},
      {"zoom",
       "F [X Y]",
       "Shows things F times larger, around a place in -1..1 that stays.",
       Viewing,
       handle::zoom,
       {{"+", "zoom 1.25"}, {"=", "zoom 1.25"}, {"-", "zoom 0.8"}}},
      {"color",
       "classification|none",
       "What the surface's colours mean.",
       Viewing,
       handle::color,
       {{"C", "color classification"}, {"N", "color none"}}},
      {"show",
       "surface|edges|model-edges|model-vertices|interfaces|operation [on|off|toggle]",
       "interfaces are the faces between two model regions, seen where something is hidden; operation is "
       "what "
       "the last single step touched.",
       Viewing,
       handle::show,
       {{"E", "show edges toggle"},
        {"B", "show model-edges toggle"},
        {"V", "show model-vertices toggle"},
        {"O", "show operation toggle"}}},
      {"highlight",
       "[vertex|edge|face|region:TAG]",
       "Brightens what lies on one model entity; none without a word.",
       Viewing,
       handle::highlight,
       {}},
      {"hide",
       "[vertex|edge|face|region:TAG [on|off|toggle]]",
       "Hides what lies on one model entity; shows everything without a word. Behind a hidden region its "
       "neighbours show.",
       Viewing,
       handle::hide,
       {{"H", "hide"}}},
      {"theme",
       "light|dark|toggle",
       "The colours of panels and background.",
       Viewing,
       handle::theme,
       {{"T", "theme toggle"}}},
      {"panel",
       "mesh|decimation|adjacency|timeline|all [on|off|toggle]",
       "Which panels are there; decimation and adjacency share the one on the right.",
       Viewing,
       handle::panel,
       {{"Tab", "panel all toggle"}, {"D", "panel decimation on"}, {"A", "panel adjacency on"}}},
      {"dialog",
       "open|save|screenshot|shortcuts|about|none",
       "Opens one of the dialogs.",
       Viewing,
       handle::dialog,
       {{"F1", "dialog shortcuts"}}},
      {"dismiss", "", "Closes the message about an error.", Viewing, handle::dismiss, {}},

      {"expect",
       "QUANTITY = N",
       "Ends a script with exit code 1 unless it holds; also <, >, <=, >=. Quantities: vertices, edges, "
       "faces, regions, "
       "outer-faces (of a volume), euler (over used vertices), boundary, nonmanifold, unused, "
       "model-vertices, model-edges, model-faces, model-regions, "
       "steps, cursor, "
       "commands, refused-classification, refused-topology, refused-angle. Also: expect adjacency I J = "
       "on|off.",
       Scripts,
       handle::expect,
       {}},
      {"wait-idle",
       "",
       "Waits until loading, running and playing have ended.",
       Scripts,
       handle::wait_idle,
       {}},
      {"log", "TEXT", "Prints a line.", Scripts, handle::log, {}},
  };
}

}  // namespace

std::span<const Command> commands() {
  static const std::vector<Command> table = make_table();
  return table;
}

}  // namespace aomd::scene
