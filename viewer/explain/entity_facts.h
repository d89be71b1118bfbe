#pragma once
// What there is to say about one entity: what a panel lists and what is copied as text.

#include <string>
#include <utility>
#include <vector>

#include "viewer/document/document.h"
#include "viewer/explain/entity_verdict.h"

namespace aomd::scene {

/// The entities of one level that are adjacent to it.
struct AdjacentLevel {
  int level = 0;
  std::vector<std::uint32_t> ids;
  bool stored = false;
  bool known = true;  ///< false: nothing that is stored leads there
  /// Of each id: whether it is used in its own direction; empty where no use directions are stored.
  std::vector<bool> forwards = {};
  std::string how;  ///< "stored", or the path that answers it; where there is none, what to store
};

struct EntityFacts {
  EntityRef entity;
  std::vector<std::pair<std::string, std::string>> facts;  ///< "Length", "0.012"
  std::vector<AdjacentLevel> adjacent;                     ///< the three other levels, lowest first
};

/// The entity must be alive. Through explain() (core/mesh/derive.h); never builds a hash set.
[[nodiscard]] EntityFacts entity_facts(const Document& document, EntityRef e);

/// "812", where a use direction is known "+812" or "-812".
[[nodiscard]] std::string adjacent_text(const AdjacentLevel& level, std::size_t which);
/// "Edge 812"
[[nodiscard]] std::string entity_title(EntityRef e);
/// "e812"
[[nodiscard]] std::string entity_label(EntityRef e);
/// "model face 3", or "not classified".
[[nodiscard]] std::string model_words(ModelRef ref);
/// All of it as lines of text, the judgement included where there is one.
[[nodiscard]] std::string entity_facts_text(const EntityFacts& inspection,
                                            const EntityVerdict* judgement);

}  // namespace aomd::scene
