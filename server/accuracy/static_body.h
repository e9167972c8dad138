#pragma once
// A single soft body at rest under steady loads: the minimum of the potentials of its elasticity, ties and
// loads, found to convergence by projected Newton. Neither time steps nor limited effort play a role: the
// remaining errors are those of mesh, element and law.

#include <functional>
#include <memory>

#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector::soft {
struct SoftMatter;
}  // namespace prosector::soft

namespace prosector {

/// Shape of a body at rest under a load, and whether the solver found it.
struct StaticAnswer {
  VecX x;                // 3n, m
  bool settled = false;  // the last Newton step gained less than 1e-7 of the energy
  double inverted = 0;   // share of the rest volume that is inside out, or nearly
  bool usable() const;   // settled, and at most a hundredth inside out
};

class StaticBody {
 public:
  /// Makes the body from its description and its `anatomy`, which is in the world frame. Throws InputError
  /// for descriptions that SoftBody rejects.
  StaticBody(const SoftDesc& desc, Anatomy anatomy);
  ~StaticBody();
  StaticBody(StaticBody&&) noexcept;

  /// Returns the body's mesh at rest. For quadratic elements the edge midpoints are among the nodes.
  const TetMesh& mesh() const;
  const VecX& rest() const;    // 3n, m
  const VecX& mass() const;    // n, kg
  const VecX& volume() const;  // n, m³
  /// Returns the force (3n, N) of the body's weight on its nodes under an acceleration (m/s²), distributed by
  /// the shape functions of its elements.
  VecX weight(const Vec3& acceleration) const;
  bool quadratic() const;
  const soft::SoftMatter& matter() const { return *matter_; }

  /// Ties each node to its rest position by a spring, in addition to the attachments of the description.
  /// Replaces the springs of an earlier call. `stiffness`: n, N/m.
  void tie(const VecX& stiffness);

  /// Finds the shape at rest under `load` (3n, N), starting from the rest shape. Attachments or springs of
  /// tie() must hold the body. `before_step` is called before each Newton step, and may throw to abort.
  StaticAnswer settle(const VecX& load, const std::function<void()>& before_step = {});

 private:
  struct Newton;
  std::unique_ptr<soft::SoftMatter> matter_;
  std::unique_ptr<Newton> newton_;
  VecX described_;  // n, N/m: the ties of the description
};

}  // namespace prosector
