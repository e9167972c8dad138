#include "client/view/scene_tour.h"

#include <algorithm>
#include <cmath>

#include "client/view/avatar.h"
#include "client/view/camera.h"
#include "client/view/hand_mesh.h"
#include "client/view/hand_nails.h"
#include "client/view/light_shaft.h"
#include "client/view/section.h"
#include "common/ids.h"
#include "common/rotation_between.h"

namespace prosector {
namespace {

constexpr double orbit_elevation = 0.5;  // rad above the subject
constexpr double steep = 1.25;           // rad: above lamps that hang over the scene
constexpr double margin = 1.15;          // ratio of the view's height to the diameter of the subject's sphere
constexpr double dimmed = 0.25;          // brightness of the room in views with a light shaft
constexpr std::uint64_t first_own_mesh = 1U << 20;
const Appearance skin_look{
    .color = {0.50, 0.30, 0.22}, .roughness = 0.5, .wetness = 0.1, .surface = Surface::skin};
const Vec3 sleeve_color{0.12, 0.34, 0.36};

Eigen::AlignedBox3d box_of(const DrawItem& item) {
  Eigen::AlignedBox3d box;
  for (const auto& x : item.mesh->positions) box.extend(item.shape * (item.pose * x.cast<double>().eval()));
  return box;
}

/// Returns a body's item. The items of still_scene() end with the rigid bodies, then the soft ones.
const DrawItem& body_item(const SceneDesc& scene, const DrawList& list, std::size_t body) {
  return list.items[list.items.size() - scene.rigid.size() - scene.soft.size() + body];
}

/// Returns the bounding box of all glass items; empty: none.
Eigen::AlignedBox3d box_of_glass(const DrawList& list) {
  Eigen::AlignedBox3d box;
  for (const DrawItem& item : list.items)
    if (item.appearance.surface == Surface::glass) box.extend(box_of(item));
  return box;
}

const DrawItem* first_soft(const SceneDesc& scene, const DrawList& list) {
  return scene.soft.empty() ? nullptr : &body_item(scene, list, scene.rigid.size());
}

DrawCamera camera_around(const Subject& subject, double yaw, double elevation, double fov, int width,
                         int height) {
  const double narrow = std::min(1.0, static_cast<double>(width) / height);
  const double distance = margin * subject.radius / std::sin(std::atan(std::tan(fov / 2) * narrow));
  const Vec3 back(std::sin(yaw) * std::cos(elevation), std::sin(elevation),
                  std::cos(yaw) * std::cos(elevation));
  return mono_camera(look_at(subject.middle + distance * back, subject.middle), fov, width, height);
}

/// Returns a point below the skin where the skin is nearest to the body's centre. The centre itself may be
/// outside a bent body.
Vec3 inside_of(const DrawItem& body) {
  constexpr double depth = 0.03;  // m: more than the distance of a camera's near plane
  const DrawMesh& mesh = *body.mesh;
  const Eigen::Vector3f middle = (body.pose.inverse() * box_of(body).center()).cast<float>();
  std::size_t nearest = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    if ((mesh.positions[v] - middle).squaredNorm() < (mesh.positions[nearest] - middle).squaredNorm())
      nearest = v;
  return body.pose * (mesh.positions[nearest].cast<double>() - depth * mesh.normals[nearest].cast<double>());
}

void add_hands(DrawList& list, const Vec3& between, const Vec3& towards_eye) {
  const std::array<HandSkin, 2> skins = make_hand_skins();
  const FigureMeshes figure(make_figure_surfaces(), first_own_mesh + 5);
  const Vec3 ahead = -Vec3(towards_eye.x(), 0, towards_eye.z()).normalized();
  const Quat facing = rotation_between(-Vec3::UnitZ(), ahead);
  for (const std::size_t hand : {left_hand, right_hand}) {
    auto mesh = make_hand_mesh(skins[hand], first_own_mesh + hand);
    const double bend = hand == left_hand ? 0.15 : 0.8;
    const std::array<double, fingers> bent{bend, bend, bend, bend, bend};
    bend_hand(skins[hand], *mesh, bent);
    const Vec3 aside = (hand == left_hand ? -0.12 : 0.12) * (facing * Vec3::UnitX());
    const Vec3 at = between - 0.09 * ahead + aside + Vec3(0, 0.03, 0);
    auto nails = make_nails(hand, first_own_mesh + 3 + hand);
    bend_nails(hand, bent, *nails);
    const Pose wrist{at, facing};
    list.items.push_back({.mesh = mesh, .pose = wrist, .appearance = skin_look});
    list.items.push_back({.mesh = nails, .pose = wrist, .appearance = nail_look(skin_look)});
    add_forearm(list, figure, wrist, sleeve_color);
  }
}

/// Lights the part from the first spot light, or from above if there is none.
void light_up(DrawList& list, const DrawItem& part) {
  const Eigen::AlignedBox3d box = box_of(part);
  Vec3 lamp = box.center() + Vec3(0, 1.5, 0), color = Vec3::Ones();
  const auto spot = std::find_if(list.lights.begin(), list.lights.end(),
                                 [](const LightInfo& light) { return light.kind == LightKind::spot; });
  if (spot != list.lights.end()) {
    lamp = spot->position;
    color = spot->color;
  }
  for (LightInfo& light : list.lights) light.intensity *= dimmed;
  list.ambient *= dimmed;
  add_light_shaft(list, shaft_mesh(first_own_mesh + 2), lamp, color, box.center(), box.sizes().norm() / 2);
}

/// Returns the bounding box of all items that a section opens; empty: none.
Eigen::AlignedBox3d box_of_openable(const DrawList& list) {
  Eigen::AlignedBox3d box;
  for (const DrawItem& item : list.items)
    if (item.solid != 0) box.extend(box_of(item));
  return box;
}

/// Opens the tissue at a vertical plane through its centre that faces the scene's camera. Returns false if
/// there is no tissue.
bool open_at_middle(const SceneDesc& scene, DrawList& list) {
  const Eigen::AlignedBox3d box = box_of_openable(list);
  if (box.isEmpty()) return false;
  const Vec3 back = scene.camera.eye - scene.camera.target;
  list.section = section_facing(Vec3(back.x(), 0, back.z()).normalized(), box.center());
  std::uint64_t next_mesh_id = first_own_mesh + 5 + FigureMeshes::meshes;
  SectionCaps().add(list, next_mesh_id);
  return true;
}

}  // namespace

Subject subject_of(const SceneDesc& scene, const DrawList& list) {
  Eigen::AlignedBox3d moving, all;
  for (std::size_t body = 0; body < scene.rigid.size() + scene.soft.size(); ++body) {
    const Eigen::AlignedBox3d box = box_of(body_item(scene, list, body));
    all.extend(box);
    if (body >= scene.rigid.size() || !scene.rigid[body].fixed) moving.extend(box);
  }
  const Eigen::AlignedBox3d& box = moving.isEmpty() ? all : moving;
  if (box.isEmpty()) return {.middle = scene.camera.target, .radius = 0.5};
  return {.middle = box.center(), .radius = std::max(box.sizes().norm() / 2, 0.05)};
}

DrawCamera orbit_camera(const SceneDesc& scene, const Subject& subject, double turn, int width, int height) {
  const Vec3 back = scene.camera.eye - scene.camera.target;
  return camera_around(subject, std::atan2(back.x(), back.z()) + turn, orbit_elevation, scene.camera.fov,
                       width, height);
}

std::vector<TourStop> tour_of(const SceneDesc& scene, const DrawList& list, int width, int height) {
  const Subject subject = subject_of(scene, list);
  const DrawItem* soft = first_soft(scene, list);
  std::vector<TourStop> out;
  const auto stop = [&](const char* name, const char* about, const DrawCamera& camera) -> DrawList& {
    out.push_back({name, about, list});
    out.back().list.cameras = {camera};
    return out.back().list;
  };
  const Pose scene_eye = look_at(scene.camera.eye, scene.camera.target);
  stop("scene", "from the scene's own camera", mono_camera(scene_eye, scene.camera.fov, width, height));
  stop("left", "from the left, 90°", orbit_camera(scene, subject, -M_PI / 2, width, height));
  stop("right", "from the right, 90°", orbit_camera(scene, subject, M_PI / 2, width, height));
  stop("above", "from above", camera_around(subject, 0, steep, scene.camera.fov, width, height));
  Subject close = subject;
  if (soft != nullptr) {
    const Eigen::AlignedBox3d box = box_of(*soft);
    close = {box.center(), 0.42 * box.sizes().norm()};
  } else {
    close.radius *= 0.4;
  }
  stop("close", "close-up", orbit_camera(scene, close, 0, width, height));
  if (soft != nullptr) {
    stop("inside", "from inside the first soft body",
         mono_camera({inside_of(*soft), scene_eye.q}, scene.camera.fov, width, height));
    light_up(
        stop("shaft", "with light on the first soft body", orbit_camera(scene, subject, 0, width, height)),
        *soft);
  }
  if (const Eigen::AlignedBox3d glass = box_of_glass(list); !glass.isEmpty())
    stop("glass", "at the glass bodies",
         orbit_camera(scene, {glass.center(), 0.42 * glass.sizes().norm()}, 0, width, height));
  if (DrawList opened = list; open_at_middle(scene, opened)) {
    const Eigen::AlignedBox3d box = box_of_openable(list);
    out.push_back({"section", "section through the centre", std::move(opened)});
    out.back().list.cameras = {
        orbit_camera(scene, {box.center(), 0.5 * box.sizes().norm()}, 0, width, height)};
  }
  const Subject reach{close.middle + Vec3(0, 0.1, 0), 0.24};
  add_hands(stop("hands", "with two hands", orbit_camera(scene, reach, 0, width, height)), reach.middle,
            scene.camera.eye - scene.camera.target);
  return out;
}

}  // namespace prosector
