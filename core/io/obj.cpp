// Wavefront OBJ. tinyobjloader reads the elements, groups, objects and materials; a first pass
// (obj_text.h) checks the text and keeps what tinyobjloader loses.

#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <istream>
#include <map>
#include <streambuf>

#include "core/base/text.h"
#include "core/io/byte_writer.h"
#include "core/io/class_names.h"
#include "core/io/face_sink.h"
#include "core/io/formats.h"
#include "core/io/obj_text.h"

namespace aomd::io::detail {
namespace {

/// Lets a stream read a string in place.
class StringBuffer : public std::streambuf {
 public:
  explicit StringBuffer(std::string& text) {
    setg(text.data(), text.data(), text.data() + text.size());
  }
};

/// The names that one keyword gives, numbered as they come, and the one that holds now.
class Names {
 public:
  void enter(const std::string& name) {
    current_ = numbers_.try_emplace(name, static_cast<std::uint32_t>(names_.size())).first->second;
    if (current_ == names_.size()) names_.push_back(name);
  }
  [[nodiscard]] std::uint32_t current() const { return current_; }
  [[nodiscard]] const std::string& operator[](std::uint32_t i) const { return names_[i]; }

 private:
  std::vector<std::string> names_{""};
  std::map<std::string, std::uint32_t> numbers_{{"", 0}};
  std::uint32_t current_ = 0;
};

/// Receives tinyobjloader's elements. Faces are first classified by their part, a combination of
/// group, object and material; finish() then decides which of the three counts.
class ObjReader {
 public:
  explicit ObjReader(const Source& source)
      : source_(source), text_(scan_obj(source)), faces_(text_.positions.size(), 1) {}

  ReadResult read() {
    faces_.reserve(text_.face_offsets.size());
    load();
    if (vertices_ != text_.positions.size() || face_ != text_.face_offsets.size()) {
      source_.fail("tinyobjloader does not find the vertices and faces that the text holds");
    }
    ReadResult result;
    result.format = Format::Obj;
    result.mesh.positions = std::move(text_.positions);
    for (const ObjText::Line& line : text_.lines) {
      const std::string wrong = faces_.add_edge(line.a, line.b);
      if (!wrong.empty()) source_.fail_at_line(line.offset, wrong);
    }
    faces_.drop(text_.short_faces, text_.short_lines);
    faces_.finish(result.mesh, result.notes);
    classify(result);
    note_left_out(result.notes, text_.left_out);
    drop_empty_classes(result.mesh);
    return result;
  }

 private:
  using Part = std::array<std::uint32_t, 3>;
  enum Level { Groups, Objects, Materials };

  void load() {
    tinyobj::callback_t callback;
    callback.vertex_cb = [](void* self, double, double, double, double) { ++of(self).vertices_; };
    callback.index_cb = [](void* self, tinyobj::index_t* corners, int n) {
      of(self).face(corners, n);
    };
    callback.group_cb = [](void* self, const char** names, int n) {
      of(self).enter(Groups, joined(names, n));
    };
    callback.object_cb = [](void* self, const char* name) { of(self).enter(Objects, name); };
    callback.usemtl_cb = [](void* self, const char* name, int) { of(self).enter(Materials, name); };
    StringBuffer buffer(text_.cleaned);
    std::istream stream(&buffer);
    std::string warning, error;
    if (!tinyobj::LoadObjWithCallback(stream, callback, this, nullptr, &warning, &error)) {
      source_.fail("tinyobjloader: " + error.substr(0, error.find('\n')));
    }
  }

  static ObjReader& of(void* self) { return *static_cast<ObjReader*>(self); }

  static std::string joined(const char** names, int n) {
    std::string all;
    for (int i = 0; i < n; ++i) {
      if (i > 0) all += ' ';
      all += names[i];
    }
    return all;
  }

  void enter(Level level, const std::string& name) {
    names_[level].enter(name.substr(0, name.find_last_not_of(" \t\r") + 1));
    part_known_ = false;
  }

  void face(const tinyobj::index_t* corners, int n) {
    polygon_.clear();
    for (int i = 0; i < n; ++i) {
      const std::int64_t index = corners[i].vertex_index;
      polygon_.push_back(index > 0 ? index - 1 : static_cast<std::int64_t>(vertices_) + index);
    }
    if (!part_known_) find_part();
    const std::string wrong = faces_.add(polygon_, ModelRef(2, part_));
    if (!wrong.empty()) source_.fail_at_line(text_.face_offsets[face_], wrong);
    ++face_;
  }

  void find_part() {
    const Part part{names_[Groups].current(), names_[Objects].current(),
                    names_[Materials].current()};
    part_ = part_numbers_.try_emplace(part, static_cast<std::int32_t>(parts_.size())).first->second;
    if (static_cast<std::size_t>(part_) == parts_.size()) parts_.push_back(part);
    part_known_ = true;
  }

  void classify(ReadResult& result) const {
    constexpr const char* words[] = {"group", "object", "material"};
    for (const Level level : {Groups, Objects, Materials}) {
      std::vector<std::string> names;
      const std::vector<std::size_t> name_of_part = names_in_use(level, names);
      const std::vector<ModelRef> classes = classes_of_parts(names);
      const bool useful =
          std::any_of(classes.begin(), classes.end(), [](ModelRef m) { return m.valid(); });
      if (!useful && level != Materials) continue;
      for (ModelRef& m : result.mesh.faces.classes)
        m = classes[name_of_part[static_cast<std::size_t>(m.tag())]];
      if (useful)
        result.notes.push_back("faces classified by " + counted(names.size(), words[level]));
      return;
    }
  }

  /// The names that faces carry at one level, in order of first use, and for each part the position
  /// of its own.
  std::vector<std::size_t> names_in_use(Level level, std::vector<std::string>& names) const {
    std::vector<std::size_t> position;
    std::map<std::uint32_t, std::size_t> seen;
    for (const Part& part : parts_) {
      const auto [at, is_new] = seen.try_emplace(part[level], names.size());
      if (is_new) names.push_back(names_[level][part[level]]);
      position.push_back(at->second);
    }
    return position;
  }

  const Source& source_;
  ObjText text_;
  FaceSink faces_;
  std::size_t vertices_ = 0, face_ = 0;
  std::array<Names, 3> names_;
  std::vector<Part> parts_;
  std::map<Part, std::int32_t> part_numbers_;
  std::int32_t part_ = 0;
  bool part_known_ = false;
  std::vector<std::int64_t> polygon_;
};

}  // namespace

ReadResult read_obj(const Source& source) { return ObjReader(source).read(); }

std::string write_obj(const MeshData& mesh) {
  ByteWriter out;
  out.reserve(48 * mesh.positions.size() + 24 * mesh.faces.size());
  out << "# AOMD Studio\n";
  for (const glm::dvec3& p : mesh.positions) out << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
  const auto element = [&](std::string_view keyword, std::span<const std::uint32_t> vertices) {
    out << keyword;
    for (const std::uint32_t v : vertices) out << ' ' << std::uint64_t{v} + 1;
    out << '\n';
  };
  for_each_entity(mesh.edges, [&](auto vertices, ModelRef) { element("l", vertices); });
  const bool classified = !mesh.faces.classes.empty();
  ModelRef group;
  bool first = true;
  for_each_entity(mesh.faces, [&](auto vertices, ModelRef model) {
    if (classified && (first || model != group)) out << "g " << class_name(model) << '\n';
    group = model;
    first = false;
    element("f", vertices);
  });
  return out.take();
}

}  // namespace aomd::io::detail
