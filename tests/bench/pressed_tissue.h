#pragma once
// A ball of 10 mm radius pressed into tissue (E = 5 kPa, ν = 0.45), held, and drawn along under it, by the
// server's own simulation: a bonded layer of 20 mm, 2 mm deep, an organ on a bed, 10 mm
// deep, and the CT's liver (E = 5.4 kPa) so.

#include "server/physics/simulation.h"

namespace prosector {

struct PressedBody {
  const char *name, *called;
  double depth;    // m
  double longest;  // m, of its sides
  /// Says which body it is, and what holds it.
  void (*shape)(SoftDesc& desc);
  /// Makes the mesh of a body so described; the surface's triangles may be finer than the cells. Null: by the
  /// sources of scenes.
  Anatomy (*mesh)(const SoftDesc& desc);
  /// As mesh, with the cell asked for only where it is pressed and wider ones beyond.
  Anatomy (*graded_mesh)(const SoftDesc& desc);
  double force;      // N: the continuum's
  double unsettled;  // fraction, of it
  /// Finer triangles show another shape, so all models have the same surface. It is pressed where it is
  /// highest, others in the middle.
  bool by_image = false;
};
const PressedBody& pressed_layer_body();
const PressedBody& pressed_organ();
/// Without the CT, the shape that stands in for it.
const PressedBody& pressed_liver();

/// Describes such a body of tissue's law (stable neo-Hookean), of cells of that size, m, where `refine_cell`
/// isn't 0 smaller ones where it is touched.
SoftDesc pressed_desc(const PressedBody& body, double cell, double refine_cell = 0);

struct PressSettings {
  double tick = 1. / 60;          // s
  double contact_stiffness = 20;  // as a scene has it
  int threads = 1;
  bool graded = false;  // the mesh
};

class PressedTissue {
 public:
  PressedTissue(const PressedBody& body, const SoftDesc& desc, const PressSettings& settings = {});
  /// Moves the ball so deep, m, and so far along x, m, within a tick.
  const StepReport& press(double depth, double along = 0);
  double force() const;      // N, upwards, in the last tick
  std::size_t tets() const;  // now
  const Simulation& simulation() const { return simulation_; }

 private:
  Simulation simulation_;
  Vec3 top_;  // m, of the surface where it is pressed
};

/// Returns the force at the body's depth, at rest, of quadratic elements and a hard ball, N. Inertia,
/// damping and what a solver leaves play no part. `desc`: material and cell. Throws InputError where the law
/// in force is not the body's own any more.
double force_at_rest(const PressedBody& body, SoftDesc desc);

}  // namespace prosector
