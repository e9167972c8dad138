#pragma once
// What collides in the reference: a rigid body or a soft surface, taken at its own fidelity.

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "common/fidelity.h"
#include "server/physics/mechanics/collision/narrow/collision_piece.h"
#include "server/physics/mechanics/collision/outlines/rigid_outline.h"

namespace prosector {

/// Rigid: see RigidOutline. Soft, fitted to the moved surface in O(vertices), its tree refitted:
///   none    nothing
///   sphere  one sphere, aabb one box along the room's axes, obb one box along principal axes: enclose mesh
///   hull    the hull of its vertices, found through the tree: encloses mesh
///   mesh    its triangles
/// A sheet's thickness is rounding around all of them. All poses and positions are those of the room; SI
/// units.
class CollisionObject {
 public:
  explicit CollisionObject(std::shared_ptr<const collision::RigidOutline> outline);
  /// A soft surface where it is now. Throws InputError as TriangleSurface does, and for a thickness below 0.
  CollisionObject(const TriangleMesh& surface, Fidelity fidelity, double thickness = 0);
  CollisionObject(CollisionObject&&) = default;
  CollisionObject& operator=(CollisionObject&&) = default;

  bool soft() const { return surface_ != nullptr; }
  Fidelity fidelity() const { return soft() ? fidelity_ : outline_->fidelity(); }

  // Each returns false, and changes nothing, when a number isn't finite.
  /// Rigid. m/s, rad/s.
  bool place(const Pose& pose, const Vec3& linear = Vec3::Zero(), const Vec3& angular = Vec3::Zero());
  /// Rigid: a part's pose in the body from now on; takes effect with the next place().
  bool bend(std::size_t part, const Pose& pose);
  /// Soft. `velocities` m/s: one a vertex, or none for a surface at rest. Throws InputError for a wrong
  /// count.
  bool move(std::span<const Vec3> positions, std::span<const Vec3> velocities = {});
  /// Soft, after a cut: another surface in the place of this one, at rest until moved. Throws InputError.
  void cut(const TriangleMesh& surface);

  std::span<const collision::CollisionPiece> pieces() const { return pieces_; }
  /// Around the pieces; empty for none.
  const collision::Aabb& box() const { return box_; }
  const Pose& pose() const { return pose_; }
  /// Soft: its surface; rigid: null.
  const collision::TriangleSurface* surface() const { return surface_.get(); }
  /// A point of the room in the frame that the body has after t seconds; of a soft body, which has none, as
  /// it is.
  Vec3 local(const Vec3& x, double t = 0) const;

  /// Where the pieces are after t seconds of constant velocities: of the body, or of each vertex. A soft obb
  /// keeps its axes.
  std::vector<collision::CollisionPiece> pieces_after(double t) const;
  /// No point of a piece moves differently from `linear` by more than `spread`; m/s.
  struct Speed {
    Vec3 linear = Vec3::Zero();
    double spread = 0;
  };
  Speed speed() const;
  /// Around the pieces over the next t seconds.
  collision::Aabb swept_box(double t) const;

 private:
  void fit_surface();
  std::vector<collision::CollisionPiece> surface_pieces(
      std::shared_ptr<const collision::TriangleSurface> surface, const Quat* axes) const;
  void fit_box();

  std::vector<collision::CollisionPiece> pieces_;
  collision::Aabb box_;
  // Rigid
  std::shared_ptr<const collision::RigidOutline> outline_;
  std::vector<Pose> part_poses_;
  Pose pose_;
  Vec3 linear_ = Vec3::Zero(), angular_ = Vec3::Zero();
  // Soft
  Fidelity fidelity_ = Fidelity::none;
  double rounding_ = 0;
  std::shared_ptr<collision::TriangleSurface> surface_;
  std::vector<Vec3> velocities_;  // empty: at rest
};

}  // namespace prosector
