#pragma once
// Substeppers: explicit and position-based bodies advance through a tick in separate substeps, instead of in
// the island's minimisation.

#include <memory>

#include "common/scene/scene.h"
#include "server/physics/mechanics/soft/elements/elastic_model.h"
#include "server/physics/mechanics/soft/integrators/soft_state.h"
#include "server/physics/mechanics/soft/matrices/block_matrix.h"

namespace prosector::soft {

class Substepper {
 public:
  virtual ~Substepper() = default;
  /// Initialises those parts of `state` that only this integration method uses, for a body at rest in its
  /// rest shape.
  virtual void initialise(SoftBodyState& state) = 0;
  /// Returns the number of equal substeps into which a tick of h s must be divided for the body in this
  /// state. Infinity if no number is sufficient.
  virtual double needed(double h, const SoftBodyState& state) const = 0;
  /// Returns the maximum number of substeps per tick that the scene allows for the body.
  virtual int allowed() const = 0;
  /// Returns whether the method is unstable with too few substeps. If so, the body is not substepped in a
  /// tick that needs more substeps than allowed, and the needed number is reported. If not, too few substeps
  /// only reduce accuracy.
  virtual bool has_limit() const { return true; }
  /// Returns the largest acceptable ratio of the body's energy after a tick of h s to its energy before plus
  /// the work of gravity. Methods whose energy oscillates near their stability limit get a large margin,
  /// others almost none.
  virtual double most_gain(double h) const = 0;
  /// Returns the acceptable energy gain by contact impulses in a tick of h s, relative to their work. It is
  /// almost zero for methods that are stable only with damping. A push excites modes that damping does not
  /// reach, so such bodies are stepped by implicit Euler while they are pushed.
  virtual double most_pushed(double h) const { return most_gain(h) - 1; }
  /// Returns a text for users about parts of the scene's description that the method does not follow, for
  /// example a limited Poisson's ratio. Empty if there are none.
  virtual const char* remark() const { return ""; }
  /// Updates data that the method stores for each tetrahedron after `edit` changed the body's mesh to `mesh`.
  /// Does nothing for methods without such data.
  virtual void follow(const TetMesh& /*mesh*/, const MeshEdit& /*edit*/) {}
  /// Recomputes the data derived from the body's masses and connectivity after a cut changed them. The result
  /// is bitwise equal to that of a newly built substepper.
  virtual void fit() = 0;
  /// Begins a tick from the body's `state`: computes data that are constant over the substeps, such as the
  /// damping matrix.
  virtual void begin(const SoftBodyState& state) = 0;
  /// Advances the body's positions and velocities by one substep of hs s under its internal forces and
  /// `weight`, without contacts.
  virtual void step(double hs, const Weight& weight, SoftBodyState& state) = 0;
  /// Ends a tick and updates the number of substeps that the next tick needs. `hs`: length of the tick's
  /// substeps, s; 0 if another method stepped the body. Returns false if the tick must be repeated: the
  /// result is not finite, or hs was too long because the body became stiffer.
  virtual bool finish(double hs, SoftBodyState& state) = 0;
  /// Increases the number of substeps for this tick, which will be repeated, and the following ones. Called
  /// after a tick of h s in `taken` substeps in which the body gained energy or diverged. Returns false if
  /// the method cannot use more substeps.
  virtual bool refine(double /*h*/, int /*taken*/, SoftBodyState& /*state*/) const { return false; }
};

/// References to the data of the body that a substepper advances: description, elastic model, matrix pattern,
/// masses and attachments. They must outlive the substepper.
struct SubstepBody {
  const SoftDesc& desc;
  ElasticModel& model;
  const BlockPattern& pattern;
  const VecX& mass;      // n, kg
  const VecX& attached;  // n, N/m
};

/// Creates a substepper that uses the explicit integrator named by `desc.configuration.integrator` in the
/// body's description.
std::unique_ptr<Substepper> make_explicit_substepper(const SubstepBody& body);
/// Creates a substepper that uses extended position-based dynamics (XPBD). `anatomy`: the body's mesh.
std::unique_ptr<Substepper> make_xpbd_substepper(const SubstepBody& body, const Anatomy& anatomy);
/// Creates the substepper that the body's description asks for, explicit or position-based. Returns null if
/// the body uses an implicit integrator and is stepped by minimisation.
std::unique_ptr<Substepper> make_substepper(const SubstepBody& body, const Anatomy& anatomy);

}  // namespace prosector::soft
