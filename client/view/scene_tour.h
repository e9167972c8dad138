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

/// Bounding sphere, m, of the bodies of a scene that can move or deform, on which views are centred. If there
/// are none, that of everything but the room.
struct Subject {
  Vec3 middle = Vec3::Zero();
  double radius = 1;
};
Subject subject_of(const SceneDesc& scene, const DrawList& list);

/// Returns views of a scene with descriptions: from the scene's camera, from three sides, close up, and
/// inside the first soft body. Further views show two hands, a light shaft on that body, and glass items, if
/// any. `list` is the result of still_scene(); `width` and `height` are in pixels.
std::vector<TourStop> tour_of(const SceneDesc& scene, const DrawList& list, int width, int height);

/// Returns a camera that is moved from the scene's camera by an angle of `turn` radians around the subject,
/// and looks at it. `width` and `height` of its frame are in pixels.
DrawCamera orbit_camera(const SceneDesc& scene, const Subject& subject, double turn, int width, int height);

}  // namespace prosector
