#pragma once
// Displacements of bodies of different meshes at the same places, by their own shape functions.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "server/accuracy/static_body.h"

namespace prosector {

/// Returns `count` places, about, that are spread evenly over the volume at rest, each inside a tetrahedron:
/// fewer where that has fewer of them.
std::vector<Vec3> places_in(const TetMesh& mesh, std::size_t count);

/// Where places of the room lie in a body at rest.
class Probes {
 public:
  Probes(const StaticBody& body, std::span<const Vec3> places);
  /// Returns how far the tissue at place k is from where it rests, m, with nodes at `x` (3n); nothing where
  /// the place is outside of the mesh.
  std::optional<Vec3> displacement(std::size_t k, const VecX& x) const;

 private:
  struct Row {
    std::array<std::uint32_t, 10> node{};
    std::array<double, 10> weight{};
  };
  const StaticBody& body_;
  std::vector<std::optional<Row>> rows_;
};

/// Returns the root mean square of the difference between two bodies' displacements over that of the second,
/// at places that both have. Throws std::logic_error where they share less than half of the places.
double relative_difference(const Probes& a, const VecX& x_a, const Probes& b, const VecX& x_b,
                           std::size_t places);

}  // namespace prosector
