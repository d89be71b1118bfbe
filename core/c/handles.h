#pragma once
// What the handles of the C interface are, and how exceptions become a status.

#include <stdexcept>
#include <string>
#include <vector>

#include "core/c/aomd.h"
#include "core/mesh/journal.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_data.h"

struct aomd_mesh {
  aomd::MeshData data;
  std::vector<std::string> notes;
};

struct aomd_database {
  explicit aomd_database(const aomd::MeshData& data) : mesh(data) {}

  aomd::Mesh mesh;
  aomd::Journal journal;  // the mesh holds on to it: a database does not move
};

namespace aomd::c {

/// An argument that makes no sense.
struct BadArgument : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A progress function said no.
struct Cancelled : std::runtime_error {
  Cancelled() : std::runtime_error("cancelled") {}
};

/// Sets what aomd_last_error() returns on this thread.
void set_last_error(const std::string& text) noexcept;

/// To be called where an exception is caught: keeps its words, and returns what stands for it.
[[nodiscard]] aomd_status status_of_exception() noexcept;

/// Runs what may throw.
template <typename Body>
[[nodiscard]] aomd_status guarded(Body&& body) noexcept {
  try {
    body();
    return AOMD_DONE;
  } catch (...) {
    return status_of_exception();
  }
}

/// Throws BadArgument for what is no dimension of `lowest` to 3.
void check_dimension(int dimension, int lowest = 0);

}  // namespace aomd::c
