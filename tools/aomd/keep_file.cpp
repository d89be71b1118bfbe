#include "tools/aomd/keep_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <string>

#include "core/base/text.h"
#include "core/io/medit.h"
#include "core/io/text_cursor.h"
#include "core/io/text_file.h"
#include "core/model/model.h"

namespace aomd::cli {
namespace {

using Kept = Column<Vertex, std::uint8_t>;

std::optional<std::uint64_t> whole_number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

/// What a model entity in a list stands for: the vertices of all that lies on it, or only those
/// that lie on it themselves.
enum class OfClass { AllVertices, ItsVertices };

class VertexList {
 public:
  VertexList(const io::detail::Source& source, const Mesh& mesh, OfClass of_class)
      : source_(source),
        mesh_(mesh),
        of_class_(of_class),
        cursor_(source, source.bytes, 0, '#'),
        listed_(mesh.capacity(0), 0) {}

  Kept read() {
    while (!cursor_.skip_to_content()) {
      item();
      cursor_.end_line();
    }
    list_classes();
    return std::move(listed_);
  }

 private:
  void item() {
    const std::string word = lower(cursor_.word());
    constexpr std::array<std::string_view, 4> dimensions = {"vertex", "edge", "face", "region"};
    const auto found = std::find(dimensions.begin(), dimensions.end(), word);
    if (found == dimensions.end()) return list_range(word);
    const std::int64_t tag = cursor_.integer("the tag of a model entity");
    if (tag < ModelRef::min_tag || tag > ModelRef::max_tag)
      cursor_.fail("no model entity has such a tag");
    classes_.insert(
        {ModelRef(static_cast<int>(found - dimensions.begin()), static_cast<std::int32_t>(tag)),
         {cursor_.offset(), false}});
  }

  void list_range(std::string_view word) {
    const std::size_t dash = std::min(word.find('-'), word.size());
    const auto first = whole_number(word.substr(0, dash));
    const auto last = dash == word.size() ? first : whole_number(word.substr(dash + 1));
    if (!first || !last)
      cursor_.fail("expected a vertex, a range like 10-20 or a model entity like face 2, found " +
                   shown(word));
    if (*first > *last) cursor_.fail("the range " + shown(word) + " ends before it begins");
    if (*last >= mesh_.capacity(0))
      cursor_.fail("there is no vertex " + std::to_string(*last) + ": the mesh has " +
                   std::to_string(mesh_.capacity(0)) + ", counted from 0");
    for (std::uint64_t id = *first; id <= *last; ++id)
      listed_[Vertex(static_cast<std::uint32_t>(id))] = 1;
  }

  // One pass over the mesh for all of them.
  void list_classes() {
    if (classes_.empty()) return;
    for (int dim = 0; dim < 4; ++dim)
      for (std::uint32_t id = 0; id < mesh_.capacity(dim); ++id)
        if (mesh_.alive({dim, id})) list_vertices_of({dim, id});
    for (const auto& [ref, entry] : classes_)
      if (!entry.found) source_.fail_at_line(entry.offset, "nothing lies on " + name_of(ref));
  }

  void list_vertices_of(EntityRef e) {
    const auto listed = classes_.find(mesh_.classification(e));
    if (listed == classes_.end()) return;
    listed->second.found = true;
    if (e.dimension == 0) {
      listed_[Vertex(e.index)] = 1;
      return;
    }
    if (of_class_ == OfClass::ItsVertices) return;
    VertexBuffer buffer;
    for (const std::uint32_t v : mesh_.vertices_of(e, buffer)) listed_[Vertex(v)] = 1;
  }

  struct Entry {
    std::size_t offset;  ///< in the file, for messages
    bool found;
  };

  const io::detail::Source& source_;
  const Mesh& mesh_;
  OfClass of_class_;
  io::detail::TextCursor cursor_;
  Kept listed_;
  std::map<ModelRef, Entry> classes_;
};

/// Marks the vertices of what has the mark of Medit.
template <class H>
void mark_required(const Mesh& mesh, Kept& required) {
  const auto* marks = mesh.find_attached<H, std::int64_t>(io::detail::medit_required);
  for (std::uint32_t id = 0; marks && id < mesh.capacity(H::dimension); ++id) {
    if (!mesh.alive({H::dimension, id}) || (*marks)[H(id)] == 0) continue;
    if constexpr (H::dimension == 0) {
      required[Vertex(id)] = 1;
    } else {
      VertexBuffer buffer;
      for (const std::uint32_t v : mesh.vertices_of({H::dimension, id}, buffer))
        required[Vertex(v)] = 1;
    }
  }
}

}  // namespace

std::shared_ptr<const Kept> keep_required(const Mesh& mesh, const std::shared_ptr<const Kept>& keep,
                                          std::size_t& required) {
  Kept kept(mesh.capacity(0), 0);
  mark_required<Vertex>(mesh, kept);
  mark_required<Edge>(mesh, kept);
  mark_required<Face>(mesh, kept);
  required = 0;
  for (std::uint32_t id = 0; id < mesh.capacity(0); ++id) {
    required += kept[Vertex(id)];
    if (keep && (*keep)[Vertex(id)] != 0) kept[Vertex(id)] = 1;
  }
  return required == 0 ? keep : std::make_shared<const Kept>(std::move(kept));
}

std::shared_ptr<const Kept> read_keep_file(const std::filesystem::path& file, const Mesh& mesh) {
  const io::detail::TextFile text(file);
  return std::make_shared<const Kept>(VertexList(text.source(), mesh, OfClass::AllVertices).read());
}

std::shared_ptr<const Kept> read_only_file(const std::filesystem::path& file, const Mesh& mesh,
                                           const std::shared_ptr<const Kept>& keep) {
  const io::detail::TextFile text(file);
  Kept kept = VertexList(text.source(), mesh, OfClass::ItsVertices).read();
  for (const Vertex v : mesh.vertices()) kept[v] = kept[v] == 0 || (keep && (*keep)[v] != 0);
  return std::make_shared<const Kept>(std::move(kept));
}

}  // namespace aomd::cli
