#include "viewer/scene/line_help.h"

#include <algorithm>
#include <array>

#include "viewer/scene/commands.h"

namespace aomd::scene {
namespace {

constexpr std::array lines = std::to_array<LineHelp>({
    {"dialog open", "Chooses a mesh file to open."},
    {"dialog save", "Chooses where to save the present mesh, with its classification."},
    {"dialog screenshot", "Chooses where to save a picture of the window."},
    {"dialog shortcuts", "Lists what keys and mouse do."},
    {"dialog about", "Says what this program is."},
    {"dialog recovery", "Lists the work that a program left that ended before it was saved."},
    {"dialog lessons", "Lists the lessons: a few minutes each, on small meshes."},
    {"palette", "Finds a command by its name or by what it does, and runs it."},
    {"copy counts", "Copies the counts and the memory as text."},
    {"copy legend", "Copies what the mesh lies on as text, with the number of mesh entities on each."},
    {"copy adjacency", "Copies the table T(I,J) as text."},
    {"copy hashes", "Copies how full each hash set is as text."},
    {"copy ids", "Copies the id stacks as text."},
    {"copy strategies", "Copies what both strategies cost as text."},
    {"copy refusals", "Copies how many edges the last sweep refused for each reason as text."},
    {"copy sweeps", "Copies a row for each sweep as text: what it did and refused."},
    {"adjacency 0 3 on", "Stores T(0,3): the regions around each vertex."},
    {"strategies run", "Runs both strategies on copies of this mesh and measures memory and time."},
    {"hash-sets toggle", "Opens or closes the section on hash sets."},
    {"ids toggle", "Opens or closes the section on id stacks."},
    {"strategies toggle", "Opens or closes the section on the paper's two ways to store adjacencies."},
    {"feature-angle 20", "Takes edges whose faces meet at more than 20 degrees for model edges."},
    {"feature-angle 70", "Takes edges whose faces meet at more than 70 degrees for model edges."},
    {"step", "Makes one new operation: a collapse, else a swap or a smoothed vertex."},
    {"step -1", "Takes one operation back."},
    {"step -100", "Takes 100 operations back."},
    {"forward", "Goes one operation forward; at the end of the history it makes a new one."},
    {"forward 100", "Goes 100 operations forward; at the end of the history it makes new ones."},
    {"sweep", "Tries each edge once, to the end of the present sweep: what is too short collapses."},
    {"swap", "One pass of edge swaps, where that makes the smallest angle larger."},
    {"smooth", "One pass of smoothing: vertices move to the middle of their neighbours."},
    {"cancel", "Stops what goes on: a run, loading, playing, exporting or comparing."},
    {"reset", "Back to the mesh as loaded; redo brings all of it again."},
    {"seek 0", "Goes back to the mesh as loaded."},
    {"seek end", "Goes to the end of the history, the last operation."},
    {"seek next", "Goes on to where the next command begins."},
    {"seek previous", "Goes back to where the present command began."},
    {"seek next-phase", "Goes on past the operations of the present kind: collapses, swaps or smoothing."},
    {"seek previous-phase", "Goes back to before the operations of the present kind."},
    {"play-speed faster", "Plays faster, operations a second."},
    {"play-speed slower", "Plays slower, operations a second."},
    {"play toggle", "Plays the history on from here, or pauses it."},
    {"bookmark", "Gives the present place of the history a name, to come back to."},
    {"select none", "Lets go of everything that is selected."},
    {"select grow", "Selects what lies around the selection as well."},
    {"assign", "Puts the selection on a model entity that you choose."},
    {"fit", "Shows the whole mesh, from the present direction."},
    {"fit selection", "Shows what is selected, with its surroundings."},
    {"camera iso", "Looks from a corner, so that three sides show."},
    {"camera front", "Looks from the front."},
    {"camera back", "Looks from behind."},
    {"camera left", "Looks from the left."},
    {"camera right", "Looks from the right."},
    {"camera top", "Looks from above."},
    {"camera bottom", "Looks from below."},
    {"camera copy", "Copies where the camera stands as text."},
    {"camera paste", "Puts the camera where a copied text says."},
    {"camera orthographic", "Draws without perspective: what is parallel stays parallel."},
    {"camera perspective", "Draws with perspective: what is far is small."},
    {"zoom 1.25", "Shows things a quarter larger."},
    {"zoom 0.8", "Shows things a fifth smaller."},
    {"color classification", "Colours by what each face lies on: a colour for each model entity."},
    {"color spacing", "Colours by the spacing: how long decimation wants edges to be, in the mesh's units."},
    {"color quality", "Colours by the smallest angle of each face, degrees."},
    {"color distance", "Colours by the distance to the mesh as loaded, percent of its diagonal."},
    {"color curvature", "Colours by how strongly the surface bends, 1 / unit of the mesh."},
    {"color verdict", "Colours each edge by why it would be refused now."},
    {"color none", "Draws the surface in one colour."},
    {"labels toggle", "Writes ids at what is selected and around the mouse, or does not."},
    {"show edges toggle", "Shows the edges of the mesh, or hides them."},
    {"show model-edges toggle", "Shows the lines where model faces meet, or hides them."},
    {"show model-vertices toggle", "Shows the dots at model vertices, or hides them."},
    {"show operation toggle", "Points out what the last single step touched, or does not."},
    {"show original toggle", "Draws the mesh as loaded over the present one, as glass, or does not."},
    {"compare toggle", "Shows the mesh as loaded beside the present one, or ends that."},
    {"clip x 0.5", "Cuts the picture open across x, in the middle of the mesh as loaded."},
    {"clip off", "Ends clipping: all of the mesh shows again."},
    {"hide", "Shows everything that was hidden."},
    {"theme toggle", "Changes between light and dark."},
    {"panel all toggle", "Hides all panels, so that the picture has the whole window, or shows them."},
    {"panel decimation on", "How to coarsen this surface: what to aim at, the limits, and Run."},
    {"panel adjacency on",
     "Which neighbours are stored for each level, what they cost in bytes, and who holds them."},
    {"panel histograms on", "How angles, edge lengths and valences are spread, as loaded and now."},
    {"panel selection on", "What is selected: what it lies on, its neighbours, and why it stays."},
    {"panel runs toggle", "Shows what each finished run came to, to compare and to go back to, or hides it."},
    {"runs keep", "Keeps the present mesh as a row among the runs."},
    {"copy runs", "Copies the table of runs as text."},
    {"compare with original", "Puts the mesh as loaded back in the place of the run that stood there."},
    {"panel timeline toggle", "Shows the history along the bottom, or hides it."},
    {"panel mesh toggle", "Shows the counts and the classification on the left, or hides them."},
    {"dismiss", "Closes this message."},
    {"lesson next", "Turns to the lesson's next page."},
    {"lesson back", "Turns to the lesson's page before."},
    {"lesson show", "The page of the lesson."},
    {"lesson hide", "Counts, legend and classification of the lesson's mesh; the lesson stays open."},
    {"lesson hint", "Shows a hint for this task, or hides it."},
    {"lesson solve", "Does the task, to see what it leads to."},
    {"lesson restart", "Sets this page up again as it was when you came to it."},
    {"lesson off", "Leaves the lesson, and puts back the mesh and the view from before."},
    {"unsaved save", "Saves the mesh, then goes on."},
    {"unsaved discard", "Goes on without saving: the changes are lost."},
    {"unsaved cancel", "Goes back to the mesh; nothing is lost."},
});

}  // namespace

std::span<const LineHelp> helped_lines() { return lines; }

std::string_view line_help(std::string_view line) {
  const auto known =
      std::find_if(lines.begin(), lines.end(), [&](const LineHelp& each) { return each.line == line; });
  if (known != lines.end()) return known->help;
  const std::string_view name = line.substr(0, line.find(' '));
  for (const Command& command : commands())
    if (command.name == name) return command.help;
  return {};
}

}  // namespace aomd::scene
