#pragma once
// Camera positions for a static scene: named views, and an orbit around it.

#include <string>
#include <vector>

#include "client/view/draw_list.h"
#include "common/scene/scene.h"

namespace prosector {

struct TourStop {
  std::string name;
  std::string about;  // description for the reader
  DrawList list;      // with its camera
};

/// Bounding sphere, m, of the bodies that can move or deform; without any, of everything but the room. `list`
/// is from still_scene().
struct Subject {
  Vec3 middle = Vec3::Zero();
  double radius = 1;
};
Subject subject_of(const SceneDesc& scene, const DrawList& list);

/// Makes views from the scene's camera, from three sides, close up, and inside the first soft body. Further
/// views show two hands, a light shaft on that body, and glass items, if any.
std::vector<TourStop> tour_of(const SceneDesc& scene, const DrawList& list, int width, int height);

/// Returns a camera rotated by `turn` radians around the subject from the scene's camera.
DrawCamera orbit_camera(const SceneDesc& scene, const Subject& subject, double turn, int width, int height);

}  // namespace prosector
