#pragma once
// Bodies that go through a tick in substeps of their own, instead of in the island's minimisation: explicit
// and position-based ones.

#include <memory>

#include "common/scene/scene.h"
#include "server/physics/soft/elements/elastic_model.h"
#include "server/physics/soft/integrators/soft_state.h"
#include "server/physics/soft/matrices/block_matrix.h"

namespace prosector {

class Substepper {
 public:
  virtual ~Substepper() = default;
  /// Fills what of the state is this method's own, for a body at rest.
  virtual void initialise(SoftBodyState& state) = 0;
  /// Returns how many equal substeps a tick of h s needs; infinity when no number will do.
  virtual double needed(double h, const SoftBodyState& state) const = 0;
  /// Returns the most substeps that the scene allows.
  virtual int allowed() const = 0;
  /// Tells whether there is a stability limit, so that a tick beyond it is refused with the number. Without
  /// one, a tick turns out to fall short, a loss of accuracy.
  virtual bool has_limit() const { return true; }
  /// Returns how many times what it had and what gravity gave the body's energy may be after a tick of h s.
  /// Methods whose energy swings near their limit are given room, others next to none.
  virtual double most_gain(double h) const = 0;
  /// Returns how many times what impulses gave may be added: next to none for methods that hold by damping
  /// alone. In these a push strikes modes that damping does not reach, and they are stepped by implicit Euler
  /// while they are pushed.
  virtual double most_pushed(double h) const { return most_gain(h) - 1; }
  /// Says for people what of the description the method does not follow; empty: nothing.
  virtual const char* remark() const { return ""; }
  /// Takes what it keeps of each tetrahedron along, if the body has any and it does: `mesh` was edited so.
  virtual void follow(const TetMesh& /*mesh*/, const MeshEdit& /*edit*/) {}
  /// Fits to the body as it is after it, and this, followed a cut: as if made anew, bit for bit.
  virtual void fit() = 0;
  /// Starts a tick.
  virtual void begin(const SoftBodyState& state) = 0;
  /// Steps the body by hs s, free of contacts.
  virtual void step(double hs, const Weight& weight, SoftBodyState& state) = 0;
  /// Ends a tick that took substeps of hs s (0: it was stepped otherwise) and finds what the next one needs.
  /// False when, in hindsight, hs was too long, because the body got stiffer within the tick.
  virtual bool finish(double hs, SoftBodyState& state) = 0;
  /// Refines after a tick of h s in `taken` substeps that gained energy or went out of bounds: that tick, and
  /// those that follow, take more substeps. Returns false when the method has no more to give.
  virtual bool refine(double /*h*/, int /*taken*/, SoftBodyState& /*state*/) const { return false; }
};

/// What a substepper works on; all of it outlives it.
struct SubstepBody {
  const SoftDesc& desc;
  ElasticModel& model;
  const BlockPattern& pattern;
  const VecX& mass;      // n, kg
  const VecX& attached;  // n, N/m
};

/// Makes the explicit substepper by the row of explicit_integrators() that desc.integrator names.
std::unique_ptr<Substepper> make_explicit_substepper(const SubstepBody& body);
/// Makes extended position-based dynamics on the anatomy.
std::unique_ptr<Substepper> make_xpbd_substepper(const SubstepBody& body, const Anatomy& anatomy);
/// Makes the body's substepper; null for bodies that are minimised.
std::unique_ptr<Substepper> make_substepper(const SubstepBody& body, const Anatomy& anatomy);

}  // namespace prosector
