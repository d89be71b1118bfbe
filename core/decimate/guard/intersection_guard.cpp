#include "core/decimate/guard/intersection_guard.h"

#include "core/model/triangle_intersection.h"

namespace aomd {

void IntersectionGuard::take(Face face, const Triangle& corners) {
  if (without_area(corners)) return;
  pieces_.push_back({corners, box_of(corners), face});
}

void IntersectionGuard::mark(std::span<const Face> faces) {
  if (++stamp_ == 0) stamps_.assign(stamps_.size(), 0), stamp_ = 1;
  for (const Face f : faces) stamps_[f] = stamp_;
}

void IntersectionGuard::find_others(const Change& change) {
  mark(change.replaced);
  Box all;
  for (const Piece& p : pieces_) all.add(p.box);
  others_.clear();
  tree_.touching(all, [&](const FaceTree::Item& item, const Box& box) {
    if (stamps_[item.face] != stamp_) others_.push_back({&item, &box});
  });
}

// Pairs of intersecting faces of which at least one is a piece; stops past the limit.
std::size_t IntersectionGuard::cuts(std::size_t limit, Face& cut) const {
  std::size_t found = 0;
  const auto count = [&](Face face) {
    cut = face;
    return ++found > limit;
  };
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Piece& p = pieces_[i];
    for (const auto& [other, box] : others_)
      if (p.box.touches(*box) && tree_.cuts(p.corners, *other) && count(other->face)) return found;
    for (std::size_t k = 0; k < i; ++k)
      if (p.box.touches(pieces_[k].box) && intersect(p.corners, pieces_[k].corners) &&
          count(pieces_[k].face))
        return found;
  }
  return found;
}

std::size_t IntersectionGuard::cuts_now(const Change& change) {
  pieces_.clear();
  for (const Face f : change.replaced) take(f, tree_.item(f).corners);
  find_others(change);
  Face cut;
  return cuts(static_cast<std::size_t>(-1), cut);
}

Verdict IntersectionGuard::judge(const Change& change) {
  const auto made = [&](std::size_t limit, Face& cut) {
    pieces_.clear();
    for (const NewFace& f : change.created) take(f.face, f.corners);
    find_others(change);
    return cuts(limit, cut);
  };
  Face cut;
  if (made(0, cut) == 0) return {};
  const std::size_t now = cuts_now(change);
  if (now > 0 && made(now, cut) <= now) return {};
  return {Reason::Intersection, cut};
}

void IntersectionGuard::applied(const Change& change) {
  mark(change.replaced);
  for (const NewFace& f : change.created) {
    stamps_[f.face] = 0;
    tree_.put(f.face, f.corners);
  }
  for (const Face f : change.replaced)
    if (stamps_[f] == stamp_) tree_.remove(f);
  tree_.tidy();
}

}  // namespace aomd
