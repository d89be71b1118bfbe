// Wavefront OBJ. tinyobjloader reads the elements, groups, objects and materials; a first pass
// (obj_text.h) checks the text and keeps what tinyobjloader loses.

#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <istream>
#include <limits>
#include <map>
#include <streambuf>

#include "core/base/text.h"
#include "core/io/class_names.h"
#include "core/io/corner_values.h"
#include "core/io/face_sink.h"
#include "core/io/formats.h"
#include "core/io/named_faces.h"
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

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Receives tinyobjloader's elements. Faces are first classified by their part, a combination of
/// group, object and material; finish() then decides which of the three counts.
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
    add_labels(result.mesh);
    classify(result);
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
  using Part = std::array<std::uint32_t, 4>;
  enum Level { Groups, Objects, Materials, Smoothing };

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
    for (; smoothing_ < text_.smoothing.size() && text_.smoothing[smoothing_].face == face_;
         ++smoothing_)
      enter(Smoothing, std::to_string(text_.smoothing[smoothing_].group));
    if (!part_known_) find_part();
    const std::string wrong = faces_.add(polygon_, ModelRef(2, part_));
    if (!wrong.empty()) source_.fail_at_line(text_.face_offsets[face_], wrong);
    ++face_;
  }

  void find_part() {
    const Part part{names_[Groups].current(), names_[Objects].current(),
                    names_[Materials].current(), names_[Smoothing].current()};
    part_ = part_numbers_.try_emplace(part, static_cast<std::int32_t>(parts_.size())).first->second;
    if (static_cast<std::size_t>(part_) == parts_.size()) parts_.push_back(part);
    part_known_ = true;
  }

  /// What faces are called, as arrays; groups that say no more than our classes are none.
  void add_labels(MeshData& mesh) const {
    constexpr const char* words[] = {obj_group, obj_object, obj_material, obj_smoothing};
    for (const Level level : {Groups, Objects, Materials, Smoothing}) {
      std::vector<std::string> names;
      const std::vector<std::size_t> name_of_part = names_in_use(level, names);
      const bool says_nothing = std::all_of(names.begin(), names.end(), [&](const std::string& n) {
        return n.empty() || (level == Groups && class_of_name(n));
      });
      if (says_nothing) continue;
      Attribute label{words[level], 2, 1, true, {}};
      for (const ModelRef m : mesh.faces.classes)
        label.values.push_back(
            static_cast<double>(name_of_part[static_cast<std::size_t>(m.tag())]));
      label.names = std::move(names);
      if (level == Smoothing) use_numbers(label);
      mesh.attributes.push_back(std::move(label));
    }
  }

  /// Smoothing groups have no names but numbers.
  static void use_numbers(Attribute& label) {
    for (double& x : label.values)
      x = std::strtod(label.names[static_cast<std::size_t>(x)].c_str(), nullptr);
    label.names.clear();
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
  std::size_t vertices_ = 0, face_ = 0, smoothing_ = 0;
  std::array<Names, 4> names_;
  std::vector<Part> parts_;
  std::map<Part, std::int32_t> part_numbers_;
  std::int32_t part_ = 0;
  bool part_known_ = false;
  std::vector<std::int64_t> polygon_;
};

}  // namespace

ReadResult read_obj(const Source& source) { return ObjReader(source).read(); }

}  // namespace aomd::io::detail
