#pragma once
// $Periodic of an MSH file: which nodes of an entity correspond to which of another.

#include <string>

#include "core/base/text.h"
#include "core/io/msh_mesh.h"
#include "core/io/text_cursor.h"

namespace aomd::io::detail {

/// Reads links between entities into the mesh, once it is finished.
class MshPeriodic {
 public:
  explicit MshPeriodic(MshMesh& mesh) : mesh_(mesh) {}

  /// MSH 4.1, text or binary.
  template <class Body>
  void read(Body& body) {
    const std::uint64_t links = body.count("the number of periodic links");
    for (std::uint64_t i = 0; i < links; ++i) {
      const std::int32_t dim = body.integer("the dimension of a periodic entity"),
                         tag = body.integer("the tag of a periodic entity"),
                         source = body.integer("the tag of its source");
      for (const std::int64_t each : {tag, source}) check(dim, each, body);
      Periodicity link{ModelRef(dim, tag), ModelRef(dim, source), {}, {}};
      const std::uint64_t values = body.count("the number of values of a transformation");
      for (std::uint64_t k = 0; k < values; ++k)
        link.transformation.push_back(body.real("a transformation"));
      const std::uint64_t pairs = body.count("the number of corresponding nodes");
      for (std::uint64_t k = 0; k < pairs; ++k) {
        const std::uint64_t node = body.count("a node tag");
        add(link, node, body.count("a node tag"));
      }
      keep(std::move(link));
    }
  }

  /// MSH 2.2: text in binary files too.
  void read_text(TextCursor& cursor) {
    const std::int64_t links = integer(cursor, "the number of periodic links");
    for (std::int64_t i = 0; i < links; ++i) {
      const std::int64_t dim = integer(cursor, "the dimension of a periodic entity"),
                         tag = integer(cursor, "the tag of a periodic entity"),
                         source = integer(cursor, "the tag of its source");
      for (const std::int64_t each : {tag, source}) check(dim, each, cursor);
      Periodicity link{ModelRef(static_cast<int>(dim), static_cast<std::int32_t>(tag)),
                       ModelRef(static_cast<int>(dim), static_cast<std::int32_t>(source)),
                       {},
                       {}};
      transformation(cursor, link);
      const std::int64_t pairs = integer(cursor, "the number of corresponding nodes");
      for (std::int64_t k = 0; k < pairs; ++k) {
        const std::int64_t node = integer(cursor, "a node tag");
        add(link, static_cast<std::uint64_t>(node),
            static_cast<std::uint64_t>(integer(cursor, "a node tag")));
      }
      keep(std::move(link));
    }
  }

  void finish() {
    if (missing_ > 0)
      mesh_.notes().push_back(counted(missing_, "periodic pair") +
                              " of nodes that the mesh does not keep dropped");
  }

 private:
  static std::int64_t integer(TextCursor& cursor, const char* what) {
    if (cursor.skip_to_content()) cursor.fail("the file ends within $Periodic");
    return cursor.integer(what);
  }

  template <class Input>
  static void check(std::int64_t dim, std::int64_t tag, const Input& input) {
    if (dim < 0 || dim > 3) input.fail("a periodic entity of dimension " + std::to_string(dim));
    if (tag < ModelRef::min_tag || tag > ModelRef::max_tag)
      input.fail("entity tag " + std::to_string(tag) + " is out of range");
  }

  /// Later versions of Gmsh write one where they know it.
  static void transformation(TextCursor& cursor, Periodicity& link) {
    cursor.skip_to_content();
    TextCursor ahead = cursor;
    if (ahead.word() != "Affine") return;
    while (!ahead.line_done()) link.transformation.push_back(ahead.real("a transformation"));
    cursor = ahead;
  }

  void add(Periodicity& link, std::uint64_t node, std::uint64_t source) {
    bool known = false;
    const std::uint32_t v = mesh_.vertex(node, known), w = mesh_.vertex(source, known);
    if (v == no_index || w == no_index) {
      ++missing_;
    } else {
      link.pairs.push_back({v, w});
    }
  }

  void keep(Periodicity&& link) { mesh_.mesh().periodic.push_back(std::move(link)); }

  MshMesh& mesh_;
  std::size_t missing_ = 0;
};

}  // namespace aomd::io::detail
