#pragma once
// The library for C. Handles are opaque; arrays come with their sizes before them; what a function
// hands out belongs to the handle and stays until that is freed, unless it says otherwise.
//
// Functions that can fail return an aomd_status; aomd_last_error() then has one line for the same
// thread, in the words of the program `aomd`. Their last argument receives the result, and is left
// as it was where they fail. Vertices are counted from 0, angles are in degrees, lengths in the
// units of the mesh. Dimensions: 0 vertices, 1 edges, 2 faces, 3 regions. A handle is for one
// thread at a time. Null is no handle: it may only be freed.

// NOLINTBEGIN(modernize-deprecated-headers,modernize-use-using,readability-identifier-naming)
#include <stddef.h>
#include <stdint.h>

#include "core/base/version.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

// As the exit codes of the program.
typedef enum aomd_status {
  AOMD_DONE = 0,
  AOMD_USAGE = 2,   // an argument makes no sense
  AOMD_INPUT = 3,   // a file or mesh cannot be read or used
  AOMD_OUTPUT = 4,  // a file could not be written; what stood there is untouched
  AOMD_LIMIT = 5,   // out of memory, or too large
  AOMD_FAULT = 70,  // the library contradicts itself
  AOMD_CANCELLED = 130
} aomd_status;

// What went wrong last on this thread; "" where nothing did. Until the next failure there.
const char* aomd_last_error(void);
// That of the library, which may be newer than AOMD_VERSION_NUMBER, that of the headers.
int aomd_version_number(void);

// Meshes as files hold them ---------------------------------------------------------------------

typedef struct aomd_mesh aomd_mesh;

// From x, y, z of each vertex and three vertices of each triangle. Copies both.
aomd_status aomd_mesh_from_triangles(size_t vertices, const double* positions, size_t triangles,
                                     const uint32_t* corners, aomd_mesh** mesh);
// The same with four vertices of each tetrahedron.
aomd_status aomd_mesh_from_tetrahedra(size_t vertices, const double* positions, size_t tetrahedra,
                                      const uint32_t* corners, aomd_mesh** mesh);
// A generated mesh; size 0 is its own.
aomd_status aomd_mesh_sample(const char* name, int size, aomd_mesh** mesh);
aomd_status aomd_mesh_read(const char* file, aomd_mesh** mesh);
// The extension chooses the format.
aomd_status aomd_mesh_write(const aomd_mesh* mesh, const char* file);
aomd_status aomd_mesh_copy(const aomd_mesh* mesh, aomd_mesh** copy);
void aomd_mesh_free(aomd_mesh* mesh);

// How many vertices, or listed edges, faces or regions.
size_t aomd_mesh_count(const aomd_mesh* mesh, int dimension);
// x, y, z of each vertex.
const double* aomd_mesh_positions(const aomd_mesh* mesh);
// The vertices of all entities of a dimension of 1 to 3, one after the other; how many there are of
// each is told by aomd_mesh_corners_of.
size_t aomd_mesh_corner_count(const aomd_mesh* mesh, int dimension);
const uint32_t* aomd_mesh_corners(const aomd_mesh* mesh, int dimension);
size_t aomd_mesh_corners_of(const aomd_mesh* mesh, int dimension, size_t entity);
// The model entity that an entity lies on: its dimension and tag; -1 and 0: nothing.
aomd_status aomd_mesh_class(const aomd_mesh* mesh, int dimension, size_t entity,
                            int* model_dimension, int* tag);
// What the reader had to do, a line each.
size_t aomd_mesh_note_count(const aomd_mesh* mesh);
const char* aomd_mesh_note(const aomd_mesh* mesh, size_t note);

// What is done to meshes ------------------------------------------------------------------------

// A guess in [0, 1] of how far the work is, at its start and about ten times a second; nonzero ends
// it.
typedef int (*aomd_progress)(double done, void* user);

// Later versions append to it: `size` says how much of it the program knows.
typedef struct aomd_decimate_options {
  size_t size;
  int paper;             // 0: the quality strategy; 1: the loop as printed
  uint32_t target;       // faces, of a volume tetrahedra; 0: none
  double factor;         // edges become so many times longer where there is no target
  int coarsest;          // 1: no limit on the length of edges
  double angle;          // by which a face may turn in one operation; 0: what suits the strategy
  double min_angle;      // of faces
  double regularity;     // of quality: 0 accuracy first .. 1 regular faces first
  double max_distance;   // of the result from the original; 0: no such guarantee
  int no_intersections;  // 1: no faces cut each other that did not
  double feature_angle;  // edges whose faces meet at more become model edges; 0: none do
  int threads;           // 0: all cores; the result is the same
  aomd_progress progress;
  void* user;
  int attributes;  // of quality: 1: colours and texture coordinates count beside the shape; 0: not
} aomd_decimate_options;

// Sets what suits most meshes; `size` is sizeof(aomd_decimate_options).
aomd_status aomd_decimate_options_init(aomd_decimate_options* options, size_t size);
// Classifies and decimates; the result is classified, and has the arrays of the mesh. With no
// options as after init.
aomd_status aomd_decimate(const aomd_mesh* mesh, const aomd_decimate_options* options,
                          aomd_mesh** result);
// Classifies by the angles between faces, where the mesh does not say what it lies on.
aomd_status aomd_classify(const aomd_mesh* mesh, double feature_angle, aomd_mesh** result);
// Mends what is safe to mend in a surface. `mended` receives the number of entities concerned.
aomd_status aomd_repair(const aomd_mesh* mesh, int weld, size_t* mended, aomd_mesh** result);
// How many inconsistencies there are; 0 for a sound mesh. aomd_last_error() has the first of them.
aomd_status aomd_check(const aomd_mesh* mesh, size_t* findings);

typedef struct aomd_distance {
  size_t size;            // set it to sizeof(aomd_distance)
  double max, rms, mean;  // the larger of both ways, in the units of the mesh
  size_t flips;           // faces of the result that look away from the original
} aomd_distance;

// Between two surfaces, at so many points of each and at all vertices.
aomd_status aomd_compare(const aomd_mesh* original, const aomd_mesh* result, size_t samples,
                         aomd_distance* distance);

// The database ----------------------------------------------------------------------------------

typedef struct aomd_database aomd_database;

aomd_status aomd_database_new(const aomd_mesh* mesh, aomd_database** database);
void aomd_database_free(aomd_database* database);
size_t aomd_database_count(const aomd_database* database, int dimension);
// Stores T(i,j) from now on, or lets go of it.
aomd_status aomd_database_store(aomd_database* database, int i, int j);
aomd_status aomd_database_release(aomd_database* database, int i, int j);
// The entities of `level` at an entity. At most `capacity` of them go into `ids`, which may be null
// where that is 0; `count` receives how many there are.
aomd_status aomd_database_adjacent(const aomd_database* database, int dimension, uint32_t id,
                                   int level, size_t capacity, uint32_t* ids, size_t* count);
// The edge on two vertices; UINT32_MAX where there is none.
aomd_status aomd_database_find_edge(const aomd_database* database, uint32_t a, uint32_t b,
                                    uint32_t* edge);
aomd_status aomd_database_move(aomd_database* database, uint32_t vertex, const double position[3]);
// From now on edits are steps of a history; undo and redo go through it and tell whether they did.
aomd_status aomd_database_record(aomd_database* database);
aomd_status aomd_database_undo(aomd_database* database, int* done);
aomd_status aomd_database_redo(aomd_database* database, int* done);
aomd_status aomd_database_to_mesh(const aomd_database* database, aomd_mesh** mesh);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
// NOLINTEND(modernize-deprecated-headers,modernize-use-using,readability-identifier-naming)
