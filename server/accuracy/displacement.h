#pragma once
// Compares displacements of bodies with different meshes at the same positions, interpolated with their shape
// functions.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "server/accuracy/static_body.h"

namespace prosector {

/// Returns about `count` positions (m) spread evenly over the volume of the mesh at rest, each inside a
/// tetrahedron. There are fewer if the mesh has fewer tetrahedra.
std::vector<Vec3> places_in(const TetMesh& mesh, std::size_t count);

/// Positions at which displacements of bodies with different meshes are compared. Each is located once in a
/// body at rest, and its displacement is then interpolated from that body's nodes.
class Probes {
 public:
  Probes(const StaticBody& body, std::span<const Vec3> places);
  /// Returns the displacement (m) of the tissue that at rest is at the k-th of `places`, when the body's
  /// nodes are at `x` (3n, m). Returns nothing if that position at rest is outside the body's mesh.
  std::optional<Vec3> displacement(std::size_t k, const VecX& x) const;

 private:
  struct Row {
    std::array<std::uint32_t, 10> node{};
    std::array<double, 10> weight{};
  };
  const StaticBody& body_;
  std::vector<std::optional<Row>> rows_;
};

/// Returns the relative difference between the displacements of two bodies: the root mean square of their
/// difference, divided by the root mean square of the second body's. The mean is over the positions that lie
/// in both bodies, out of `places`. Throws std::logic_error if they share less than half of the positions.
double relative_difference(const Probes& a, const VecX& x_a, const Probes& b, const VecX& x_b,
                           std::size_t places);

}  // namespace prosector
