#pragma once
// A soft body by itself, at rest under steady loads: the minimum of its elastic energy, its ties' and the
// loads' potential, found to the end by projected Newton. Neither time nor effort is in it: what is left is
// what mesh, element and law get wrong.

#include <functional>
#include <memory>

#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector {

struct SoftMatter;

/// Where a body comes to rest.
struct StaticAnswer {
  VecX x;                // 3n, m
  bool settled = false;  // the last Newton step gained less than 1e-7 of the energy
  double inverted = 0;   // share of the rest volume inside out, or nearly
  bool usable() const;   // settled, and at most a hundredth of it inside out
};

class StaticBody {
 public:
  /// Makes the body. `anatomy` is in the world frame. Throws InputError as SoftBody does.
  StaticBody(const SoftDesc& desc, Anatomy anatomy);
  ~StaticBody();
  StaticBody(StaticBody&&) noexcept;

  /// Returns the mesh; of quadratic elements with the middles of its edges among the nodes.
  const TetMesh& mesh() const;
  const VecX& rest() const;    // 3n, m
  const VecX& mass() const;    // n, kg
  const VecX& volume() const;  // n, m³
  /// Returns the force (3n, N) of its weight under an acceleration (m/s²), as its elements bear it.
  VecX weight(const Vec3& acceleration) const;
  bool quadratic() const;
  const SoftMatter& matter() const { return *matter_; }

  /// Ties the nodes to their places at rest by springs, besides what the description ties, in place of those
  /// before. `stiffness`: n, N/m.
  void tie(const VecX& stiffness);

  /// Finds where the body rests under `load` (3n, N), beginning at rest. Something must tie it. `before_step`
  /// is called before each Newton step, and may throw to give up.
  StaticAnswer settle(const VecX& load, const std::function<void()>& before_step = {});

 private:
  struct Newton;
  std::unique_ptr<SoftMatter> matter_;
  std::unique_ptr<Newton> newton_;
  VecX described_;  // n, N/m: the ties of the description
};

}  // namespace prosector
