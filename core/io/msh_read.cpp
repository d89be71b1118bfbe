// Gmsh MSH 2.2 and 4.1: nodes, elements and names; the rest: msh_{entities,views,periodic}.h.

#include <algorithm>
#include <map>

#include "core/base/text.h"
#include "core/io/formats.h"
#include "core/io/msh_body.h"
#include "core/io/msh_entities.h"
#include "core/io/msh_mesh.h"
#include "core/io/msh_periodic.h"
#include "core/io/msh_views.h"

namespace aomd::io::detail {
namespace {

template <class Body>
class MshReader {
 public:
  MshReader(const Source& source, const MshHeader& header)
      : source_(source),
        msh2_(header.msh2),
        body_(source, TextCursor(source, source.bytes, header.end)),
        entities_(mesh_.model()) {}

  ReadResult read() {
    while (!at_end()) section();
    if (!has_nodes_) fail_at_end("the file has no $Nodes");
    if (!has_elements_) fail_at_end("the file has no $Elements");
    mesh_.finish(node_classes(), msh2_);
    note_parts();
    read_periodic();
    MshViews<Body> views(source_, mesh_);
    for (const auto& [name, start] : views_) {
      body_.move_to(start);
      views.read(name == "NodeData", body_);
      end_section(name);
    }
    return result(views);
  }

 private:
  [[nodiscard]] MshMesh::NodeClasses node_classes() const {
    using Known = MshMesh::NodeClasses;
    if (msh2_) return parametric_ ? Known::Entities : Known::None;
    return has_entities_ ? Known::Entities : Known::Blocks;
  }

  void note_parts() {
    if (!entities_.partitioned()) return;
    std::string note = "parts joined to the model entities that they are parts of";
    if (between_parts_ > 0)
      note += ", " + counted(between_parts_, "element") + " on borders between them dropped";
    mesh_.notes().push_back(std::move(note));
  }

  void read_periodic() {
    MshPeriodic periodic(mesh_);
    for (const TextCursor& start : periodic_) {
      body_.move_to(start);
      if (msh2_) {
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

  bool at_end() {
    TextCursor cursor = body_.text();
    const bool end = cursor.skip_to_content();
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
    } else if (name == "Entities" && !msh2_) {
      once(has_entities_, name, start);
      entities_.read(body_);
    } else if (name == "PartitionedEntities" && !msh2_) {
      once(has_parts_, name, start);
      entities_.read_partitioned(body_);
    } else if (name == "Nodes" || (name == "ParametricNodes" && msh2_)) {
      once(has_nodes_, "Nodes", start);
      parametric_ = name != "Nodes";
      msh2_ ? nodes2() : nodes4();
      const std::string wrong = mesh_.finish_nodes();
      if (!wrong.empty()) body_.fail_at(start, wrong);
    } else if (name == "Elements") {
      once(has_elements_, name, start);
      if (!has_nodes_) body_.fail_at(start, "$Elements before $Nodes");
      msh2_ ? elements2() : elements4();
    } else {
      return false;
    }
    return true;
  }

  void once(bool& has, std::string_view name, std::size_t start) const {
    if (has) body_.fail_at(start, "a second section $" + std::string(name));
    has = true;
  }

  void end_section(std::string_view name) {
    TextCursor cursor = body_.text();
    const std::string end = "$End" + std::string(name);
    if (cursor.skip_to_content()) fail_at_end("the file ends before " + shown(end));
    const std::size_t start = cursor.offset();
    const std::string_view word = cursor.word();
    if (word != end) body_.fail_at(start, "expected " + shown(end) + ", found " + shown(word));
    cursor.end_line();
    body_.move_to(cursor);
  }

  void skip_section(std::string_view name, std::size_t start) {
    const TextCursor content = body_.text();
    const std::string end = "$End" + std::string(name);
    const std::size_t at = source_.bytes.find(end, content.offset());
    if (at == std::string_view::npos) body_.fail_at(start, "the section has no " + shown(end));
    if (name == "NodeData" || name == "ElementData") {
      views_.emplace_back(name, content);
    } else if (name == "Periodic") {
      periodic_.push_back(content);
    } else if (name != "Comments") {
      const std::string quoted = shown(name);
      ++skipped_[quoted.substr(1, quoted.size() - 2)];
    }
    body_.move_to(TextCursor(source_, source_.bytes, at));
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

  int dimension() {
    const std::int32_t dim = body_.integer("the dimension of an entity");
    if (dim < 0 || dim > 3) body_.fail("an entity of dimension " + std::to_string(dim));
    return dim;
  }

  /// Refuses at once what the file is too short for, so that what the count makes us reserve is
  /// bounded.
  void check_room(std::uint64_t n, std::size_t bytes_each, const char* what) const {
    if (n > body_.left() / bytes_each) {
      body_.fail("the file ends early: it promises " + std::to_string(n) + ' ' + what + ", " +
                 std::to_string(body_.left()) + " bytes are left");
    }
    if (n >= no_index)
      throw LimitError(source_.name, {}, std::string("more than 2^32 - 2 ") + what);
  }

  void position() {
    const double x = body_.real("x"), y = body_.real("y"), z = body_.real("z");
    mesh_.add_position({x, y, z});
  }

  std::uint64_t node_tag(std::int64_t tag) const {
    if (tag < 1) body_.fail("node tag " + std::to_string(tag) + ", expected 1 or more");
    return static_cast<std::uint64_t>(tag);
  }

  void nodes4() {
    const std::uint64_t blocks = body_.count("the number of blocks");
    const std::uint64_t n = body_.count("the number of nodes");
    body_.count("the smallest node tag");
    body_.count("the largest node tag");
    check_room(n, Body::long_size + 3 * Body::real_size, "nodes");
    mesh_.reserve_nodes(static_cast<std::size_t>(n));
    for (std::uint64_t b = 0; b < blocks; ++b) node_block(n - mesh_.node_count());
    if (mesh_.node_count() != n) {
      body_.fail("the section promises " + counted(n, "node") + ", its blocks hold " +
                 std::to_string(mesh_.node_count()));
    }
  }

  void node_block(std::uint64_t most) {
    const int dim = dimension();
    const ModelRef model = entities_.model_ref(dim, body_.integer("an entity tag"), body_);
    const std::int32_t parametric = body_.integer("the parametric flag");
    if (parametric != 0 && parametric != 1) body_.fail("the parametric flag is neither 0 nor 1");
    const std::uint64_t n = body_.count("the number of nodes");
    if (n > most) body_.fail("the blocks hold more nodes than the section promises");
    for (std::uint64_t i = 0; i < n; ++i)
      mesh_.add_node_tag(node_tag(static_cast<std::int64_t>(body_.count("a node tag"))), model);
    for (std::uint64_t i = 0; i < n; ++i) {
      position();
      for (int k = 0; k < dim * parametric; ++k) body_.value("a parameter");
    }
  }

  void nodes2() {
    const std::uint64_t n = count_line("the number of nodes");
    check_room(n, Body::int_size + 3 * Body::real_size, "nodes");
    mesh_.reserve_nodes(static_cast<std::size_t>(n));
    for (std::uint64_t i = 0; i < n; ++i) {
      const std::uint64_t tag = node_tag(body_.integer("a node tag"));
      position();
      mesh_.add_node_tag(tag, parametric_ ? class_and_parameters() : ModelRef());
    }
  }

  /// Behind the position of a parametric node.
  ModelRef class_and_parameters() {
    const int dim = dimension();
    const ModelRef model = entities_.model_ref(dim, body_.integer("an entity tag"), body_);
    for (int k = 0; k < dim && dim < 3; ++k) body_.value("a parameter");
    return model;
  }

  /// A count that is text in binary files too.
  std::uint64_t count_line(const char* what) {
    TextCursor cursor = body_.text();
    cursor.skip_to_content();
    const std::int64_t n = cursor.integer(what);
    if (n < 0) cursor.fail(std::string(what) + " is negative");
    cursor.end_line();
    body_.move_to(cursor);
    return static_cast<std::uint64_t>(n);
  }

  MshType element_type(std::int32_t number) const {
    const auto type = msh_type(number);
    if (!type)
      body_.fail("element type " + std::to_string(number) + " is not one that is known here");
    return *type;
  }

  void elements4() {
    const std::uint64_t blocks = body_.count("the number of blocks");
    const std::uint64_t n = body_.count("the number of elements");
    body_.count("the smallest element tag");
    body_.count("the largest element tag");
    check_room(n, 2 * Body::long_size, "elements");
    std::uint64_t found = 0;
    for (std::uint64_t b = 0; b < blocks; ++b) found += element_block(n - found);
    if (found != n) {
      body_.fail("the section promises " + counted(n, "element") + ", its blocks hold " +
                 std::to_string(found));
    }
  }

  std::uint64_t element_block(std::uint64_t most) {
    const int dim = dimension();
    const ModelRef model = entities_.model_ref(dim, body_.integer("an entity tag"), body_);
    const bool between_parts = model.valid() && model.dimension() != dim;
    const MshType type = element_type(body_.integer("an element type"));
    if (!model.may_classify(shape_template(type.shape).dimension)) {
      body_.fail("a " + std::string(shape_template(type.shape).name) +
                 " cannot lie on a model entity of dimension " + std::to_string(dim));
    }
    const std::uint64_t n = body_.count("the number of elements");
    if (n > most) body_.fail("the blocks hold more elements than the section promises");
    for (std::uint64_t i = 0; i < n; ++i) {
      const std::uint64_t tag = body_.count("an element tag");
      const auto nodes = std::span(nodes_).first(static_cast<std::size_t>(type.nodes));
      for (std::uint64_t& node : nodes) node = body_.count("a node tag");
      between_parts ? mesh_.drop(tag) : add(tag, type, model, 0);
    }
    between_parts_ += between_parts ? n : 0;
    return n;
  }

  void add(std::uint64_t tag, MshType type, ModelRef model, std::int32_t physical) {
    const auto nodes = std::span(nodes_).first(static_cast<std::size_t>(type.nodes));
    const std::string wrong = mesh_.add(tag, type, nodes, model, physical);
    if (!wrong.empty()) body_.fail(wrong);
  }

  void elements2() {
    const std::uint64_t n = count_line("the number of elements");
    check_room(n, Body::int_size * 2, "elements");
    if constexpr (std::is_same_v<Body, MshText>) {
      for (std::uint64_t i = 0; i < n; ++i) {
        const std::uint64_t tag = body_.count("an element tag");
        const MshType type = element_type(body_.integer("an element type"));
        element2(tag, type, body_.integer("the number of tags"));
      }
    } else {
      for (std::uint64_t found = 0; found < n;) found += element_run(n - found);
    }
  }

  /// Binary MSH 2 lists elements in runs of one type and number of tags.
  std::uint64_t element_run(std::uint64_t most) {
    const MshType type = element_type(body_.integer("an element type"));
    const std::int32_t n = body_.integer("the number of elements");
    if (n < 1 || static_cast<std::uint64_t>(n) > most)
      body_.fail("a run of " + std::to_string(n) + " elements where " + std::to_string(most) +
                 " are left");
    const std::int32_t tags = body_.integer("the number of tags");
    for (std::int32_t i = 0; i < n; ++i)
      element2(static_cast<std::uint32_t>(body_.integer("an element tag")), type, tags);
    return static_cast<std::uint64_t>(n);
  }

  /// The tags are: physical group, model entity, and others that mean nothing to us.
  void element2(std::uint64_t tag, MshType type, std::int32_t tags) {
    if (tags < 0) body_.fail("a negative number of tags");
    std::int32_t physical = 0, elementary = 0;
    for (std::int32_t k = 0; k < tags; ++k) {
      const std::int32_t value = body_.integer("a tag");
      if (k == 0) physical = value;
      if (k == 1) elementary = value;
    }
    const ModelRef model = entities_.model_ref(shape_template(type.shape).dimension,
                                               elementary != 0 ? elementary : physical, body_);
    for (int k = 0; k < type.nodes; ++k)
      nodes_[static_cast<std::size_t>(k)] = static_cast<std::uint64_t>(body_.integer("a node tag"));
    add(tag, type, model, physical);
  }

  const Source& source_;
  bool msh2_;
  Body body_;
  MshMesh mesh_;
  MshEntities<Body> entities_;
  std::array<std::uint64_t, max_msh_nodes> nodes_{};
  bool has_nodes_ = false, has_elements_ = false, has_entities_ = false, has_parts_ = false;
  bool parametric_ = false;           ///< nodes tell where they lie
  std::uint64_t between_parts_ = 0;   ///< elements
  std::vector<TextCursor> periodic_;  ///< where the content of such sections starts
  std::vector<std::pair<std::string, TextCursor>> views_;  ///< and where their content starts
  std::map<std::string, std::size_t> skipped_;             ///< sections, and how many of each
};

}  // namespace

ReadResult read_msh(const Source& source) {
  const MshHeader header = read_msh_header(source);
  if (!header.binary) return MshReader<MshText>(source, header).read();
  if (header.order == std::endian::little)
    return MshReader<MshBinary<std::endian::little>>(source, header).read();
  return MshReader<MshBinary<std::endian::big>>(source, header).read();
}

}  // namespace aomd::io::detail
