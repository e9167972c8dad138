#pragma once
// Ray casting: the desk's pointer acts as a finger.

#include <optional>

#include "client/view/draw_list.h"
#include "common/ids.h"
#include "common/panel.h"
#include "common/part_messages.h"

namespace prosector {

struct Ray {
  Vec3 from = Vec3::Zero();
  Vec3 along = -Vec3::UnitZ();  // unit
};

/// Returns the ray through a pixel of the camera's viewport, from its top left.
Ray ray_through(const DrawCamera& camera, double x, double y);

/// Returns the distance along the ray, in lengths of its direction, to the front side of the triangle;
/// nullopt: no intersection.
std::optional<double> meet(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c);

/// Intersection of a ray with a surface.
struct SurfacePoint {
  double distance = 0;          // m along the ray
  Vec3 at = Vec3::Zero();       // m, world frame
  Vec3 normal = Vec3::UnitY();  // unit, outwards
};

/// A surface point with its body.
struct Picked : SurfacePoint {
  BodyId body = 0;
  bool inner = false;  // on a cut surface
};

struct PanelPoint {
  double distance = 0;                  // m along the ray
  Vec3 at = Vec3::Zero();               // in the panel's frame, on the board
  std::optional<PanelControl> control;  // the control there; a slider counts over its whole travel
};

/// Returns the intersection of the ray with a panel's front.
std::optional<PanelPoint> meet(const Ray& ray, const Panel& panel);

/// Returns the slider's value for a position on the board.
double slider_position(const Vec3& at);

}  // namespace prosector
