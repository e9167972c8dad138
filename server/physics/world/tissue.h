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
  /// Creates a soft body in its rest shape, at rest. The rest shape counts as its equilibrium under gravity
  /// until another is found. `index` is its index among the soft bodies.
  Tissue(std::size_t index, std::unique_ptr<soft::SoftBody> solver, const contact::SoftCollision& collision);
  /// Creates a soft body in its rest shape, at rest, with a contact surface that was already built from the
  /// solver's anatomy. `index` is its index among the soft bodies.
  Tissue(std::size_t index, std::unique_ptr<soft::SoftBody> solver, const contact::SoftCollision& collision,
         contact::TissueSurface surface);

  std::size_t index;  // among the soft bodies
  std::unique_ptr<soft::SoftBody> solver;
  contact::SoftCollision collision;

  // ---- State
  soft::SoftBodyState state;
  contact::ContactMemories memories;
  VecX equilibrium;            // 3n, m: node positions at rest under gravity
  std::uint32_t revision = 0;  // of the topology
  Numbering numbering;

  // ---- Caches
  contact::TissueSurface surface;
  struct StoredEnergy {
    double elastic = 0, weight = 0;  // J
  };
  std::optional<StoredEnergy> stored;  // cached while the body sleeps: constant then

  const SoftDesc& desc() const { return solver->desc(); }
  const Anatomy& anatomy() const { return solver->anatomy(); }
  bool is_thin() const { return anatomy().thickness > 0; }  // a sheet or a rope
  /// Returns the distance (m) from the simulated surface to the contact surface. A sheet is simulated as its
  /// mid-surface, a rope as its axis: contacts stop at this distance from them. For a solid it is 0.
  double half_thickness() const { return anatomy().thickness / 2; }
  /// Returns the stiffness (N/m) of a contact at a surface vertex: the body's Young's modulus times the
  /// vertex' area, divided by the surface cell size, times the scene's factor.
  double contact_stiffness(std::size_t vertex) const;
  /// Returns the side of a contact (nodes and weights) at a vertex of the body's surface.
  contact::ContactSide side(std::uint32_t vertex) const;
  Vec3 middle() const;  // m: centre of mass
  /// Returns an upper bound of how far any node of the body moves within h s, in m.
  double reach(double h) const;
  /// Returns an upper bound of how much two points of the body can approach each other within h s, in m.
  double inner_reach(double h) const;
  /// Returns an axis-aligned box that encloses the body's contact geometry, thickness included.
  collision::Aabb outer_box() const;

  /// Returns the body's surface for contacts with other soft bodies, at its position in this tick.
  contact::SoftSkin skin();
  const contact::ElementSurface& elements() { return surface.elements(state.motion.x); }
  /// Returns, by surface vertex, whether the vertex is embedded in inverted elements (1) or not (0). The
  /// positions of such vertices do not indicate where the body is. Empty if there is no inverted element.
  /// Computed once per tick.
  const std::vector<char>& inside_out();

  bool fits_its_mesh() const;
  void begin_tick();
  /// Moves the body's contact geometry to its current node positions.
  void place_surface() { surface.place(state.motion.x); }
  /// Moves the body's contact geometry to its current node positions within a tick, and invalidates its
  /// caches, since other bodies may have used them at the old position.
  void follow_nodes();

  void wake();
  /// Puts the body to sleep in its current shape and stops its motion.
  void freeze();

 private:
  bool knows_inside_out_ = false;  // in this tick
  std::vector<char> inside_out_;
};

/// Stops a soft body: clears its velocity, the solver's warm start, and the motion history from which the
/// next step is predicted.
void stop(soft::SoftBodyState& state);

}  // namespace prosector
