#pragma once
// Typed 4-byte handles of mesh entities. Comparing two kinds does not compile.

#include <compare>
#include <cstdint>
#include <functional>

#pragma GCC visibility push(default)

namespace aomd {

/// An index that means "no entity".
inline constexpr std::uint32_t no_index = 0xffffffffu;

/// A mesh entity of dimension Dim (0 vertex, 1 edge, 2 face, 3 region): an index into the mesh's
/// arrays. Ids are stable while the entity lives; the id of a deleted entity is given to a later
/// one.
template <int Dim>
struct Handle {
  static_assert(Dim >= 0 && Dim <= 3);
  static constexpr int dimension = Dim;

  std::uint32_t index = no_index;

  constexpr Handle() = default;
  constexpr explicit Handle(std::uint32_t i) : index(i) {}
  [[nodiscard]] constexpr bool valid() const { return index != no_index; }

  friend constexpr bool operator==(Handle, Handle) = default;
  friend constexpr auto operator<=>(Handle, Handle) = default;
};

using Vertex = Handle<0>;
using Edge = Handle<1>;
using Face = Handle<2>;
using Region = Handle<3>;

/// An entity of a dimension known only at run time: for journals, findings and selections.
struct EntityRef {
  std::uint8_t dimension = 0;
  std::uint32_t index = no_index;

  constexpr EntityRef() = default;
  constexpr EntityRef(int dim, std::uint32_t i)
      : dimension(static_cast<std::uint8_t>(dim)), index(i) {}
  template <int Dim>
  // NOLINTNEXTLINE(google-explicit-constructor): a vertex is an entity
  constexpr EntityRef(Handle<Dim> h) : EntityRef(Dim, h.index) {}
  [[nodiscard]] constexpr bool valid() const { return index != no_index; }
  friend constexpr bool operator==(EntityRef, EntityRef) = default;
  friend constexpr auto operator<=>(EntityRef, EntityRef) = default;
};

/// "vertex", "edge", "face" or "region".
[[nodiscard]] constexpr const char* entity_name(int dimension) {
  constexpr const char* names[] = {"vertex", "edge", "face", "region"};
  return names[dimension];
}

}  // namespace aomd

template <int Dim>
struct std::hash<aomd::Handle<Dim>> {
  std::size_t operator()(aomd::Handle<Dim> h) const noexcept { return h.index; }
};

#pragma GCC visibility pop
