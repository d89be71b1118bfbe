#pragma once
// Small parts that the sections of an MSH file share.

#include <cstdint>
#include <string>
#include <utility>

#include "core/base/text.h"
#include "core/io/msh.h"
#include "core/io/msh_body.h"
#include "core/mesh/handle.h"

namespace aomd::io::detail {

template <class Body>
int msh_dimension(Body& body) {
  const std::int32_t dim = body.integer("the dimension of an entity");
  if (dim < 0 || dim > 3) body.fail("an entity of dimension " + std::to_string(dim));
  return dim;
}

/// What a block begins with: the dimension and the tag of its entity, the other way round in
/// version 4.0.
template <class Body>
std::pair<int, std::int32_t> msh_block_entity(Body& body, MshVersion version) {
  if (version != MshVersion::V40) {
    const int dim = msh_dimension(body);
    return {dim, body.integer("an entity tag")};
  }
  const std::int32_t tag = body.integer("an entity tag");
  return {msh_dimension(body), tag};
}

/// Refuses at once what the file is too short for, so that what the count makes us reserve is
/// bounded.
template <class Body>
void msh_check_room(const Source& source, const Body& body, std::uint64_t n, std::size_t bytes_each,
                    const char* what) {
  if (n > body.left() / bytes_each) {
    body.fail("the file ends early: it promises " + std::to_string(n) + ' ' + what + ", " +
              std::to_string(body.left()) + " bytes are left");
  }
  if (n >= no_index) throw LimitError(source.name, {}, std::string("more than 2^32 - 2 ") + what);
}

/// A count that is text in binary files too.
template <class Body>
std::uint64_t msh_count_line(Body& body, const char* what) {
  TextCursor cursor = body.text();
  cursor.skip_to_content();
  const std::int64_t n = cursor.integer(what);
  if (n < 0) cursor.fail(std::string(what) + " is negative");
  cursor.end_line();
  body.move_to(cursor);
  return static_cast<std::uint64_t>(n);
}

}  // namespace aomd::io::detail
