#pragma once
// A scoped wish for a stored adjacency.

namespace aomd {

class Mesh;

/// Keeps a relation stored for as long as it lives (see Mesh::request).
class Request {
 public:
  Request() = default;
  Request(Mesh& mesh, int i, int j) : mesh_(&mesh), i_(i), j_(j) {}
  Request(Request&& other) noexcept : mesh_(other.mesh_), i_(other.i_), j_(other.j_) {
    other.mesh_ = nullptr;
  }
  Request& operator=(Request&& other) noexcept;
  ~Request() { release(); }
  void release();

 private:
  Mesh* mesh_ = nullptr;
  int i_ = 0, j_ = 0;
};

}  // namespace aomd
