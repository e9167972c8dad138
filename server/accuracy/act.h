#pragma once
// Test loads ("acts") for measuring the error of a body's model: it bears its weight, hangs, leans, is
// pressed by a fingertip. Each is a steady load.

#include <optional>
#include <string>
#include <vector>

#include "common/scene/scene.h"
#include "server/accuracy/static_body.h"

namespace prosector {

/// A press on a body's surface: a round patch of radius a, pressed inwards with the force F. The pressure at
/// distance r from the patch's centre, measured on the rest shape, is Hertz's: p(r) = 3F/(2πa²)·√(1 − r²/a²).
struct Press {
  Vec3 point = Vec3::Zero();    // m, on the surface
  Vec3 inward = Vec3::UnitY();  // unit
  double radius = 0;            // m: a
  double force = 0;             // N: F
};

struct Act {
  std::string name;            // shown to users
  Vec3 weight = Vec3::Zero();  // m/s²: acceleration on all its mass
  std::optional<Press> press;
  std::optional<Vec3> stands = {};  // unit: direction down to its foot; nothing: that of gravity
};

/// Returns the acts (steady test loads) of a body: its weight, the same weight upwards and sideways, and
/// `presses` presses by a fingertip. Half of the presses are at places far from each other, half where the
/// body is thin. Each press would dent a half-space by 2 mm, or by a twentieth of the body's thickness if
/// that is less. `mesh` is any mesh of the body at rest; the pressed places are chosen on its outer faces.
std::vector<Act> acts_of(const SoftDesc& desc, const TetMesh& mesh, const Vec3& gravity, int presses);

/// Returns the acts (steady test loads) that tilt a free body by 17°: once along its longest side and once
/// across. The weight is rotated together with the foot, the bed of springs on which the body stands. Both
/// directions are 27° off the body's sides: along a side, a mesh may be its own mirror image, and errors that
/// rock the body would cancel. Empty if an attachment holds the body or it has no weight.
std::vector<Act> tilts(const SoftDesc& desc, const TetMesh& mesh, const Vec3& gravity);

/// Returns the forces (3n, N) of an act (a steady test load) on the body's n nodes. Weights and pressures are
/// integrated with the shape functions of the elements and of the outer faces.
VecX load_of(const Act& act, const StaticBody& body);

}  // namespace prosector
