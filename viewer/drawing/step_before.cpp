#include "viewer/drawing/step_before.h"

#include <set>
#include <span>

#include "core/base/assertion.h"

namespace aomd::scene {
namespace {

/// Takes back one record after the other, the last first, without touching the mesh.
class Reversal {
 public:
  explicit Reversal(const Mesh& mesh) : mesh_(mesh) {}

  void take_back(std::span<const std::uint32_t> record) {
    const RecordHead head = RecordHead::unpack(record[0]);
    switch (head.kind) {
      case RecordKind::Create:
        if (head.dim != 2) return;
        created_.insert(record[1]);
        faces_.erase(record[1]);
        return;
      case RecordKind::Destroy:
        if (head.dim == 0) moved_[Vertex(record[1])] = unpack_position(&record[3]);
        if (head.dim != 2) return;
        created_.erase(record[1]);  // an id that the step gave to another face later
        if (head.count == 3)
          faces_[record[1]] = {Vertex(record[3]), Vertex(record[4]), Vertex(record[5])};
        return;
      case RecordKind::Rebind:
        for (std::size_t i = head.count; i-- > 0;) rebind_back(&record[1 + 4 * i]);
        return;
      case RecordKind::Move:
        moved_[Vertex(record[1])] = unpack_position(&record[2]);
        return;
      case RecordKind::Classify:
        return;
    }
  }

  [[nodiscard]] StepBefore result() {
    // A smoothing may come out where the vertex was.
    std::erase_if(moved_, [&](const auto& m) {
      return mesh_.alive(m.first) && mesh_.position(m.first) == m.second;
    });
    for (const auto& [v, position] : moved_)
      if (mesh_.alive(v))
        for (const Face f : mesh_.row<2>(v)) was(f.index);
    StepBefore before;
    for (const auto& [id, triangle] : faces_)
      if (!created_.contains(id)) before.faces.push_back(triangle);
    before.moved = std::move(moved_);
    return before;
  }

 private:
  /// dimension << 8 | slot, id, from, to
  void rebind_back(const std::uint32_t* item) {
    if (item[0] >> 8 == 2) was(item[1])[item[0] & 255u] = Vertex(item[2]);
  }
  std::array<Vertex, 3>& was(std::uint32_t face) {
    const auto [at, fresh] = faces_.try_emplace(face);
    if (fresh) at->second = mesh_.triangle(Face(face));
    return at->second;
  }

  const Mesh& mesh_;
  std::map<std::uint32_t, std::array<Vertex, 3>> faces_;
  std::set<std::uint32_t> created_;
  std::map<Vertex, glm::dvec3> moved_;
};

}  // namespace

StepBefore step_before(const Mesh& mesh, const Journal& journal, std::size_t step) {
  AOMD_CHECK(step + 1 == journal.cursor());
  const std::span<const std::uint32_t> records = journal.records(step);
  std::vector<std::size_t> begins;
  for (std::size_t at = 0; at < records.size(); at += RecordHead::unpack(records[at]).length())
    begins.push_back(at);
  Reversal reversal(mesh);
  for (auto at = begins.rbegin(); at != begins.rend(); ++at)
    reversal.take_back(records.subspan(*at, RecordHead::unpack(records[*at]).length()));
  return reversal.result();
}

}  // namespace aomd::scene
