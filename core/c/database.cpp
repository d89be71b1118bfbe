// The C interface of the database.

#include <algorithm>
#include <memory>

#include "core/c/handles.h"
#include "core/mesh/derive.h"
#include "core/mesh/names.h"

// NOLINTBEGIN(google-global-names-in-headers): functions of C stand in no namespace.
using aomd::c::BadArgument;
using aomd::c::guarded;
// NOLINTEND(google-global-names-in-headers)

namespace {

aomd::EntityRef living(const aomd_database& database, int dimension, std::uint32_t id) {
  aomd::c::check_dimension(dimension);
  const aomd::EntityRef e(dimension, id);
  if (id >= database.mesh.capacity(dimension) || !database.mesh.alive(e))
    throw BadArgument("there is no " + name_of(e));
  return e;
}

void check_relation(int i, int j) {
  aomd::c::check_dimension(i);
  aomd::c::check_dimension(j);
}

void check_recorded(const aomd_database& database) {
  if (database.mesh.journal() == nullptr) throw BadArgument("nothing is recorded");
}

}  // namespace

aomd_status aomd_database_new(const aomd_mesh* mesh, aomd_database** database) {
  return guarded([&] { *database = new aomd_database(mesh->data); });
}

void aomd_database_free(aomd_database* database) { delete database; }

size_t aomd_database_count(const aomd_database* database, int dimension) {
  return dimension >= 0 && dimension < 4 ? database->mesh.count(dimension) : 0;
}

aomd_status aomd_database_store(aomd_database* database, int i, int j) {
  return guarded([&] {
    check_relation(i, j);
    database->mesh.set(i, j);
  });
}

aomd_status aomd_database_release(aomd_database* database, int i, int j) {
  return guarded([&] {
    check_relation(i, j);
    database->mesh.unset(i, j);
  });
}

aomd_status aomd_database_adjacent(const aomd_database* database, int dimension, uint32_t id,
                                   int level, size_t capacity, uint32_t* ids, size_t* count) {
  return guarded([&] {
    aomd::c::check_dimension(level);
    if (dimension == level) throw BadArgument("T(I,J) relates two different levels");
    std::vector<std::uint32_t> found;
    adjacent(database->mesh, living(*database, dimension, id), level, found);
    std::copy_n(found.begin(), std::min(capacity, found.size()), ids);
    *count = found.size();
  });
}

aomd_status aomd_database_find_edge(const aomd_database* database, uint32_t a, uint32_t b,
                                    uint32_t* edge) {
  return guarded([&] {
    const aomd::Vertex first(living(*database, 0, a).index), second(living(*database, 0, b).index);
    *edge = database->mesh.find_edge(first, second).index;
  });
}

aomd_status aomd_database_move(aomd_database* database, uint32_t vertex, const double position[3]) {
  return guarded([&] {
    database->mesh.move(aomd::Vertex(living(*database, 0, vertex).index),
                        {position[0], position[1], position[2]});
  });
}

aomd_status aomd_database_record(aomd_database* database) {
  return guarded([&] {
    if (database->mesh.journal() == nullptr) database->mesh.attach(&database->journal);
  });
}

aomd_status aomd_database_undo(aomd_database* database, int* done) {
  return guarded([&] {
    check_recorded(*database);
    *done = database->journal.undo(database->mesh) ? 1 : 0;
  });
}

aomd_status aomd_database_redo(aomd_database* database, int* done) {
  return guarded([&] {
    check_recorded(*database);
    *done = database->journal.redo(database->mesh) ? 1 : 0;
  });
}

aomd_status aomd_database_to_mesh(const aomd_database* database, aomd_mesh** mesh) {
  return guarded([&] { *mesh = new aomd_mesh{to_data(database->mesh), {}}; });
}
