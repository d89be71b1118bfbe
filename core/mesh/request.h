#pragma once
// A scoped wish for a stored adjacency.

#pragma GCC visibility push(default)

namespace aomd {

class Mesh;

/// Keeps a relation stored for as long as it lives (see Mesh::request).
class Request {
 public:
  Request() = default;
  Request(Mesh& mesh, int i, int j, const char* by) : mesh_(&mesh), i_(i), j_(j), by_(by) {}
  Request(Request&& other) noexcept
      : mesh_(other.mesh_), i_(other.i_), j_(other.j_), by_(other.by_) {
    other.mesh_ = nullptr;
  }
  Request& operator=(Request&& other) noexcept;
  ~Request() { release(); }
  void release();

 private:
  Mesh* mesh_ = nullptr;
  int i_ = 0, j_ = 0;
  const char* by_ = nullptr;
};

}  // namespace aomd

#pragma GCC visibility pop
