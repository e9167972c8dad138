#include "tests/client/gallery.h"

#include <cmath>

#include "client/view/avatar.h"
#include "client/view/body_mesh.h"
#include "client/view/camera.h"
#include "client/view/hand_mesh.h"
#include "client/view/room.h"
#include "tests/client/picture.h"

namespace prosector::test {
namespace {

constexpr int width = 256, height = 192;

DrawList stage(const Vec3& eye, const Vec3& target, double fov = 0.6) {
  DrawList list;
  list.cameras = {mono_camera(look_at(eye, target), fov, width, height)};
  LightInfo fill = directional({0.4, -0.5, -0.6});
  fill.intensity = 0.25;
  list.lights = {lamp(target + Vec3(-0.35, 0.9, 0.5), target), fill};
  list.items = room_items(1000);
  return list;
}

DrawItem rigid(const PartDesc& part, std::uint64_t id, const Appearance& appearance) {
  DrawItem item;
  item.mesh = rigid_mesh(mesh_of(part), id);
  item.appearance = appearance;
  return item;
}

DrawItem table() {
  PartDesc top;
  top.size = {0.9, 0.04, 0.6};
  top.pose.p = {0, 0.98, 0};
  top.rounding = 0.01;
  return rigid(top, 10, {{0.60, 0.62, 0.64}, 0.38, 0, Surface::metal});
}

DrawItem hand(std::size_t side, double flexion, const Pose& pose, std::uint64_t id) {
  const HandSkin skin(side);
  auto mesh = skin.make_mesh(id);
  skin.bend(*mesh, {flexion, flexion, flexion, flexion, flexion});
  DrawItem item;
  item.mesh = mesh;
  item.pose = pose;
  item.appearance = {{0.66, 0.42, 0.32}, 0.5, 0.1, Surface::skin};
  return item;
}

GalleryPicture hands(const std::string& name, double flexion) {
  DrawList list = stage({0.05, 1.45, 0.45}, {0, 1.12, 0.0});
  const Quat level = Quat::Identity();
  list.items.push_back(hand(left_hand, flexion, {{-0.11, 1.12, 0.09}, level}, 20));
  // The right one shows its palm.
  list.items.push_back(
      hand(right_hand, flexion, {{0.11, 1.12, 0.09}, Quat(Eigen::AngleAxisd(2.6, Vec3::UnitZ()))}, 21));
  return {name, width, height, list};
}

GalleryPicture organ() {
  DrawList list = stage({0.1, 1.4, 0.6}, {0, 1.03, 0}, 0.5);
  list.items.push_back(table());
  PartDesc ball;
  ball.shape = "ellipsoid";
  ball.size = {0.20, 0.11, 0.14};
  ball.pose.p = {-0.04, 1.055, 0};
  list.items.push_back(rigid(ball, 11, {{0.42, 0.10, 0.08}, 0.45, 0.9, Surface::tissue}));
  PartDesc bone;
  bone.shape = "capsule";
  bone.size = {0.03, 0.16, 0};
  bone.pose = {{0.14, 1.016, 0.05}, Quat(Eigen::AngleAxisd(1.571, Vec3(1, 0, 0.4).normalized()))};
  list.items.push_back(rigid(bone, 12, {{0.80, 0.74, 0.60}, 0.55, 0.2, Surface::bone}));
  return {"organ", width, height, list};
}

GalleryPicture avatar() {
  DrawList list = stage({0.3, 1.6, 1.6}, {0, 1.4, 0});
  const Pose head{{0.1, 1.5, -0.2}, look_at({0.1, 1.5, -0.2}, {-0.3, 1.3, 1}).q};
  add_avatar(list, head_mesh(30), head, {0.9, 0.5, 0.1}, "Ada Lovelace");
  add_corner_axes(list, Quat::Identity(), list.cameras[0]);
  list.texts.push_back({"real time 1.00  step 4.2 ms", {8, 8, 0}, true, 14, {1, 1, 1}});
  return {"avatar", width, height, list};
}

GalleryPicture text() {
  DrawList list;
  list.cameras = {straight_camera({0, 0, 1}, width, height)};
  std::string all;
  for (char c = ' '; c <= '~'; ++c) {
    all += c;
    if ((c - ' ') % 24 == 23) all += '\n';
  }
  list.texts = {
      {all, {8, 8, 0}, true, 16, {1, 1, 1}},
      {"The quick brown fox jumps\nover the lazy dog: 0123456789", {8, 110, 0}, true, 12, {1, 1, 0.6}},
      {"(gap 1.25 mm) & [N·s] {x;y}", {8, 160, 0}, true, 20, {0.5, 1, 0.6}}};
  return {"text", width, height, list};
}

}  // namespace

const std::vector<std::string>& gallery_names() {
  static const std::vector<std::string> names = {"hand_open", "hand_half", "hand_fist",
                                                 "organ",     "avatar",    "text"};
  return names;
}

GalleryPicture gallery_picture(const std::string& name) {
  if (name == "hand_open") return hands(name, 0);
  if (name == "hand_half") return hands(name, 0.5);
  if (name == "hand_fist") return hands(name, 1);
  if (name == "organ") return organ();
  if (name == "avatar") return avatar();
  return text();
}

}  // namespace prosector::test
