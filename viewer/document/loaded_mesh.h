#pragma once
// A mesh with all that a session keeps about it, made from a file or a generator on any thread.

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/decimate/decimation.h"
#include "core/io/journal_file.h"
#include "core/mesh/column.h"
#include "core/mesh/journal.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_data.h"
#include "core/model/classify.h"
#include "core/model/discrete_model.h"
#include "viewer/base/box.h"
#include "viewer/base/up_axis.h"
#include "viewer/document/drawing_needs.h"
#include "viewer/document/file_watch.h"
#include "viewer/document/load_request.h"
#include "viewer/document/skin.h"

namespace aomd::scene {

/// A CAD model that was given for the mesh.
struct GivenModel {
  std::filesystem::path file;
  std::unique_ptr<const Model> model;
  std::array<std::size_t, 4> counts{};  ///< of its entities, by dimension
  /// The mesh is known to lie on it from this step to the next classification; none: not known.
  std::optional<std::size_t> fits_from;
};

/// The faceted original: the mesh as it was after a step, with that step's classification.
struct FacetedOriginal {
  std::size_t step = 0;
  std::unique_ptr<const DiscreteModel> model;
};

/// The vertices at which an array on corners has a seam, sorted.
struct VertexSeams {
  std::string array;
  std::vector<Vertex> vertices;
};

/// Not movable: the mesh, its journal and its decimation hold on to each other.
struct LoadedMesh {
  std::string name;                ///< "bunny.ply", or a sample's name
  std::filesystem::path file;      ///< empty for a sample
  std::optional<FileStamp> stamp;  ///< of that file when reading began
  LoadRequest source;              ///< what it was made from; names nothing for plain data
  std::optional<io::MeshFingerprint>
      start;                       ///< of the mesh as loaded, where the source asks for it
  UpAxis up = UpAxis::Z;           ///< what the source usually means by up
  std::vector<std::string> notes;  ///< what the reader had to do
  Box bounds;                      ///< of the vertices that can be seen
  Mesh mesh;
  std::uint64_t revision = 0;  ///< of the mesh as loaded
  Journal journal;
  std::vector<Attribute> corners;  ///< what the file has on the corners of faces
  std::vector<Remark> remarks;     ///< and what it says of the whole,
  Appearance appearance;           ///< and of the looks of faces: a Mesh holds none of it
  std::vector<VertexSeams> seams;  ///< of those that have one
  ClassifyOptions classify_options;
  ClassifyResult classified;
  /// Mean at each vertex as loaded; empty for quads, and before prepare_lengths().
  Column<Vertex, double> edge_lengths;
  /// The file's own classification by level and id; empty where it has none. It wins over derived
  /// ones.
  std::array<std::vector<ModelRef>, 3> file_classes;
  /// What is drawn of a mesh with regions or quads; none for triangles, which are drawn as they
  /// are.
  std::optional<Skin> skin;
  DrawingNeeds needs;  ///< a volume has none before it is prepared: what its file lists is stored
  std::string_view obstacle;  ///< why it cannot be decimated, as a sentence; empty where it can
  std::uint32_t stays = 0;    ///< regions that are no tetrahedra, which decimation leaves
  bool prepared = false;      ///< what prepare_volume() does has been done
  std::optional<GivenModel> model;          ///< none until one is given
  std::optional<FacetedOriginal> original;  ///< none until smoothing is to keep to it
  std::optional<Decimation> decimation;     ///< last: it points at the mesh and a model

  [[nodiscard]] bool classified_by_file() const { return !file_classes[0].empty(); }
  [[nodiscard]] bool volume() const { return mesh.count(3) > 0; }
  /// What a decimation counts down: faces, of a volume tetrahedra.
  [[nodiscard]] std::uint32_t cells() const {
    return volume() ? mesh.count(3) - stays : mesh.count(2);
  }
};

/// Reads or generates, builds the mesh and classifies it. Takes as long as it takes: about a second
/// for a million faces. Throws what io::read and make_sample throw, and io::ReadError for a file
/// without faces and regions, and for work that does not fit it.
[[nodiscard]] std::unique_ptr<LoadedMesh> load(const LoadRequest& request);

/// Gives a volume with tetrahedra what decimating it takes and no history may hold: the
/// classification of all that its file leaves out, all edges as entities, and the faces on model
/// faces. Faces that its file lists inside of regions stay; then all others are entities too. Only
/// while nothing is recorded. Takes about a second for a million regions.
void prepare_volume(LoadedMesh& loaded);

/// Measures the edges of a mesh to which nothing has been done, where that is not known yet; not of
/// quads. A volume must be prepared. O(edges).
void prepare_lengths(LoadedMesh& loaded);

/// That of the mesh as it is now.
[[nodiscard]] Skin whole_skin(const LoadedMesh& loaded);

/// Builds from plain data: the rest of load(), and a way in for tests.
[[nodiscard]] std::unique_ptr<LoadedMesh> make_loaded(const MeshData& data, std::string name,
                                                      const ClassifyOptions& options = {});

}  // namespace aomd::scene
