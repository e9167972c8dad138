#pragma once
// A ball of 10 mm radius is pressed into tissue (E = 5 kPa, ν = 0.45), held, and moved sideways, in the
// server's simulation. Bodies: a bonded layer of 20 mm, pressed 2 mm deep; an organ on a bed and the CT liver
// (E = 5.4 kPa), pressed 10 mm deep.

#include "server/physics/simulation.h"

namespace prosector {

struct PressedBody {
  const char *name, *called;
  double depth;    // m
  double longest;  // m, longest side
  /// Sets the body's geometry and attachments in `desc`.
  void (*shape)(SoftDesc& desc);
  /// Builds the body's mesh; surface triangles may be finer than the cells. Null: the mesh is built as for
  /// scenes.
  Anatomy (*mesh)(const SoftDesc& desc);
  /// Builds a graded mesh: the cell size of `desc` where the ball presses, larger cells beyond.
  Anatomy (*graded_mesh)(const SoftDesc& desc);
  double force;      // N: reference force in the continuum limit
  double unsettled;  // uncertainty of `force`, as a fraction
  /// Whether the shape is from a CT image. All models then have the same surface, because finer triangles
  /// change the shape. Such a body is pressed at its highest point, others at the centre.
  bool by_image = false;
};
const PressedBody& pressed_layer_body();
const PressedBody& pressed_organ();
/// The CT liver, or the built-in liver shape if the CT data are missing.
const PressedBody& pressed_liver();

/// Returns the scene description of the body with the tissue law (stable neo-Hookean). `cell`: cell size, m.
/// `refine_cell`: cell size near contacts, m; 0: no local refinement.
SoftDesc pressed_desc(const PressedBody& body, double cell, double refine_cell = 0);

struct PressSettings {
  double tick = 1. / 60;          // s
  double contact_stiffness = 20;  // a scene's default
  int threads = 1;
  bool graded = false;  // whether to use the graded mesh
};

class PressedTissue {
 public:
  PressedTissue(const PressedBody& body, const SoftDesc& desc, const PressSettings& settings = {});
  /// Moves the ball to `depth` m below the surface and `along` m in x, in one tick.
  const StepReport& press(double depth, double along = 0);
  double force() const;      // N, vertical force on the ball in the last tick
  std::size_t tets() const;  // current number of tetrahedra
  const Simulation& simulation() const { return simulation_; }

 private:
  Simulation simulation_;
  Vec3 top_;  // m, surface point where the ball presses
};

/// Returns the converged static force at the body's depth with quadratic elements and a hard ball, N, without
/// inertia and damping. `desc`: material and cell size. Throws InputError if the recovery law replaced the
/// body's law.
double force_at_rest(const PressedBody& body, SoftDesc desc);

}  // namespace prosector
