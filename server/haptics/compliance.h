#pragma once
// Static stiffness of a soft body as a rigid hand feels it. The hand moves by e, and (K + Σ WᵀDW)·u = Σ WᵀD·e
// is solved for the displacements u of the nodes. K is the tangent stiffness of the body's elements and ties
// in their current state. D holds the stiffness of the contact springs, W the nodes' weights at the contact
// points. The time step is left out, and inertia only supports a body that nothing holds. So a hand at rest
// feels the tissue and not the integrator.

#include <memory>
#include <vector>

#include "common/mesh.h"
#include "common/scene/scene.h"
#include "server/physics/simulation.h"

namespace prosector::soft {
struct SoftMatter;
}  // namespace prosector::soft

namespace prosector {

/// Points at which a hand presses a soft body, or is about to. Each point acts as a spring between body and
/// hand.
struct Patch {
  struct Point {
    contact::ContactSide side;
    Mat3 stiffness = Mat3::Zero();  // N/m: along the point's own normal
    Mat3 holding = Mat3::Zero();    // N/m: tangential, while friction sticks
  };
  std::vector<Point> points;
  Vec3 normal = Vec3::UnitY();  // unit, out of the body
  HandRef hand;
  bool presses = false;  // true: in contact; false: only close to it
};

/// Stiffness (N/m) of the contact between a hand and a soft body: how its force grows as the whole hand moves
/// along the patch's normal, and along its plane. Friction does not count in `normal`: it sticks only over
/// hundredths of a millimetre, then tissue slides past the finger.
struct Slopes {
  double normal = 0, tangential = 0;
};

class TissueCompliance {
 public:
  /// Makes a copy of the soft body to compute on, with separate elements, matrices and multigrid levels.
  /// `ties` is the stiffness (n, N/m) of the attachments at each node.
  TissueCompliance(const SoftDesc& desc, Anatomy anatomy, const VecX& ties);
  ~TissueCompliance();

  /// Returns the stiffness that a hand feels at each patch of contact points, with the body's nodes at x (3n,
  /// m). `strength` is a factor on the stiffness of the described material. `supports` are the contacts and
  /// holds that support the body elsewhere.
  std::vector<Slopes> find(const VecX& x, double strength, const std::vector<Support>& supports,
                           const std::vector<Patch>& patches);

 private:
  struct Solver;
  std::unique_ptr<soft::SoftMatter> matter_;
  std::unique_ptr<Solver> solver_;
};

}  // namespace prosector
