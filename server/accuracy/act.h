#pragma once
// What is done to a body to find what is wrong with it: it bears its weight, hangs, leans, is pressed by a
// fingertip. Each is a steady load.

#include <optional>
#include <string>
#include <vector>

#include "common/scene/scene.h"
#include "server/accuracy/static_body.h"

namespace prosector {

/// A round patch pressed inwards by p(r) = 3F/(2πa²)·√(1 − r²/a²), Hertz' pressure, at rest positions.
struct Press {
  Vec3 point = Vec3::Zero();    // m, on the surface
  Vec3 inward = Vec3::UnitY();  // unit
  double radius = 0;            // m: a
  double force = 0;             // N: F
};

struct Act {
  std::string name;            // for people
  Vec3 weight = Vec3::Zero();  // m/s²: acceleration on all its mass
  std::optional<Press> press;
  std::optional<Vec3> stands = {};  // unit: which way is down to its foot; nothing: as gravity says
};

/// Returns what is done to the body. Its own weight, the same upwards and sideways, and `presses` of them by
/// a fingertip, half at places far from each other, half where the body is thin. The push is the one that
/// dents half-space by 2 mm, or by a twentieth of the body's thickness. `mesh`: any of its meshes; places are
/// taken from its outer faces.
std::vector<Act> acts_of(const SoftDesc& desc, const TetMesh& mesh, const Vec3& gravity, int presses);

/// Returns a free body's acts of being tilted by 17°, along its longest side and across. Its weight is
/// turned, and its foot with it, so that it stands on what is lowest then. Both are off the sides by 27°:
/// there meshes are their own mirror images, and what rocks a body cancels. Nothing where something ties it
/// or nothing weighs.
std::vector<Act> tilts(const SoftDesc& desc, const TetMesh& mesh, const Vec3& gravity);

/// Returns the act's forces on the body's nodes, 3n, N: weights by the nodes' masses, pressures by the shape
/// functions of the outer faces.
VecX load_of(const Act& act, const StaticBody& body);

}  // namespace prosector
