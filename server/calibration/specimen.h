#pragma once
// A deformable body that a benchmark steps: made by one of our rungs, or by another simulator.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/mesh.h"

namespace prosector {

/// Description of a piece of tissue to be tested: mesh, material and supports.
struct TestPiece {
  TetMesh mesh;
  double youngs_modulus = 3e5;  // Pa
  double poisson_ratio = 0.3;
  double density = 1000;         // kg/m³
  double damping_mass = 0;       // 1/s, Rayleigh
  double damping_stiffness = 0;  // s
  /// Axis (0, 1 or 2: x, y or z) on which nodes with the coordinate 0 are held in place. −1: no nodes are.
  int clamped_axis = -1;
  double hold_stiffness = 1e13;  // N/m⁴, of the springs that hold nodes: see AttachDesc
  /// Factor on Young's modulus in the half of the piece beyond the middle of its x-extent. (Only for our own
  /// model configurations, not for other simulators.)
  double stiffness_ratio = 1;
  /// Rest position (m) of a node that is held in place; empty: none. (Only for our own model configurations,
  /// not for other simulators.)
  std::optional<Vec3> held_point;
  /// Cells of a sheet or segments of a rope, as indices of the mesh's nodes, used instead of tetrahedra: see
  /// Anatomy. (Only for our own model configurations, not for other simulators.)
  std::vector<std::array<std::uint32_t, 4>> quads = {};
  std::vector<std::array<std::uint32_t, 2>> segments = {};
  double thickness = 0;  // m, of a sheet; diameter of a rope
};

/// Report of one time step of a benchmarked body: the solver's convergence, and any deviation from the
/// configuration.
struct StepFigures {
  double residual = 0;        // relative, of the last linear solve
  int solver_iterations = 0;  // of the linear solver
  bool converged = true;
  bool reported = false;    // the step reported a deviation from its configuration, or a reset: see `note`
  bool refused = false;     // not done as configured, since the method needs more substeps than allowed
  bool reset = false;       // put back to an earlier state, or unfolded
  bool guarded = false;     // repeated or shortened, so that it does not gain energy
  bool recovering = false;  // under the recovery law, until its shape is valid again
  std::string note;
};

/// Interface of a simulated body that advances in time steps, whether by this program or by another
/// simulator.
class Steppable {
 public:
  virtual ~Steppable() = default;
  virtual VecX positions() const = 0;  // 3n, m
  virtual StepFigures step(double dt, const Vec3& gravity) = 0;
};

class Specimen : public Steppable {
 public:
  virtual std::size_t elements() const = 0;
  /// Returns the mass (kg) of each of the n nodes of the mesh that the specimen is simulated with.
  virtual const VecX& node_mass() const = 0;
  virtual VecX rest() const = 0;        // 3n, m
  virtual VecX velocities() const = 0;  // 3n, m/s
  virtual void set_motion(const VecX& x, const VecX& v) = 0;
  /// Returns the elastic energy (J) of the body at its current node positions; NaN if the simulator does not
  /// report it.
  virtual double elastic_energy() = 0;
  /// Returns the potential energy (J) of the body's weight under `gravity` (m/s²), with the weight
  /// distributed as in the body's elements. The default computes it from the node masses.
  virtual double weight_energy(const Vec3& gravity) const;
};

/// Returns the centre of mass (m). momentum() returns the momentum (kg·m/s).
Vec3 mass_center(const Specimen& specimen);
Vec3 momentum(const Specimen& specimen);
double kinetic_energy(const Specimen& specimen);
/// Returns the total volume (m³) of the mesh's tetrahedra with nodes at the positions x (3n, m; corner nodes
/// first).
double volume(const TetMesh& mesh, const VecX& x);

}  // namespace prosector
