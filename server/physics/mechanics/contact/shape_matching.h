#pragma once
// Map from forces on a proxy shape around a soft body to the body's nodes.

#include <array>
#include <vector>

#include "common/mesh.h"
#include "server/physics/mechanics/contact/contact.h"

namespace prosector {

/// Shape-matching map: a proxy shape's points as weighted sums of nodes. The point p of the shape moves with
/// the affine map that fits the nodes best (Müller et al. 2005, "Meshless deformations based on shape
/// matching"). With c the nodes' mean, C their covariance,
///   w_i = (1 + (x_i − c)ᵀ C⁺ (p − c)) / n,  so that  Σ w_i = 1 and Σ w_i x_i = p.
///
/// By transposition, the node forces w_i·f have the resultant force and moment of f at p. A body without
/// extent in some direction (a flat sheet) takes no moment from arms in that direction. A few dozen nodes,
/// spread over the surface, are used. They are divided into shares of at most ContactSide::most_nodes, and
/// each share takes a fraction of the force.
class ShapeMatching {
 public:
  explicit ShapeMatching(const Anatomy& anatomy);
  /// Fits the map to the node positions x (3n, m).
  void fit(const VecX& x);
  std::size_t shares() const { return shares_.size(); }
  /// Fills the side of a contact at p with that normal, for the given share. Clamps p first to the nodes'
  /// extent along the normal, which does not change the effect of a force along the normal. Returns the
  /// clamped point.
  Vec3 hang(const Vec3& p, const Vec3& normal, std::size_t share, ContactSide& side) const;

  /// Returns the angular velocity (rad/s) of the affine motion that fits the node velocities v (3n, m/s)
  /// best.
  Vec3 spin(const VecX& v) const;

 private:
  struct Share {
    std::vector<std::uint32_t> nodes;
    std::vector<Vec3> arms;  // m, x_i − c
    Vec3 centre = Vec3::Zero();
    Mat3 inverse = Mat3::Zero();  // C⁺, 1/m²
  };
  std::vector<Share> shares_;
};

}  // namespace prosector
