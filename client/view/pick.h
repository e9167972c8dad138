#pragma once
// What a ray meets: the desk's pointer as a finger.

#include <optional>

#include "client/view/draw_list.h"
#include "common/panel.h"

namespace prosector {

struct Ray {
  Vec3 from = Vec3::Zero();
  Vec3 along = -Vec3::UnitZ();  // unit
};

/// Returns the ray through a pixel of the camera's picture, counted from its top left.
Ray ray_through(const DrawCamera& camera, double x, double y);

/// Returns the distance along the ray, in lengths of its direction, to the outside of the triangle.
std::optional<double> meet(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c);

/// Where a ray meets a surface.
struct SurfacePoint {
  double distance = 0;          // m along the ray
  Vec3 at = Vec3::Zero();       // m, world frame
  Vec3 normal = Vec3::UnitY();  // unit, outwards
};

/// A surface point and whose it is.
struct Picked : SurfacePoint {
  BodyId body = 0;
  bool inner = false;  // a cut laid it bare
};

struct PanelPoint {
  double distance = 0;                  // m along the ray
  Vec3 at = Vec3::Zero();               // in the panel's frame, on the board
  std::optional<PanelControl> control;  // that lies there; of the slider its whole way
};

/// Returns where the ray meets a panel's front.
std::optional<PanelPoint> meet(const Ray& ray, const Panel& panel);

/// Returns the slider's position for a place on the board.
double slider_position(const Vec3& at);

}  // namespace prosector
