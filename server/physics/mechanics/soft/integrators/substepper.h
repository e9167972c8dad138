#pragma once
// Substeppers: explicit and position-based bodies advance through a tick in separate substeps, instead of in
// the island's minimisation.

#include <memory>

#include "common/scene/scene.h"
#include "server/physics/mechanics/soft/elements/elastic_model.h"
#include "server/physics/mechanics/soft/integrators/soft_state.h"
#include "server/physics/mechanics/soft/matrices/block_matrix.h"

namespace prosector {

class Substepper {
 public:
  virtual ~Substepper() = default;
  /// Initialises the method's part of the state for a body at rest.
  virtual void initialise(SoftBodyState& state) = 0;
  /// Returns the number of equal substeps that a tick of h s needs; infinity if no number is sufficient.
  virtual double needed(double h, const SoftBodyState& state) const = 0;
  /// Returns the maximum number of substeps that the scene allows.
  virtual int allowed() const = 0;
  /// Returns whether the method has a stability limit. If so, a tick that needs more substeps than allowed is
  /// refused with the needed number. If not, too few substeps only reduce accuracy.
  virtual bool has_limit() const { return true; }
  /// Returns the allowed ratio of the body's energy after a tick of h s to its energy before plus the work of
  /// gravity. Methods whose energy oscillates near their limit get a large margin, others almost none.
  virtual double most_gain(double h) const = 0;
  /// Returns the allowed energy gain by impulses, relative to their work. It is almost zero for methods that
  /// are stable only with damping. A push excites modes that damping does not reach, so such bodies are
  /// stepped by implicit Euler while they are pushed.
  virtual double most_pushed(double h) const { return most_gain(h) - 1; }
  /// Returns a message for users about parts of the description that the method ignores; empty: none.
  virtual const char* remark() const { return ""; }
  /// Updates data stored per tetrahedron, if any, after an edit of `mesh`.
  virtual void follow(const TetMesh& /*mesh*/, const MeshEdit& /*edit*/) {}
  /// Updates the substepper after it and the body followed a cut. Bitwise equal to a rebuild.
  virtual void fit() = 0;
  /// Begins a tick.
  virtual void begin(const SoftBodyState& state) = 0;
  /// Advances the body by hs s without contacts.
  virtual void step(double hs, const Weight& weight, SoftBodyState& state) = 0;
  /// Ends a tick with substeps of hs s (0: the body was stepped by another method) and computes the needs of
  /// the next tick. Returns false if hs was too long, because the body became stiffer during the tick.
  virtual bool finish(double hs, SoftBodyState& state) = 0;
  /// Increases the number of substeps after a tick of h s in `taken` substeps that gained energy or diverged,
  /// for that tick and the following ones. Returns false if the method cannot use more substeps.
  virtual bool refine(double /*h*/, int /*taken*/, SoftBodyState& /*state*/) const { return false; }
};

/// The data a substepper works on; they must outlive it.
struct SubstepBody {
  const SoftDesc& desc;
  ElasticModel& model;
  const BlockPattern& pattern;
  const VecX& mass;      // n, kg
  const VecX& attached;  // n, N/m
};

/// Creates the explicit substepper for the row of explicit_integrators() that desc.integrator names.
std::unique_ptr<Substepper> make_explicit_substepper(const SubstepBody& body);
/// Creates extended position-based dynamics for the anatomy.
std::unique_ptr<Substepper> make_xpbd_substepper(const SubstepBody& body, const Anatomy& anatomy);
/// Creates the body's substepper; null for bodies that are minimised.
std::unique_ptr<Substepper> make_substepper(const SubstepBody& body, const Anatomy& anatomy);

}  // namespace prosector
