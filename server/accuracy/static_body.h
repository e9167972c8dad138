#pragma once
// A single soft body at rest under steady loads: the minimum of the potentials of its elasticity, ties and
// loads, found to convergence by projected Newton. Neither time steps nor limited effort play a role: the
// remaining errors are those of mesh, element and law.

#include <functional>
#include <memory>

#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector {

struct SoftMatter;

/// Shape of a body at rest under a load.
struct StaticAnswer {
  VecX x;                // 3n, m
  bool settled = false;  // the last Newton step gained less than 1e-7 of the energy
  double inverted = 0;   // share of the rest volume that is inside out, or nearly
  bool usable() const;   // settled, and at most a hundredth inside out
};

class StaticBody {
 public:
  /// Makes the body. `anatomy` is in the world frame. Throws InputError as SoftBody does.
  StaticBody(const SoftDesc& desc, Anatomy anatomy);
  ~StaticBody();
  StaticBody(StaticBody&&) noexcept;

  /// Returns the mesh; for quadratic elements with the edge midpoints among the nodes.
  const TetMesh& mesh() const;
  const VecX& rest() const;    // 3n, m
  const VecX& mass() const;    // n, kg
  const VecX& volume() const;  // n, m³
  /// Returns the force (3n, N) of its weight under an acceleration (m/s²), as its elements bear it.
  VecX weight(const Vec3& acceleration) const;
  bool quadratic() const;
  const SoftMatter& matter() const { return *matter_; }

  /// Ties the nodes to their rest positions by springs, besides the ties of the description. Replaces the
  /// springs of an earlier call. `stiffness`: n, N/m.
  void tie(const VecX& stiffness);

  /// Finds the shape at rest under `load` (3n, N), starting from the rest shape. Something must tie the body.
  /// `before_step` is called before each Newton step, and may throw to abort.
  StaticAnswer settle(const VecX& load, const std::function<void()>& before_step = {});

 private:
  struct Newton;
  std::unique_ptr<SoftMatter> matter_;
  std::unique_ptr<Newton> newton_;
  VecX described_;  // n, N/m: the ties of the description
};

}  // namespace prosector
