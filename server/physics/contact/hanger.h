#pragma once
// How a force that acts on a shape around a soft body gets to its nodes.

#include <array>
#include <vector>

#include "common/mesh.h"
#include "server/physics/contact/contact.h"

namespace prosector {

/// A proxy shape's points as moved by nodes. The point p of the shape moves as the affine map does that fits
/// the nodes best (Müller et al. 2005, "Meshless deformations based on shape matching"). With c the nodes'
/// mean, C their covariance,
///   w_i = (1 + (x_i − c)ᵀ C⁺ (p − c)) / n,  so that  Σ w_i = 1 and Σ w_i x_i = p.
///
/// Transposed, the nodes' forces w_i·f have the force and the moment of f at p. What has no extent in some
/// direction (a flat sheet) takes no moment about what lies in it. A few dozen nodes all over the surface
/// serve, in shares of as many as a contact's side has: each share takes its part of the force.
class Hanger {
 public:
  explicit Hanger(const Anatomy& anatomy);
  /// Fits the map to the positions x (3n, m) of the nodes.
  void fit(const VecX& x);
  std::size_t shares() const { return shares_.size(); }
  /// Fills one side of a contact: that at p with that normal which goes to the given share. First p is taken
  /// to the nodes' own extent along the normal, which changes nothing about a force along it. Returns that
  /// point.
  Vec3 hang(const Vec3& p, const Vec3& normal, std::size_t share, ContactSide& side) const;

  /// Returns the spin (rad/s) of the affine motion that fits the nodes' velocities v (3n, m/s) best.
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
