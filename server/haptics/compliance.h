#pragma once
// How a soft body pushes back where a rigid hand presses it. The hand moves by e, and (K + Σ WᵀDW)·u = Σ
// WᵀD·e is solved. Here K is the static tangent of the body's elements and ties as they are now, and D the
// contacts' springs. Neither the body's step nor its inertia is in it. So a hand that rests feels what tissue
// is, and not what a tick makes of it.

#include <memory>
#include <vector>

#include "common/mesh.h"
#include "common/scene/scene.h"
#include "server/physics/simulation.h"

namespace prosector {

struct SoftMatter;

/// Points of a body where a hand presses it, or will. Each is a spring between the point and the hand.
struct Patch {
  struct Point {
    ContactSide side;
    Mat3 stiffness = Mat3::Zero();  // N/m: along its own normal
    Mat3 holding = Mat3::Zero();    // N/m: of friction, while it holds
  };
  std::vector<Point> points;
  Vec3 normal = Vec3::UnitY();  // unit, out of the body
  HandRef hand;
  bool presses = false;  // now; else it is only near
};

/// How a patch's force grows, N/m, as the whole hand moves along the patch's normal, and along its plane.
/// What slides past a finger on its way in has no part in the first: friction holds over hundredths of a
/// millimetre.
struct Slopes {
  double normal = 0, tangential = 0;
};

class TissueCompliance {
 public:
  /// Makes a copy of the body to ask, with elements, matrices and levels of its own. `ties`: n, N/m.
  TissueCompliance(const SoftDesc& desc, Anatomy anatomy, const VecX& ties);
  ~TissueCompliance();

  /// Returns the slopes of each patch with the nodes at x (3n, m). `strength`: how many times as stiff the
  /// material is as described.
  std::vector<Slopes> find(const VecX& x, double strength, const std::vector<Support>& supports,
                           const std::vector<Patch>& patches);

 private:
  struct Solver;
  std::unique_ptr<SoftMatter> matter_;
  std::unique_ptr<Solver> solver_;
};

}  // namespace prosector
