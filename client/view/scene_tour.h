#pragma once
// Where to stand to see a still scene: named views, and a way around it.

#include <string>
#include <vector>

#include "client/view/draw_list.h"
#include "common/scene/scene.h"

namespace prosector {

struct TourStop {
  std::string name;
  std::string about;  // for people
  DrawList list;      // with its camera
};

/// The ball around what can move or give way, else around everything but the room, m. `list` is
/// still_scene()'s.
struct Subject {
  Vec3 middle = Vec3::Zero();
  double radius = 1;
};
Subject subject_of(const SceneDesc& scene, const DrawList& list);

/// Makes stops at the scene's own camera, on three sides, close by, and inside the first soft body. More
/// stops are with two hands, with a shaft of light on that body, and at what is of glass, where there is any.
std::vector<TourStop> tour_of(const SceneDesc& scene, const DrawList& list, int width, int height);

/// Returns a camera `turn` radians around the subject from where the scene's camera stands.
DrawCamera orbit_camera(const SceneDesc& scene, const Subject& subject, double turn, int width, int height);

}  // namespace prosector
