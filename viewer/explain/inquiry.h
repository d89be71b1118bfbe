#pragma once
// What is known about the entity that is selected, and about the one that the mouse points at.

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include <glm/vec2.hpp>

#include "viewer/document/document.h"
#include "viewer/document/selection.h"
#include "viewer/drawing/drawable.h"
#include "viewer/drawing/view.h"
#include "viewer/explain/entity_facts.h"
#include "viewer/explain/model_entity.h"
#include "viewer/explain/neighbours.h"

namespace aomd::scene {

/// What the mouse points at.
struct Hovered {
  EntityRef entity;
  glm::dvec2 place;
};

/// Of one document. Asks again where the mesh, the selection or the options have changed.
class Inquiry {
 public:
  /// `busy`: the mesh is on its way, and nothing is judged.
  void update(Document& document, const Selection& selection, const View& view, bool mesh_changed,
              bool busy);
  /// Points at an entity that is alive. Its verdict is asked for where that is known at once.
  void hover(Document& document, const Hovered& at, bool busy);
  void point_at_nothing() { hovered_.reset(); }
  /// What an operation on the selected entity, or on the one that is pointed at, would lead to, or
  /// the neighbours that light up: drawn where that is something else than the last time.
  void draw_preview(const Mesh& mesh, const Selection& selection, const View& view,
                    Drawable& drawable);

  [[nodiscard]] const Hovered* hovered() const { return hovered_ ? &*hovered_ : nullptr; }
  /// One line on it: why an edge stays. Empty where that is not known at once.
  [[nodiscard]] const std::string& hovered_words() const { return hovered_words_; }
  /// Of the only entity that is selected; null where there are none or several.
  [[nodiscard]] const EntityFacts* facts() const { return facts_ ? &*facts_ : nullptr; }
  /// What decimation says about it; null where nothing, and while it runs.
  [[nodiscard]] const EntityVerdict* verdict() const { return verdict_ ? &*verdict_ : nullptr; }
  /// Around it, of the level View::neighbours; null where nothing is to light up.
  [[nodiscard]] const Neighbours* neighbours() const {
    return neighbours_ ? &*neighbours_ : nullptr;
  }
  /// Of the highlighted model entity, while the page about it is up; null: none. As it was before a
  /// run.
  [[nodiscard]] const ModelEntityFacts* model_entity() const {
    return model_entity_ ? &*model_entity_ : nullptr;
  }
  /// Which of the verdict's ways is drawn; their number: the swap.
  [[nodiscard]] std::size_t previewed_way(const View& view) const;

 private:
  /// What the answers about the selected entity follow from, besides the mesh.
  struct Asked {
    std::uint64_t selection = 0, options = 0;
    std::uint32_t relations = 0;  ///< stored_bits()
    bool busy = false;
    friend bool operator==(const Asked&, const Asked&) = default;
  };
  void find_neighbours_anew(const Mesh& mesh, EntityRef e, const View& view);
  void update_model_entity(const Document& document, const View& view, bool busy);
  [[nodiscard]] const EntityVerdict* previewed(const Selection& selection, const View& view) const;

  std::optional<Hovered> hovered_;
  std::string hovered_words_;
  EntityRef hovered_words_of_;
  std::optional<EntityVerdict> hovered_verdict_;
  std::optional<Asked> asked_;
  std::optional<EntityFacts> facts_;
  std::optional<EntityVerdict> verdict_;
  std::optional<Neighbours> neighbours_;
  std::optional<int> neighbours_level_;
  std::optional<std::pair<EntityRef, std::size_t>> drawn_preview_;  ///< of which entity, which way
  std::optional<ModelEntityFacts> model_entity_;
  HistoryPlace model_entity_place_;
};

}  // namespace aomd::scene
