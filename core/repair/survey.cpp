#include "core/repair/survey.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <string_view>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/base/text.h"
#include "core/repair/stages.h"

namespace aomd {
namespace {

using namespace repair_detail;

// The surface without its attributes: what a survey works on and spoils.
MeshData bare_surface(const MeshData& data) {
  MeshData bare;
  bare.positions = data.positions;
  bare.edges.shapes = data.edges.shapes;
  bare.edges.vertices = data.edges.vertices;
  bare.faces = data.faces;
  return bare;
}

struct EdgeCounts {
  Tally border, crowded;  ///< of one face, and of three or more; by their first face
};

EdgeCounts count_edges(const Surface& surface) {
  EdgeCounts counts;
  EdgeUses(surface).each([&](std::span<const EdgeUses::Use> uses) {
    const std::uint32_t f = surface.face_of(uses[0].corner());
    if (uses.size() == 1) counts.border.add(f);
    if (uses.size() > 2) counts.crowded.add(f);
  });
  return counts;
}

// Vertices at which faces do not all hang together through edges there.
Tally bow_ties(const Surface& surface) {
  DisjointSets fans(surface.corner_count());
  EdgeUses(surface).each([&](std::span<const EdgeUses::Use> uses) {
    const auto low = [&](EdgeUses::Use u) {
      return u.forward() ? u.corner() : surface.next(u.corner());
    };
    const auto high = [&](EdgeUses::Use u) {
      return u.forward() ? surface.next(u.corner()) : u.corner();
    };
    for (const EdgeUses::Use use : uses) {
      fans.unite(low(uses[0]), low(use));
      fans.unite(high(uses[0]), high(use));
    }
  });
  std::vector<std::uint8_t> count(surface.vertex_count(), 0);
  surface.each_corner([&](std::uint32_t c) {
    std::uint8_t& own = count[surface.vertex(c)];
    if (fans.find(c) == c) own = std::min(own + 1, 2);
  });
  Tally result;
  for (std::uint32_t v = 0; v < count.size(); ++v)
    if (count[v] > 1) result.add(v);
  return result;
}

std::string digits(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, 6).ptr};
}

class Survey {
 public:
  explicit Survey(const MeshData& data)
      : given_(data), data_(bare_surface(data)), surface_(data_), edges_(count_edges(surface_)) {}

  std::vector<SurfaceFinding> run() {
    isolated();
    borders();
    flat_faces();
    const bool repeated = coincident();
    const EdgeCounts distinct = repeated ? count_edges(surface_) : edges_;
    crowded_edges(distinct.crowded.count(), repeated);
    joined_fans();
    orientation();
    weld(distinct.border.count());
    return std::move(findings_);
  }

 private:
  void tell(const Tally& tally, int dimension, const char* name, SurfaceProperty breaks,
            Remedy remedy, const std::string& text, double tolerance = 0) {
    if (tally.count() == 0) return;
    std::vector<std::uint32_t> first;  // a face may have several of the edges
    for (const std::uint32_t id : tally.first())
      if (std::find(first.begin(), first.end(), id) == first.end()) first.push_back(id);
    findings_.push_back({{name, text, tally.count(), dimension, first}, breaks, remedy, tolerance});
  }

  void borders() {
    tell(edges_.border, 1, "border edges", SurfaceProperty::Closed, Remedy::None,
         counted(edges_.border.count(), "edge") + " of one face");
  }

  // Faces without area whose mending would change the surface stay, and a repair says so.
  void flat_faces() {
    Tally flat;
    surface_.each_face([&](std::uint32_t f) {
      const auto v = std::as_const(surface_).vertices(f);
      bool in_line = true;
      for (std::size_t k = 2; k < v.size() && in_line; ++k)
        in_line =
            collinear(surface_.position(v[0]), surface_.position(v[1]), surface_.position(v[k])) &&
            (k == 2 ||
             collinear(surface_.position(v[0]), surface_.position(v[2]), surface_.position(v[k])));
      if (in_line) flat.add(f);
    });
    const std::size_t stay = flat.count() == 0 ? 0 : left_by_repair("zero area");
    tell(flat, 2, "zero area", SurfaceProperty::Nondegenerate,
         stay == flat.count() ? Remedy::None : Remedy::Repair,
         counted(flat.count(), "face") + " without area" +
             (stay == 0 ? "" : ", " + std::to_string(stay) + " of them to stay"));
  }

  [[nodiscard]] std::size_t left_by_repair(std::string_view name) const {
    MeshData mended = given_;
    mended.attributes.clear();
    for (const RepairItem& item : repair(mended).left)
      if (item.name == name) return item.count;
    return 0;
  }

  // Takes repeated and opposite faces out; whether there were any.
  bool coincident() {
    const Coincident r = mend_coincident(surface_, true, true);
    tell(r.repeated, 2, "repeated faces", SurfaceProperty::Distinct, Remedy::Repair,
         counted(r.repeated.count(), "face") + " on the vertices of others, the same way round");
    tell(r.opposite, 2, "opposite faces", SurfaceProperty::Distinct, Remedy::Repair,
         counted(r.opposite.count(), "face") + " in pairs back to back on the same vertices");
    tell(r.sheets, 2, "back faces", SurfaceProperty::Distinct, Remedy::Repair,
         counted(r.sheets.count(), "back face") + " of sheets listed from both sides");
    return r.repeated.count() + r.opposite.count() + r.sheets.count() > 0;
  }

  void crowded_edges(std::size_t distinct, bool repeated) {
    const std::string rest =
        repeated ? ", " + std::to_string(distinct) + " without the repeated ones" : "";
    const std::size_t all = edges_.crowded.count();
    const bool meant =
        all > 0 && !given_.edges.classes.empty() && left_by_repair("non-manifold edges") == all;
    tell(edges_.crowded, 1, "non-manifold edges", SurfaceProperty::Manifold,
         meant ? Remedy::None : Remedy::Repair,
         counted(edges_.crowded.count(), "edge") + " of three or more faces" + rest);
  }

  void joined_fans() {
    const Tally joined = bow_ties(surface_);
    tell(joined, 0, "bow-ties", SurfaceProperty::Manifold, Remedy::Repair,
         counted(joined.count(), "vertex") + (joined.count() == 1 ? " joins" : " join") +
             " several fans of faces");
  }

  void orientation() {
    const Oriented r = mend_orientation(surface_);
    tell(r.turned, 2, "mixed orientation", SurfaceProperty::Oriented, Remedy::Repair,
         counted(r.turned.count(), "face") + " turned against the neighbours");
    tell(r.twisted, 2, "one-sided pieces", SurfaceProperty::Oriented, Remedy::None,
         counted(r.twisted.count(), "piece") + " that cannot be oriented");
  }

  void weld(std::size_t border) {
    if (border == 0) return;
    border = close(border, 0, "unwelded borders", "lie on others");
    const double tolerance = border == 0 ? 0 : gap_tolerance(surface_);
    if (tolerance > 0)
      close(border, tolerance, "gaps", "lie within " + digits(tolerance) + " of others");
  }

  // Welds, and tells how many border edges get a second face and keep it where edges of three or
  // more come apart, as in a repair; returns how many others there are.
  std::size_t close(std::size_t border, double tolerance, const char* name,
                    const std::string& where) {
    const std::vector<std::uint32_t> at_border = border_sides();
    const Weld weld(surface_, tolerance);
    std::vector<std::uint32_t> left = border_sides();
    if (left.size() < at_border.size()) {
      (void)mend_repeated_vertices(surface_);
      (void)mend_coincident(surface_, true, true);
      (void)mend_fans(surface_, weld, true);
      left = border_sides();
    }
    Tally closed;
    std::vector<std::uint32_t> sides;
    std::set_difference(at_border.begin(), at_border.end(), left.begin(), left.end(),
                        std::back_inserter(sides));
    for (const std::uint32_t c : sides) closed.add(surface_.face_of(c));
    tell(closed, 1, name, SurfaceProperty::Welded, Remedy::Weld,
         std::to_string(closed.count()) + " of " + counted(border, "border edge") + " " + where,
         tolerance);
    return border - closed.count();
  }

  // The corner at which each side of one face starts, ascending.
  [[nodiscard]] std::vector<std::uint32_t> border_sides() const {
    std::vector<std::uint32_t> corners;
    EdgeUses(surface_).each([&](std::span<const EdgeUses::Use> uses) {
      if (uses.size() == 1) corners.push_back(uses[0].corner());
    });
    std::sort(corners.begin(), corners.end());
    return corners;
  }

  void isolated() {
    const std::vector<std::uint8_t> used = used_vertices(data_);
    Tally alone;
    for (std::uint32_t v = 0; v < used.size(); ++v)
      if (!used[v]) alone.add(v);
    tell(alone, 0, "isolated vertices", SurfaceProperty::Used, Remedy::DropUnused,
         counted(alone.count(), "vertex") + " that nothing uses");
  }

  const MeshData& given_;
  MeshData data_;
  Surface surface_;
  EdgeCounts edges_;
  std::vector<SurfaceFinding> findings_;
};

}  // namespace

const char* property_name(SurfaceProperty property) {
  constexpr std::array<const char*, surface_property_count> names{
      "closed", "welded", "distinct", "oriented", "manifold", "nondegenerate", "used", "embedded"};
  return names[static_cast<std::size_t>(property)];
}

std::vector<SurfaceFinding> survey(const MeshData& data) {
  if (!data.regions.empty()) return {};
  return Survey(data).run();
}

}  // namespace aomd
