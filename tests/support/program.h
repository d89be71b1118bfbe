#pragma once
// Random edit programs on a mesh and its plain model: what they do depends on the mesh and the seed
// alone, never on T.

#include <deque>
#include <random>

#include "tests/support/twin.h"

namespace aomd::oracle {

/// What a program may do besides editing.
struct Liberties {
  bool relations = false;   ///< set, unset, request and release
  bool history = false;     ///< attach a journal now and then, undo, redo, seek, detach
  bool compaction = false;  ///< compact()
  bool regions = false;     ///< create regions; then no two faces may have the same vertices
};

class Program {
 public:
  Program(Twin& twin, std::uint64_t seed, Liberties may);

  /// Does one thing, and compares one of the entities that it touched.
  void operation();

 private:
  [[nodiscard]] std::size_t random(std::size_t below) { return random_() % below; }
  [[nodiscard]] EntityRef any(int dim);
  [[nodiscard]] ModelRef any_class(int dim);
  [[nodiscard]] bool conflicts(const Entity& whole) const;
  void edit();
  void create();
  void create_shape(Shape shape, const Ids& vertices);
  void destroy();
  void collapse();
  void remember(EntityRef e);
  [[nodiscard]] bool triangles_only() const;
  void use_operator();
  void collapse_by_operator(Edge e);
  void change_relations();
  void travel();

  Twin& twin_;
  std::mt19937_64 random_;
  Liberties may_;
  Index usual_count_[4];
  std::deque<std::pair<Shape, Ids>> buried_;  ///< deleted not long ago
};

}  // namespace aomd::oracle
