#include "client/view/avatar.h"

#include <array>

#include "client/view/body_mesh.h"
#include "client/view/overlay_frame.h"

namespace prosector {
namespace {

const std::array<Vec3, 3> axis_colors = {{{0.9, 0.05, 0.04}, {0.05, 0.75, 0.08}, {0.08, 0.2, 1.0}}};

}  // namespace

std::shared_ptr<const DrawMesh> head_mesh(std::uint64_t mesh_id) {
  constexpr double half_width = 0.08, half_height = 0.10, ahead = 0.13, behind = 0.07;  // m
  TriangleMesh pyramid;
  pyramid.positions = {{-half_width, -half_height, behind},
                       {half_width, -half_height, behind},
                       {half_width, half_height, behind},
                       {-half_width, half_height, behind},
                       {0, 0, -ahead}};
  pyramid.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 0, 4}, {2, 1, 4}, {3, 2, 4}, {0, 3, 4}};
  return rigid_mesh(pyramid, mesh_id);
}

void add_avatar(DrawList& list, const std::shared_ptr<const DrawMesh>& head, const Pose& pose,
                const Vec3& color, const std::string& name) {
  DrawItem item;
  item.mesh = head;
  item.pose = pose;
  item.appearance = {color, 0.45, 0};
  list.items.push_back(item);
  add_axes(list, pose, 0.22);
  DrawText label;
  label.text = name;
  label.at = pose.p + Vec3(0, 0.18, 0);
  label.overlay = false;
  list.texts.push_back(label);
}

void add_axes(DrawList& list, const Pose& frame, double length) {
  for (int axis = 0; axis < 3; ++axis)
    list.lines.push_back({frame.p, frame * Vec3(length * Vec3::Unit(axis)),
                          axis_colors[static_cast<std::size_t>(axis)], 2.5, false});
}

void add_corner_axes(DrawList& list, const Quat& frame, const DrawCamera& camera) {
  constexpr double length = 42, margin = 56, letter = 13;  // points
  const Quat camera_from_frame = camera.pose.q.conjugate() * frame;
  const OverlayFrame picture(camera, list.scale);
  const auto to_ndc = [&](const Vec3& from_below) {
    return picture.at(from_below.x(), picture.height - from_below.y());
  };
  const Vec3 origin(margin, margin, 0);
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 along = camera_from_frame * Vec3::Unit(axis);
    along.z() = 0;
    const Vec3 tip = origin + length * along;
    const Vec3& color = axis_colors[static_cast<std::size_t>(axis)];
    list.lines.push_back({to_ndc(origin), to_ndc(tip), color, 3, true});
    DrawText label;
    label.text = std::string(1, static_cast<char>('x' + axis));
    const Vec3 beyond = tip + 9 * along.normalized();
    label.at = {beyond.x(), picture.height - beyond.y(), 0};
    label.height = letter;
    label.centred = true;
    label.ground = TextGround::none;
    label.color = color.cwiseMax(0.3);
    list.texts.push_back(label);
  }
}

}  // namespace prosector
