#pragma once
// One soft body of a running simulation: its solver, its state, and its contact geometry.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "server/physics/base/topology.h"
#include "server/physics/mechanics/collision/primitives/aabb.h"
#include "server/physics/mechanics/contact/contact_memory.h"
#include "server/physics/mechanics/contact/soft_collision.h"
#include "server/physics/mechanics/contact/tissue_surface.h"
#include "server/physics/mechanics/soft/soft_body.h"

namespace prosector {

struct Tissue {
  /// Creates a body at rest in its rest shape, which counts as its equilibrium until another is found.
  Tissue(std::size_t index, std::unique_ptr<SoftBody> solver, const SoftCollision& collision);
  /// Creates the body with a surface that was built from the solver's anatomy.
  Tissue(std::size_t index, std::unique_ptr<SoftBody> solver, const SoftCollision& collision,
         TissueSurface surface);

  std::size_t index;  // among the soft bodies
  std::unique_ptr<SoftBody> solver;
  SoftCollision collision;

  // ---- State
  SoftBodyState state;
  ContactMemories memories;
  VecX equilibrium;            // 3n, m: node positions at rest under gravity
  std::uint32_t revision = 0;  // of the topology
  Numbering numbering;

  // ---- Caches
  TissueSurface surface;
  struct StoredEnergy {
    double elastic = 0, weight = 0;  // J
  };
  std::optional<StoredEnergy> stored;  // cached while the body sleeps: constant then

  const SoftDesc& desc() const { return solver->desc(); }
  const Anatomy& anatomy() const { return solver->anatomy(); }
  bool is_thin() const { return anatomy().thickness > 0; }  // a sheet or a rope
  /// Returns the distance from the simulated surface to the contact surface, m. A sheet is simulated as its
  /// mid-surface, a rope as its axis: contacts stop at this distance from them.
  double half_thickness() const { return anatomy().thickness / 2; }
  /// Returns the stiffness of a contact at a surface vertex, N/m: the Young's modulus times the vertex' area
  /// over the surface cell size, times the scene's factor.
  double contact_stiffness(std::size_t vertex) const;
  /// Returns the side of a contact at a surface vertex.
  ContactSide side(std::uint32_t vertex) const;
  Vec3 middle() const;  // m: centre of mass
  /// Returns an upper bound of how far its nodes move within h s, m.
  double reach(double h) const;
  /// Returns an upper bound of how much two points of the body can approach each other within h s, m.
  double inner_reach(double h) const;
  /// Returns a bounding box of the body's contact geometry.
  Aabb outer_box() const;

  /// Returns the surface for contact with other soft bodies, at its position in this tick.
  SoftSkin skin();
  const ElementSurface& elements() { return surface.elements(state.motion.x); }
  /// Returns marks of surface vertices that are embedded in inverted elements, computed once a tick: their
  /// positions do not indicate where the body is. 1: marked; empty: none.
  const std::vector<char>& inside_out();

  bool fits_its_mesh() const;
  void begin_tick();
  /// Moves the contact geometry to the current node positions.
  void place_surface() { surface.place(state.motion.x); }
  /// Moves the contact geometry within a tick and invalidates its caches, since other bodies may have used
  /// them at the old position.
  void follow_nodes();

  void wake();
  /// Puts the body to sleep in its current shape.
  void freeze();

 private:
  bool knows_inside_out_ = false;  // in this tick
  std::vector<char> inside_out_;
};

/// Clears a body's velocity, and its warm start and motion history, from which the next step is predicted.
void stop(SoftBodyState& state);

}  // namespace prosector
