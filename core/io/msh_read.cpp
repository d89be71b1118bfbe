// Gmsh MSH 1, 2, 4.0 and 4.1: sections and names; what they hold: msh_{nodes,elements,entities,
// views,periodic}.h.

#include <algorithm>
#include <map>
#include <optional>
#include <type_traits>

#include "core/base/text.h"
#include "core/io/formats.h"
#include "core/io/msh_body.h"
#include "core/io/msh_elements.h"
#include "core/io/msh_entities.h"
#include "core/io/msh_mesh.h"
#include "core/io/msh_nodes.h"
#include "core/io/msh_periodic.h"
#include "core/io/msh_views.h"

namespace aomd::io::detail {
namespace {

template <class Body>
class MshReader {
 public:
  MshReader(const Source& source, const MshHeader& header)
      : source_(source),
        version_(header.version),
        body_(source, TextCursor(source, source.bytes, header.end)),
        entities_(mesh_.model(), header.version),
        nodes_(source, header.version, entities_, mesh_),
        elements_(source, header.version, entities_, mesh_) {}

  ReadResult read() {
    while (!at_end()) section();
    read_early_elements();
    if (!has_nodes_) fail_at_end("the file has no $" + std::string(nodes_name()));
    if (!has_elements_) fail_at_end("the file has no $" + std::string(elements_name()));
    mesh_.finish(node_classes(), before4());
    note_parts();
    read_periodic();
    MshViews<Body> views(source_, mesh_);
    for (const auto& [name, start] : views_) {
      body_.move_to(start);
      using On = typename MshViews<Body>::On;
      views.read(name == "NodeData"      ? On::Nodes
                 : name == "ElementData" ? On::Elements
                                         : On::Corners,
                 body_);
      end_section(name);
    }
    return result(views);
  }

 private:
  [[nodiscard]] bool before4() const { return version_ < MshVersion::V40; }

  /// Elements that stand before the nodes.
  void read_early_elements() {
    if (!early_elements_ || !has_nodes_) return;
    body_.move_to(*early_elements_);
    elements_.read(body_);
    end_section(elements_name());
  }

  [[nodiscard]] MshMesh::NodeClasses node_classes() const {
    using Known = MshMesh::NodeClasses;
    if (before4()) return parametric_ ? Known::Entities : Known::None;
    return has_entities_ ? Known::Entities : Known::Blocks;
  }

  void note_parts() {
    if (!entities_.partitioned()) return;
    std::string note = "parts joined to the model entities that they are parts of";
    if (const std::uint64_t between = elements_.between_parts(); between > 0)
      note += ", " + counted(between, "element") + " on borders between them dropped";
    mesh_.notes().push_back(std::move(note));
  }

  void read_periodic() {
    MshPeriodic periodic(mesh_);
    for (const TextCursor& start : periodic_) {
      body_.move_to(start);
      if (version_ != MshVersion::V41) {
        TextCursor cursor = start;
        periodic.read_text(cursor);
        body_.move_to(cursor);
      } else {
        periodic.read(body_);
      }
      end_section("Periodic");
    }
    periodic.finish();
  }

  ReadResult result(MshViews<Body>& views) {
    ReadResult result{{}, Format::Msh, {}};
    views.finish();
    result.notes = std::move(mesh_.notes());
    note_skipped(result.notes);
    result.mesh = std::move(mesh_.mesh());
    return result;
  }

  void note_skipped(std::vector<std::string>& notes) const {
    if (between_sections_ > 0)
      notes.push_back(counted(between_sections_, "line") + " outside of sections passed over");
    constexpr std::size_t most = 8;
    std::size_t listed = 0;
    for (const auto& [name, times] : skipped_) {
      if (listed++ == most) break;
      notes.push_back("section $" + name + " skipped");
      if (times > 1) notes.back() += ' ' + std::to_string(times) + " times";
    }
    if (skipped_.size() > most)
      notes.push_back("sections of " + counted(skipped_.size() - most, "further name") +
                      " skipped");
  }

  [[noreturn]] void fail_at_end(const std::string& what) const {
    body_.fail_at(source_.bytes.size(), what);
  }

  /// Lines between sections are no part of the mesh, as to Gmsh.
  bool at_end() {
    TextCursor cursor = body_.text();
    bool end = cursor.skip_to_content();
    for (; text && !end && cursor.rest()[0] != '$'; end = cursor.skip_to_content()) {
      ++between_sections_;
      cursor.skip_line();
    }
    body_.move_to(cursor);
    return end;
  }

  void section() {
    TextCursor cursor = body_.text();
    const std::size_t start = cursor.offset();
    const std::string_view word = cursor.word();
    if (word.size() < 2 || word[0] != '$')
      body_.fail_at(start, "expected the start of a section, found " + shown(word));
    cursor.end_line();
    body_.move_to(cursor);
    if (read_section(word.substr(1), start)) return end_section(word.substr(1));
    skip_section(word.substr(1), start);
  }

  /// False where the section is to be skipped for now.
  bool read_section(std::string_view name, std::size_t start) {
    if (name == "PhysicalNames") {
      physical_names();
    } else if (name == "Entities" && !before4()) {
      once(has_entities_, name, start);
      entities_.read(body_);
    } else if (name == "PartitionedEntities" && !before4()) {
      once(has_parts_, name, start);
      entities_.read_partitioned(body_);
    } else if (name == nodes_name() || (name == "ParametricNodes" && before4())) {
      once(has_nodes_, nodes_name(), start);
      parametric_ = name == "ParametricNodes";
      nodes_.read(body_, parametric_);
      const std::string wrong = mesh_.finish_nodes();
      if (!wrong.empty()) body_.fail_at(start, wrong);
    } else if (name == elements_name()) {
      once(has_elements_, name, start);
      if (!has_nodes_) return false;
      elements_.read(body_);
    } else {
      return false;
    }
    return true;
  }

  [[nodiscard]] std::string_view nodes_name() const {
    return version_ == MshVersion::V1 ? "NOD" : "Nodes";
  }
  [[nodiscard]] std::string_view elements_name() const {
    return version_ == MshVersion::V1 ? "ELM" : "Elements";
  }
  [[nodiscard]] std::string end_of(std::string_view name) const {
    return (version_ == MshVersion::V1 ? "$END" : "$End") + std::string(name);
  }

  void once(bool& has, std::string_view name, std::size_t start) const {
    if (has) body_.fail_at(start, "a second section $" + std::string(name));
    has = true;
  }

  void end_section(std::string_view name) {
    TextCursor cursor = body_.text();
    const std::string end = end_of(name);
    if (cursor.skip_to_content()) fail_at_end("the file ends before " + shown(end));
    const std::size_t start = cursor.offset();
    const std::string_view word = cursor.word();
    if (word != end) body_.fail_at(start, "expected " + shown(end) + ", found " + shown(word));
    cursor.end_line();
    body_.move_to(cursor);
  }

  void skip_section(std::string_view name, std::size_t start) {
    const TextCursor content = body_.text();
    const std::string end = end_of(name);
    const std::size_t at = source_.bytes.find(end, content.offset());
    if (at == std::string_view::npos) body_.fail_at(start, "the section has no " + shown(end));
    if (name == elements_name()) {
      early_elements_ = content;
    } else if (name == "NodeData" || name == "ElementData" || name == "ElementNodeData") {
      views_.emplace_back(name, content);
    } else if (name == "Periodic" && (text || version_ != MshVersion::V40)) {
      periodic_.push_back(content);
    } else if (name != "Comments") {
      const std::string quoted = shown(name);
      ++skipped_[quoted.substr(1, quoted.size() - 2)];
    }
    TextCursor behind = content;
    behind.move_to(at);
    body_.move_to(behind);
    end_section(name);
  }

  // dimension tag "name", one a line.
  void physical_names() {
    TextCursor cursor = body_.text();
    cursor.skip_to_content();
    const std::int64_t n = cursor.integer("the number of physical names");
    if (n < 0) cursor.fail("a negative number of physical names");
    for (std::int64_t i = 0; i < n; ++i) {
      if (cursor.skip_to_content()) cursor.fail("the file ends within $PhysicalNames");
      const std::int64_t dimension = cursor.integer("the dimension of a physical group");
      const std::int64_t tag = cursor.integer("the tag of a physical group");
      if (dimension < 0 || dimension > 3)
        cursor.fail("a physical group of dimension " + std::to_string(dimension));
      if (tag != static_cast<std::int32_t>(tag))
        cursor.fail("a physical group's tag is out of range");
      const std::string_view name = unquoted(cursor);
      mesh_.model().groups.push_back(
          {static_cast<int>(dimension), static_cast<std::int32_t>(tag), std::string(name)});
    }
    body_.move_to(cursor);
  }

  static constexpr bool text = std::is_same_v<Body, MshText>;

  const Source& source_;
  MshVersion version_;
  Body body_;
  MshMesh mesh_;
  MshEntities<Body> entities_;
  MshNodes<Body> nodes_;
  MshElements<Body> elements_;
  bool has_nodes_ = false, has_elements_ = false, has_entities_ = false, has_parts_ = false;
  bool parametric_ = false;                   ///< nodes tell where they lie
  std::size_t between_sections_ = 0;          ///< lines
  std::optional<TextCursor> early_elements_;  ///< where their content starts
  std::vector<TextCursor> periodic_;          ///< where the content of such sections starts
  std::vector<std::pair<std::string, TextCursor>> views_;  ///< and where their content starts
  std::map<std::string, std::size_t> skipped_;             ///< sections, and how many of each
};

}  // namespace

ReadResult read_msh(const Source& source) {
  const MshHeader header = read_msh_header(source);
  if (!header.binary) return MshReader<MshText>(without_padding(source), header).read();
  if (header.order == std::endian::little)
    return MshReader<MshBinary<std::endian::little>>(source, header).read();
  return MshReader<MshBinary<std::endian::big>>(source, header).read();
}

}  // namespace aomd::io::detail
