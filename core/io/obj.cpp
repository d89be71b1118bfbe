// Wavefront OBJ. tinyobjloader reads the elements, groups, objects and materials; a first pass
// (obj_text.h) checks the text and keeps what tinyobjloader loses.

#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <istream>
#include <limits>
#include <streambuf>

#include "core/io/corner_values.h"
#include "core/io/face_sink.h"
#include "core/io/formats.h"
#include "core/io/named_parts.h"
#include "core/io/obj_text.h"
#include "core/mesh/handle.h"

namespace aomd::io::detail {
namespace {

/// Lets a stream read a string in place.
class StringBuffer : public std::streambuf {
 public:
  explicit StringBuffer(std::string& text) {
    setg(text.data(), text.data(), text.data() + text.size());
  }
};

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Receives tinyobjloader's elements.
class ObjReader {
 public:
  explicit ObjReader(const Source& source)
      : source_(source), text_(scan_obj(source)), faces_(text_.positions.size(), 1) {}

  ReadResult read() {
    if (!text_.texture.corners.empty() || !text_.normals.corners.empty()) faces_.keep_origins();
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
    parts_.finish(result);
    add_colours(result.mesh);
    add_values(text_.texture, {"uv", 0, 0, false, {}, {}, Meaning::Texture}, result.mesh);
    add_values(text_.normals, {"normal", 0, 0, false, {}, {}, Meaning::Normal}, result.mesh);
    for (std::string& library : text_.libraries)
      result.mesh.remarks.push_back({"mtllib", std::move(library)});
    note_left_out(result.notes, text_.left_out);
    drop_empty_classes(result.mesh);
    return result;
  }

 private:
  void load() {
    tinyobj::callback_t callback;
    callback.vertex_cb = [](void* self, double, double, double, double) { ++of(self).vertices_; };
    callback.index_cb = [](void* self, tinyobj::index_t* corners, int n) {
      of(self).face(corners, n);
    };
    callback.group_cb = [](void* self, const char** names, int n) {
      of(self).enter(NamedParts::Groups, joined(names, n));
    };
    callback.object_cb = [](void* self, const char* name) {
      of(self).enter(NamedParts::Objects, name);
    };
    callback.usemtl_cb = [](void* self, const char* name, int) {
      of(self).enter(NamedParts::Materials, name);
    };
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

  void enter(NamedParts::Level level, const std::string& name) {
    parts_.enter(level, name.substr(0, name.find_last_not_of(" \t\r") + 1));
  }

  void face(const tinyobj::index_t* corners, int n) {
    polygon_.clear();
    for (int i = 0; i < n; ++i) {
      const std::int64_t index = corners[i].vertex_index;
      polygon_.push_back(index > 0 ? index - 1 : static_cast<std::int64_t>(vertices_) + index);
    }
    for (; smoothing_ < text_.smoothing.size() && text_.smoothing[smoothing_].face == face_;
         ++smoothing_)
      enter(NamedParts::Smoothing, std::to_string(text_.smoothing[smoothing_].group));
    const std::string wrong = faces_.add(polygon_, ModelRef(2, parts_.part()));
    if (!wrong.empty()) source_.fail_at_line(text_.face_offsets[face_], wrong);
    ++face_;
  }

  void add_colours(MeshData& mesh) {
    if (text_.colours.numbers.empty()) return;
    mesh.attributes.push_back({"color",
                               0,
                               text_.colours.components,
                               false,
                               std::move(text_.colours.numbers),
                               {},
                               Meaning::Colour});
  }

  /// What the corners name; on vertices where all corners of each agree.
  void add_values(const ObjText::Values& values, Attribute a, MeshData& mesh) {
    if (values.corners.empty()) {
      if (values.size() > 0) text_.left_out.add(a.name + " values that no face names");
      return;
    }
    const auto n = static_cast<std::size_t>(values.components);
    a.components = values.components;
    a.dimension = 2;
    a.values.reserve(n * values.corners.size());
    std::size_t wrong = 0;
    for (const std::uint32_t i : values.corners) {
      wrong += i != no_index && i >= values.size();
      for (std::size_t k = 0; k < n; ++k)
        a.values.push_back(i < values.size() ? values.numbers[n * i + k] : no_number);
    }
    if (wrong > 0) text_.left_out.add(a.name + " indices out of range");
    spread_to_corners(a, faces_.origins());
    if (!move_to_vertices(a, mesh)) mesh.corners.push_back(std::move(a));
  }

  const Source& source_;
  ObjText text_;
  FaceSink faces_;
  std::size_t vertices_ = 0, face_ = 0, smoothing_ = 0;
  NamedParts parts_;
  std::vector<std::int64_t> polygon_;
};

}  // namespace

ReadResult read_obj(const Source& source) { return ObjReader(source).read(); }

}  // namespace aomd::io::detail
