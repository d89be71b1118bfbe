#pragma once
// A mesh and its plain model, edited together: every edit is made in both, what comes out is
// foretold from the plain one, and the first difference is an error.

#include <functional>
#include <map>
#include <optional>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/mesh/journal.h"
#include "core/mesh/mesh.h"
#include "tests/support/oracle.h"

namespace aomd::oracle {

/// Thrown by Twin and by programs: the mesh is not what it should be.
struct Difference : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline void expect(bool condition, const std::string& what) {
  if (!condition) throw Difference(what);
}

class Twin {
 public:
  /// `prepare` sets up the mesh first; the plain model takes over what that creates.
  explicit Twin(const MeshData& data, const std::function<void(Mesh&)>& prepare = {});
  Twin(const Twin&) = delete;
  Twin& operator=(const Twin&) = delete;

  [[nodiscard]] Mesh& mesh() { return mesh_; }
  [[nodiscard]] const Plain& plain() const { return plain_; }

  // Edits; those that must be refused are, and change nothing
  enum class From { Vertices, Edges, Faces };
  Index create_vertex(const glm::dvec3& position, ModelRef model);
  /// False where the mesh refused, as it should.
  bool create(Shape shape, const Ids& vertices, ModelRef model, From from = From::Vertices);
  bool destroy(EntityRef e);
  void destroy_with_users(EntityRef e);
  void move(Vertex v, const glm::dvec3& position);
  bool classify(EntityRef e, ModelRef model);
  /// Puts `kept` in the place of `gone` everywhere, when the link condition, tested by brute force,
  /// holds and nothing but simplices joins the two.
  bool collapse(Vertex gone, Vertex kept);
  /// Takes over what an operator did to the mesh; it may have created nothing.
  void adopt();
  void compact();

  // T
  void set(int i, int j);
  void unset(int i, int j);
  void request(int i, int j);
  void release(std::size_t k);
  [[nodiscard]] std::size_t requests() const { return requests_.size(); }

  // History
  void attach();
  void detach();
  [[nodiscard]] bool attached() const { return mesh_.journal() != nullptr; }
  [[nodiscard]] const Journal& journal() const { return journal_; }
  void undo();
  void redo();
  void seek(std::size_t cursor);

  // Attached data and comparison
  void set_value(EntityRef e, double value);
  /// What was touched last, compared in full.
  void check_touched(std::mt19937_64& random);
  void check_all() const;

 private:
  [[nodiscard]] std::string reason_against(Shape shape, const Ids& vertices, ModelRef model) const;
  void call_create(Shape shape, const Ids& vertices, ModelRef model, From from);
  void take_sides(int dim, const Entity& whole);
  void take_missing(int dim, const std::map<Ids, ModelRef>& missing);
  /// False where the mesh refused, as it should.
  bool complete_by(int i, int j, const std::function<void()>& change);
  [[nodiscard]] bool may_collapse(Index gone, Index kept) const;
  void check_stack(int dim, std::size_t removed);
  void touch(EntityRef e) { touched_.push_back(e); }
  void edited();
  void travelled();
  [[nodiscard]] bool defines(int i, int j) const;
  [[nodiscard]] double value_in_mesh(EntityRef e) const;
  void check_values() const;

  Mesh mesh_;
  Plain plain_;
  Journal journal_;
  std::map<std::size_t, Plain> past_;  ///< by the journal's cursor
  std::size_t cursor_ = 0;             ///< the journal's, after the last edit or travel
  std::map<std::uint64_t, double> values_;
  struct Wish {
    int i, j;
    Request request;
  };
  std::vector<Wish> requests_;
  std::array<std::array<int, 4>, 4> wishes_{};
  std::array<std::array<bool, 4>, 4> user_{};
  std::vector<EntityRef> touched_;
};

}  // namespace aomd::oracle
