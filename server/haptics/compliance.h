#pragma once
// How far a soft body gives way where it is pressed, per newton. It solves K·u = f for the load that presses,
// with K the static tangent of its elements, ties and supports as they are now. Neither its step nor its
// inertia is in it, so a hand that rests feels what tissue is and not what a tick makes of it.

#include <memory>
#include <vector>

#include "common/mesh.h"
#include "common/scene/scene.h"
#include "server/physics/simulation.h"

namespace prosector {

struct SoftMatter;

/// A load spread over points of a body; the weights add up to 1.
struct Patch {
  std::vector<ContactSide> points;
  std::vector<double> weight;
  Vec3 normal = Vec3::UnitY();  // unit, out of the body
};

/// Metres per newton of a patch's load, along its normal and along its plane.
struct Compliance {
  double normal = 0, tangential = 0;
};

class TissueCompliance {
 public:
  /// Makes a copy of the body to ask, with elements, matrices and levels of its own. `ties`: n, N/m.
  TissueCompliance(const SoftDesc& desc, Anatomy anatomy, const VecX& ties);
  ~TissueCompliance();

  /// Returns what each patch gives way with the nodes at x (3n, m). `stiffness`: times what is described.
  std::vector<Compliance> find(const VecX& x, double stiffness, const std::vector<Support>& supports,
                               const std::vector<Patch>& patches);

 private:
  struct Solver;
  std::unique_ptr<SoftMatter> matter_;
  std::unique_ptr<Solver> solver_;
};

}  // namespace prosector
