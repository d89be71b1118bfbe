// Goes through the whole C interface on generated meshes. Exit code 0 where all of it comes out as
// it must.

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/c/aomd.h"

#define EXPECT(condition)                                                           \
  do {                                                                              \
    if (!(condition)) {                                                             \
      fprintf(stderr, "consumer.c:%d: %s (last error: %s)\n", __LINE__, #condition, \
              aomd_last_error());                                                   \
      exit(1);                                                                      \
    }                                                                               \
  } while (0)
#define DONE(call) EXPECT((call) == AOMD_DONE)

static const double corners_of_tet[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};

// The surface of a tetrahedron: every count is known.
static aomd_mesh* four_triangles(void) {
  static const uint32_t faces[12] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
  aomd_mesh* mesh = NULL;
  DONE(aomd_mesh_from_triangles(4, corners_of_tet, 4, faces, &mesh));
  return mesh;
}

static void test_version(void) {
  EXPECT(aomd_version_number() == AOMD_VERSION_NUMBER);
  EXPECT(strcmp(aomd_last_error(), "") == 0);
}

static void test_mesh(void) {
  aomd_mesh *mesh = four_triangles(), *copy = NULL;
  int dimension = 7, tag = 7;
  EXPECT(aomd_mesh_count(mesh, 0) == 4 && aomd_mesh_count(mesh, 2) == 4);
  EXPECT(aomd_mesh_count(mesh, 3) == 0 && aomd_mesh_count(mesh, 9) == 0);
  EXPECT(aomd_mesh_corner_count(mesh, 2) == 12 && aomd_mesh_corners_of(mesh, 2, 3) == 3);
  EXPECT(aomd_mesh_corners(mesh, 2)[11] == 2 && aomd_mesh_positions(mesh)[11] == 1);
  DONE(aomd_mesh_class(mesh, 2, 0, &dimension, &tag));
  EXPECT(dimension == -1 && tag == 0);
  EXPECT(aomd_mesh_class(mesh, 2, 4, &dimension, &tag) == AOMD_USAGE);
  EXPECT(strcmp(aomd_last_error(), "there is no entity 4") == 0);
  DONE(aomd_mesh_copy(mesh, &copy));
  aomd_mesh_free(mesh);
  EXPECT(aomd_mesh_count(copy, 2) == 4);
  aomd_mesh_free(copy);
  aomd_mesh_free(NULL);
}

static void test_refusals(void) {
  static const uint32_t wrong[3] = {0, 1, 4};
  double nan_position[3] = {0, 0, 0};
  aomd_mesh* mesh = NULL;
  EXPECT(aomd_mesh_from_triangles(4, corners_of_tet, 1, wrong, &mesh) == AOMD_USAGE);
  EXPECT(strcmp(aomd_last_error(), "entity 0 names vertex 4 of 4") == 0);
  nan_position[1] = NAN;
  EXPECT(aomd_mesh_from_triangles(1, nan_position, 0, NULL, &mesh) == AOMD_USAGE);
  EXPECT(aomd_mesh_read("no such file.ply", &mesh) == AOMD_INPUT);
  EXPECT(strstr(aomd_last_error(), "no such file.ply: cannot be opened") == aomd_last_error());
  EXPECT(aomd_mesh_sample("no such sample", 0, &mesh) == AOMD_USAGE);
  EXPECT(mesh == NULL);
}

static void test_files(const char* folder) {
  aomd_mesh *mesh = four_triangles(), *back = NULL;
  char file[1024];
  snprintf(file, sizeof file, "%s/c.off", folder);
  DONE(aomd_mesh_write(mesh, file));
  DONE(aomd_mesh_read(file, &back));
  EXPECT(aomd_mesh_count(back, 2) == 4 && aomd_mesh_note_count(back) == 0);
  EXPECT(aomd_mesh_note(back, 0) == NULL);
  EXPECT(aomd_mesh_write(mesh, "/no such folder/c.off") == AOMD_OUTPUT);
  EXPECT(aomd_mesh_write(mesh, "c.no_such_format") == AOMD_OUTPUT);
  aomd_mesh_free(mesh);
  aomd_mesh_free(back);
}

static int count_calls(double done, void* user) {
  (void)done;
  ++*(int*)user;
  return 0;
}

static int end_it(double done, void* user) {
  (void)done;
  (void)user;
  return 1;
}

static void test_decimate(void) {
  aomd_mesh *ball = NULL, *coarse = NULL;
  aomd_decimate_options options;
  aomd_distance distance;
  size_t findings = 9;
  int calls = 0;
  DONE(aomd_mesh_sample("sphere", 0, &ball));
  DONE(aomd_decimate_options_init(&options, sizeof options));
  options.target = 500;
  options.progress = count_calls;
  options.user = &calls;
  DONE(aomd_decimate(ball, &options, &coarse));
  EXPECT(aomd_mesh_count(coarse, 2) == 500 && calls > 0);
  DONE(aomd_check(coarse, &findings));
  EXPECT(findings == 0);
  distance.size = sizeof distance;
  DONE(aomd_compare(ball, coarse, 10000, &distance));
  EXPECT(distance.max > 0 && distance.max < 0.05 && distance.rms < distance.max);
  EXPECT(distance.flips == 0);
  aomd_mesh_free(coarse);
  coarse = NULL;
  options.factor = -1;
  EXPECT(aomd_decimate(ball, &options, &coarse) == AOMD_USAGE && coarse == NULL);
  options.size = 0;
  EXPECT(aomd_decimate(ball, &options, &coarse) == AOMD_USAGE);
  EXPECT(strcmp(aomd_last_error(), "options: their size is not set") == 0);
  aomd_mesh_free(ball);
}

// A square of cells by cells, red on one side of a line and blue on the other.
static aomd_mesh* two_colours(const char* folder) {
  enum { cells = 24 };
  aomd_mesh* mesh = NULL;
  char file[1024];
  FILE* out = NULL;
  int i, j;
  snprintf(file, sizeof file, "%s/colours.ply", folder);
  out = fopen(file, "w");
  EXPECT(out != NULL);
  fprintf(out, "ply\nformat ascii 1.0\nelement vertex %d\n", (cells + 1) * (cells + 1));
  fprintf(out, "property double x\nproperty double y\nproperty double z\nproperty uchar red\n");
  fprintf(out, "property uchar green\nproperty uchar blue\nelement face %d\n", 2 * cells * cells);
  fprintf(out, "property list uchar int vertex_indices\nend_header\n");
  for (i = 0; i <= cells; ++i)
    for (j = 0; j <= cells; ++j)
      fprintf(out, "%d %d 0 %s\n", i, j, 3 * i > cells + j ? "255 0 0" : "0 0 255");
  for (i = 0; i < cells; ++i)
    for (j = 0; j < cells; ++j) {
      const int v = i * (cells + 1) + j;
      fprintf(out, "3 %d %d %d\n", v, v + cells + 1, v + cells + 2);
      fprintf(out, "3 %d %d %d\n", v, v + cells + 2, v + 1);
    }
  EXPECT(fclose(out) == 0);
  DONE(aomd_mesh_read(file, &mesh));
  return mesh;
}

// The result has colours; where they count it is another one.
static void test_attributes(const char* folder) {
  aomd_mesh *mesh = two_colours(folder), *shape = NULL, *both = NULL;
  aomd_decimate_options options;
  char file[1024], line[16];
  FILE* written = NULL;
  size_t size = 0;
  DONE(aomd_decimate_options_init(&options, sizeof options));
  EXPECT(options.attributes == 1);
  options.target = 150;
  DONE(aomd_decimate(mesh, &options, &both));
  options.attributes = 0;
  DONE(aomd_decimate(mesh, &options, &shape));
  size = 3 * sizeof(double) * aomd_mesh_count(both, 0);
  EXPECT(aomd_mesh_count(shape, 0) != aomd_mesh_count(both, 0) ||
         memcmp(aomd_mesh_positions(shape), aomd_mesh_positions(both), size) != 0);
  snprintf(file, sizeof file, "%s/colours.off", folder);
  DONE(aomd_mesh_write(both, file));
  written = fopen(file, "r");
  EXPECT(written != NULL && fgets(line, sizeof line, written) != NULL);
  EXPECT(strcmp(line, "COFF\n") == 0 && aomd_mesh_note_count(both) == 0);
  fclose(written);
  aomd_mesh_free(mesh);
  aomd_mesh_free(shape);
  aomd_mesh_free(both);
}

// A program that was compiled when there was nothing behind `target`.
static void test_older_options(void) {
  aomd_mesh *ball = NULL, *coarse = NULL;
  aomd_decimate_options options;
  DONE(aomd_mesh_sample("sphere", 0, &ball));
  memset(&options, 0xff, sizeof options);
  DONE(aomd_decimate_options_init(&options, offsetof(aomd_decimate_options, factor)));
  EXPECT(options.size == offsetof(aomd_decimate_options, factor) && isnan(options.factor));
  options.target = 400;
  DONE(aomd_decimate(ball, &options, &coarse));
  EXPECT(aomd_mesh_count(coarse, 2) == 400);
  aomd_mesh_free(coarse);
  aomd_mesh_free(ball);
}

static void test_cancel(void) {
  aomd_mesh *ball = NULL, *coarse = NULL;
  aomd_decimate_options options;
  DONE(aomd_mesh_sample("sphere", 0, &ball));
  DONE(aomd_decimate_options_init(&options, sizeof options));
  options.target = 500;
  options.progress = end_it;
  EXPECT(aomd_decimate(ball, &options, &coarse) == AOMD_CANCELLED && coarse == NULL);
  EXPECT(strcmp(aomd_last_error(), "cancelled") == 0);
  aomd_mesh_free(ball);
}

static void test_volume(void) {
  static const uint32_t tet[4] = {0, 1, 2, 3};
  aomd_mesh *mesh = NULL, *classified = NULL, *repaired = NULL;
  size_t mended = 9;
  int dimension = 0, tag = 0;
  DONE(aomd_mesh_from_tetrahedra(4, corners_of_tet, 1, tet, &mesh));
  EXPECT(aomd_mesh_count(mesh, 3) == 1 && aomd_mesh_corners_of(mesh, 3, 0) == 4);
  EXPECT(aomd_repair(mesh, 0, &mended, &repaired) == AOMD_USAGE);
  DONE(aomd_classify(mesh, 20, &classified));
  DONE(aomd_mesh_class(classified, 0, 0, &dimension, &tag));
  EXPECT(dimension == 0);
  aomd_mesh_free(mesh);
  aomd_mesh_free(classified);
}

static void test_repair(void) {
  static const uint32_t twice[6] = {0, 1, 2, 0, 1, 2};
  aomd_mesh *mesh = NULL, *repaired = NULL;
  size_t mended = 0;
  DONE(aomd_mesh_from_triangles(4, corners_of_tet, 2, twice, &mesh));
  DONE(aomd_repair(mesh, 0, &mended, &repaired));
  EXPECT(mended == 1 && aomd_mesh_count(repaired, 2) == 1);
  aomd_mesh_free(mesh);
  aomd_mesh_free(repaired);
}

static void test_database(void) {
  static const double there[3] = {2, 2, 2};
  aomd_mesh *mesh = four_triangles(), *back = NULL;
  aomd_database* database = NULL;
  uint32_t ids[8], edge = 0;
  size_t count = 0;
  int done = 9;
  DONE(aomd_database_new(mesh, &database));
  EXPECT(aomd_database_count(database, 1) == 0);
  DONE(aomd_database_store(database, 0, 2));
  DONE(aomd_database_store(database, 0, 1));
  EXPECT(aomd_database_count(database, 1) == 6);
  DONE(aomd_database_adjacent(database, 0, 3, 2, 8, ids, &count));
  EXPECT(count == 3 && ids[0] == 1 && ids[1] == 2 && ids[2] == 3);
  DONE(aomd_database_adjacent(database, 0, 3, 2, 0, NULL, &count));
  EXPECT(count == 3);
  EXPECT(aomd_database_adjacent(database, 0, 4, 2, 8, ids, &count) == AOMD_USAGE);
  EXPECT(strcmp(aomd_last_error(), "there is no vertex 4") == 0);
  DONE(aomd_database_find_edge(database, 3, 1, &edge));
  EXPECT(edge < 6);
  EXPECT(aomd_database_undo(database, &done) == AOMD_USAGE);
  DONE(aomd_database_record(database));
  DONE(aomd_database_move(database, 3, there));
  DONE(aomd_database_undo(database, &done));
  EXPECT(done == 1);
  DONE(aomd_database_undo(database, &done));
  EXPECT(done == 0);
  DONE(aomd_database_redo(database, &done));
  EXPECT(done == 1);
  DONE(aomd_database_to_mesh(database, &back));
  EXPECT(aomd_mesh_positions(back)[9] == 2);
  DONE(aomd_database_release(database, 0, 2));
  EXPECT(aomd_database_release(database, 2, 0) == AOMD_USAGE);
  aomd_database_free(database);
  aomd_mesh_free(mesh);
  aomd_mesh_free(back);
}

int main(int argc, char** argv) {
  EXPECT(argc == 2);
  test_version();
  test_mesh();
  test_refusals();
  test_files(argv[1]);
  test_decimate();
  test_attributes(argv[1]);
  test_older_options();
  test_cancel();
  test_volume();
  test_repair();
  test_database();
  return 0;
}
