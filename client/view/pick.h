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

/// Returns the distance (m) along the ray to the item's front, if the ray meets it.
std::optional<double> meet(const Ray& ray, const DrawItem& item);

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
