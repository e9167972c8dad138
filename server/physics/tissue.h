#pragma once
// One soft body of a running simulation: its solver, its state, and what others meet of it.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "server/physics/collision/primitives/aabb.h"
#include "server/physics/contact/memory.h"
#include "server/physics/contact/soft_collision.h"
#include "server/physics/contact/tissue_surface.h"
#include "server/physics/soft/soft_body.h"
#include "server/physics/topology.h"

namespace prosector {

struct Tissue {
  /// Makes a body at rest in its rest shape, which is its equilibrium until another is found.
  Tissue(std::size_t index, std::unique_ptr<SoftBody> solver, const SoftCollision& collision);
  /// Makes it with a surface that was made of the solver's anatomy.
  Tissue(std::size_t index, std::unique_ptr<SoftBody> solver, const SoftCollision& collision,
         TissueSurface surface);

  std::size_t index;  // among the soft bodies
  std::unique_ptr<SoftBody> solver;
  SoftCollision collision;

  // ---- State
  SoftBodyState state;
  ContactMemories memories;
  VecX equilibrium;            // 3n, m: node positions at rest under gravity
  std::uint32_t revision = 0;  // of its topology
  Numbering numbering;

  // ---- Caches
  TissueSurface surface;
  struct StoredEnergy {
    double elastic = 0, weight = 0;  // J
  };
  std::optional<StoredEnergy> stored;  // of one that sleeps it stays what it was

  const SoftDesc& desc() const { return solver->desc(); }
  const Anatomy& anatomy() const { return solver->anatomy(); }
  bool is_thin() const { return anatomy().thickness > 0; }  // a sheet or a rope
  /// Returns the distance from the simulated surface to the one that is touched, m. A sheet's surface is the
  /// one through its middle, a rope's is its axis: what touches them stops short of it.
  double half_thickness() const { return anatomy().thickness / 2; }
  /// Returns the stiffness of a contact at a surface vertex, N/m: the body's own over one surface cell, times
  /// the scene's factor.
  double contact_stiffness(std::size_t vertex) const;
  /// Returns the side of a contact at a surface vertex.
  ContactSide side(std::uint32_t vertex) const;
  Vec3 middle() const;  // m: its centre of mass
  /// Returns how far its nodes move within h s, m.
  double reach(double h) const;
  /// Returns how far parts of the body may near each other within h s, m.
  double inner_reach(double h) const;
  /// Returns a box around what others touch of it.
  Aabb outer_box() const;

  /// Returns its surface as other soft bodies meet it, where it is in this tick.
  SoftSkin skin();
  const ElementSurface& elements() { return surface.elements(state.motion.x); }
  /// Marks surface vertices that hang on tissue that is inside out, once a tick: they tell nothing of where
  /// the body is. 1: so; empty: none are.
  const std::vector<char>& inside_out();

  bool fits_its_mesh() const;
  void begin_tick();
  /// Takes what others touch of the body to where its nodes are.
  void place_surface() { surface.place(state.motion.x); }
  /// Takes it there within a tick in which others may have met it elsewhere.
  void follow_nodes();

  void wake();
  /// Puts the body to sleep where it is.
  void freeze();

 private:
  bool knows_inside_out_ = false;  // in this tick
  std::vector<char> inside_out_;
};

/// Takes all motion from a body, and what its next step would guess from earlier ones.
void stop(SoftBodyState& state);

}  // namespace prosector
