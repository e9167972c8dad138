#pragma once
// Compares displacements of bodies with different meshes at the same positions, interpolated with their shape
// functions.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "server/accuracy/static_body.h"

namespace prosector {

/// Returns about `count` positions that are spread evenly over the volume at rest, each inside a tetrahedron.
/// There are fewer if the mesh has fewer tetrahedra.
std::vector<Vec3> places_in(const TetMesh& mesh, std::size_t count);

/// Positions in the room, located in a body at rest.
class Probes {
 public:
  Probes(const StaticBody& body, std::span<const Vec3> places);
  /// Returns the displacement from rest of the tissue at position k, m, with nodes at `x` (3n); nothing where
  /// the position is outside the mesh.
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
/// at the positions that both contain. Throws std::logic_error where they share less than half of the
/// positions.
double relative_difference(const Probes& a, const VecX& x_a, const Probes& b, const VecX& x_b,
                           std::size_t places);

}  // namespace prosector
