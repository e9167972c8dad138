#pragma once
// The room of the gallery's pictures.

#include "client/view/body_mesh.h"
#include "client/view/camera.h"
#include "client/view/room.h"
#include "tests/client/gallery.h"
#include "tests/client/picture.h"

namespace prosector::test {

inline constexpr int width = 256, height = 192;

inline DrawList stage(const Vec3& eye, const Vec3& target, double fov = 0.6) {
  DrawList list;
  list.cameras = {mono_camera(look_at(eye, target), fov, width, height)};
  LightInfo fill = directional({0.4, -0.5, -0.6});
  fill.intensity = 0.25;
  list.lights = {lamp(target + Vec3(-0.35, 0.9, 0.5), target), fill};
  list.items = room_items(1000);
  return list;
}

inline DrawItem rigid(const PartDesc& part, std::uint64_t id, const Appearance& appearance) {
  DrawItem item;
  item.mesh = rigid_mesh(mesh_of(part), id);
  item.appearance = appearance;
  return item;
}

inline DrawItem table() {
  PartDesc top;
  top.size = {0.9, 0.04, 0.6};
  top.pose.p = {0, 0.98, 0};
  top.rounding = 0.01;
  return rigid(top, 10, {{0.60, 0.62, 0.64}, 0.38, 0, Surface::metal});
}

/// Three bodies in the colours of their estimated error: one that something presses, whose error is mapped;
/// one that tells its mean alone; and one that tells none.
GalleryPicture error();

}  // namespace prosector::test
