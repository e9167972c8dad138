#pragma once
// What a bench steps: one deformable, made of one of our rungs or by a peer.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/mesh.h"

namespace prosector {

/// A piece of tissue to be tested.
struct TestPiece {
  TetMesh mesh;
  double youngs_modulus = 3e5;  // Pa
  double poisson_ratio = 0.3;
  double density = 1000;         // kg/m³
  double damping_mass = 0;       // 1/s, Rayleigh
  double damping_stiffness = 0;  // s
  /// Nodes whose coordinate on this axis is 0 are held; −1: none is.
  int clamped_axis = -1;
  double hold_stiffness = 1e13;  // N/m⁴, of what holds nodes: see AttachDesc
  /// The half beyond the middle of x is of a material that many times as stiff. (Only by our own rungs.)
  double stiffness_ratio = 1;
  /// The node at this place is held. (Only by our own rungs.)
  std::optional<Vec3> held_point;
  /// On the mesh's nodes, instead of tetrahedra: a sheet's cells or a rope's pieces, see Anatomy. (Only by
  /// our own rungs.)
  std::vector<std::array<std::uint32_t, 4>> quads = {};
  std::vector<std::array<std::uint32_t, 2>> segments = {};
  double thickness = 0;  // m, of a sheet; diameter of a rope
};

/// What one step says of itself.
struct StepFigures {
  double residual = 0;        // relative, of the last linear solve
  int solver_iterations = 0;  // of the linear solver
  bool converged = true;
  bool reported = false;    // not stepped as asked for, or reset, and the step said so: see note
  bool refused = false;     // for the reason that its method would need more substeps than it may take
  bool reset = false;       // put back, or unfolded
  bool guarded = false;     // taken again or shortened, lest it gain energy
  bool recovering = false;  // under another law, until it is whole
  std::string note;
};

/// What goes on in steps of time.
class Steppable {
 public:
  virtual ~Steppable() = default;
  virtual VecX positions() const = 0;  // 3n, m
  virtual StepFigures step(double dt, const Vec3& gravity) = 0;
};

class Specimen : public Steppable {
 public:
  virtual std::size_t elements() const = 0;
  /// Returns the mass (kg) of each node of the mesh that it computes with; n entries.
  virtual const VecX& node_mass() const = 0;
  virtual VecX rest() const = 0;        // 3n, m
  virtual VecX velocities() const = 0;  // 3n, m/s
  virtual void set_motion(const VecX& x, const VecX& v) = 0;
  /// Returns the elastic energy (J) at its positions; not a number when it doesn't tell.
  virtual double elastic_energy() = 0;
  /// Returns the energy (J) of its weight under `gravity` (m/s²), as its elements bear it: by default by
  /// masses.
  virtual double weight_energy(const Vec3& gravity) const;
};

/// Returns the centre of mass; then momentum, and angular momentum about the room's origin.
Vec3 mass_center(const Specimen& specimen);
Vec3 momentum(const Specimen& specimen);
Vec3 angular_momentum(const Specimen& specimen);
double kinetic_energy(const Specimen& specimen);
/// Returns the volume (m³) of the tetrahedra at positions x (3n; corner nodes first).
double volume(const TetMesh& mesh, const VecX& x);
/// Returns the largest distance (m) of a node from where it belongs after the rigid motion that brings `x`
/// closest to `rest`. Closest is meant in the mean over the nodes by mass (Kabsch 1976). Infinite when x is
/// not finite.
double shape_error(const VecX& rest, const VecX& x, const VecX& node_mass);
/// Returns the index of the node at that place of the rest shape. Throws std::logic_error when there is none.
Eigen::Index node_at(const VecX& rest, const Vec3& place);

}  // namespace prosector
