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

/// Returns the ray in the room from the camera through a pixel. `x` and `y` are in pixels from the top left
/// of the camera's viewport.
Ray ray_through(const DrawCamera& camera, double x, double y);

/// Returns the distance, in lengths of the ray's direction, at which the ray meets the front side of the
/// triangle (counter-clockwise a, b, c); nullopt if it does not.
std::optional<double> meet(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c);

/// Point at which a ray meets a surface, with the surface's normal.
struct SurfacePoint {
  double distance = 0;          // m along the ray
  Vec3 at = Vec3::Zero();       // m, world frame
  Vec3 normal = Vec3::UnitY();  // unit, outwards
};

/// Point at which a ray meets a body's surface, with the body's id.
struct Picked : SurfacePoint {
  BodyId body = 0;
  bool inner = false;  // on a cut surface
};

struct PanelPoint {
  double distance = 0;                  // m along the ray
  Vec3 at = Vec3::Zero();               // in the panel's frame, on the board
  std::optional<PanelControl> control;  // the control there; a slider counts over its whole travel
};

/// Returns the point at which the ray meets a panel's front, and the control there; nullopt if it misses the
/// panel.
std::optional<PanelPoint> meet(const Ray& ray, const Panel& panel);

/// Returns the value, 0 … 1, that the panel's slider has if its knob is moved to a position on the board
/// (panel's frame, m).
double slider_position(const Vec3& at);

}  // namespace prosector
