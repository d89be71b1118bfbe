#include "viewer/document/whole_data.h"

#include <utility>

#include "core/io/left_out.h"

namespace aomd::scene {
namespace {

/// What a Mesh does not hold, as the file has it.
void add_from_file(const Document& document, MeshData& data) {
  data.remarks = document.content().remarks;
  data.appearance = document.content().appearance;
  data.corners = document.content().corners;
}

}  // namespace

MeshData whole_as_loaded(Document& document) {
  MeshData data = to_data(document.copy_mesh_as_loaded().mesh());
  add_from_file(document, data);
  return data;
}

WholeData whole_data_of(Document& document, MeshData state) {
  WholeData whole{std::move(state), {}};
  whole.data.remarks = document.content().remarks;
  whole.data.appearance = document.content().appearance;
  if (whole.data.attributes.empty() && document.content().corners.empty()) return whole;
  MeshData loaded;
  if (document.can_look_back())
    loaded = whole_as_loaded(document);
  else
    add_from_file(document, loaded);
  whole.notes = io::carry_along(loaded, whole.data).notes;
  return whole;
}

WholeData whole_data(Document& document) {
  MeshData data = to_data(document.mesh());
  if (document.journal().cursor() > 0) return whole_data_of(document, std::move(data));
  add_from_file(document, data);
  return {std::move(data), {}};
}

}  // namespace aomd::scene
