#pragma once
// Map from forces on a proxy shape around a soft body to the body's nodes.

#include <array>
#include <vector>

#include "common/mesh.h"
#include "server/physics/mechanics/contact/contact.h"

namespace prosector::contact {

/// Map that expresses a point of a soft body's proxy shape (a sphere, box or hull that replaces it in
/// contact) as a weighted sum of nodes. The point p moves with the affine map that fits the nodes best
/// (Müller et al. 2005, "Meshless deformations based on shape matching"). With c the nodes' mean, C their
/// covariance and n their number,
///
/// w_i = (1 + (x_i − c)ᵀ C⁺ (p − c)) / n,  so that  Σ w_i = 1 and Σ w_i x_i = p.
///
/// By transposition, the node forces w_i·f have the resultant force and moment of f at p. A body without
/// extent in some direction (a flat sheet) takes no moment from arms in that direction. A few dozen nodes,
/// spread over the surface, are used. They are divided into shares of at most ContactSide::most_nodes, and
/// each share takes a fraction of the force.
class ShapeMatching {
 public:
  explicit ShapeMatching(const Anatomy& anatomy);
  /// Recomputes mean and covariance of the nodes from their current positions x (three coordinates per node,
  /// m).
  void fit(const VecX& x);
  std::size_t shares() const { return shares_.size(); }
  /// Sets the nodes and weights of a contact's side for the point p (m, world frame), so that the contact
  /// force acts on the given share of the nodes. Before that, p is moved along `normal` to within the nodes'
  /// extent, which does not change the effect of a force along the normal. Returns the moved point.
  Vec3 hang(const Vec3& p, const Vec3& normal, std::size_t share, ContactSide& side) const;

  /// Returns the body's mean angular velocity (rad/s): that of the affine motion that fits the node
  /// velocities v (three coordinates per node, m/s) best.
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

}  // namespace prosector::contact
