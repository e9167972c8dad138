#include "client/view/scene_view.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "client/view/body_mesh.h"
#include "client/view/body_statistics.h"
#include "client/view/camera.h"
#include "client/view/carried_light.h"
#include "client/view/headset_text.h"
#include "client/view/held_blades.h"
#include "client/view/held_bodies.h"
#include "client/view/help_board.h"
#include "client/view/light_shaft.h"
#include "client/view/normals.h"
#include "client/view/overlay_frame.h"
#include "client/view/room.h"
#include "client/view/session_overlay.h"
#include "common/hand.h"

namespace prosector {
namespace {

constexpr double blade_brightness = 1.5;  // of blades, so that their sides are visible
constexpr double lit_brightness = 1.6, least_room_light = 0.05, highlighted_brightness = 1.7;
constexpr double notes_left = 10, notes_top = 90;  // points: below the overlay's lines
constexpr int inset_share = 4;                     // ratio of the view's width and height to an inset's
constexpr double eye_fov = 0.95;                   // rad, vertical, of eyes with an unknown field of view

/// Returns the vertical field of view (rad) of a user's eyes. A user without devices is at a desk, which
/// shows the scene with its own camera.
double fov_of(const RosterEntry& user, const CameraInfo& camera) {
  return user.devices.empty() ? camera.fov : eye_fov;
}

/// Returns the camera for a frame of this size (pixels).
DrawCamera resized(DrawCamera camera, int width, int height) {
  camera.width = width;
  camera.height = height;
  return camera;
}

/// Adds lines below those of the session; empty: none.
void add_notes(DrawList& list, const std::string& notes) {
  if (notes.empty()) return;
  list.texts.push_back({.text = notes,
                        .at = {notes_left, notes_top, 0},
                        .height = 13,
                        .wrap = OverlayFrame(list).width - 2 * notes_left});
}

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};

}  // namespace

const DrawList& SceneView::build(Replica& replica, double tick, const LocalUser& self,
                                 const ViewSettings& settings) {
  list_.items.clear();
  list_.lines.clear();
  list_.plates.clear();
  list_.texts.clear();
  bodies_.clear();
  list_.scale = settings.scale;
  list_.strip = 0;
  list_.words = settings.words;
  place_lights(replica, tick);
  place_cameras(replica, tick, self, settings);
  const Overlays fitting = overlays_of(settings.projection);
  const CameraOverlay* through = settings.through();
  if (fitting.insets) add_insets(replica, tick, settings);
  add_room(fitting.virtual_room ? ItemRole::itself : ItemRole::around);
  list_.section = settings.section;
  if (through != nullptr && !through->is_placed) {
    if (settings.overlay) add_session_overlay(list_, replica, self, settings);
    add_centred_text(list_, through->words);
    return list_;
  }
  add_bodies(replica, tick, settings);
  std::optional<ValueScale> scale;
  if (settings.shown != Shown::none)
    scale = value_painter_.paint(list_, bodies_, replica, settings.shown, next_mesh_id_);
  if (through != nullptr) real_objects_.add(list_, bodies_, replica, *through, next_mesh_id_);
  close_section();
  if (settings.wireframes) wireframes_.add(list_, replica, tick);
  panels_.add(list_, replica, self.participant, settings.panel, next_mesh_id_);
  if (settings.parts_board) {
    if (!parts_board_) {
      parts_board_.emplace(next_mesh_id_);
      next_mesh_id_ += PartsBoardView::meshes;
    }
    parts_board_->add(list_, *settings.parts_board);
  }
  people_.add(list_, replica, tick, self, settings, next_mesh_id_);
  if (self.present) own_hand_.update_opacity(list_, bodies_, people_, replica, self, tick);
  if (self.at_desk) own_hand_.add_cues(list_, bodies_, people_, replica, self, tick, next_mesh_id_);
  cut_lines_.add(list_);
  add_blades(list_, bodies_, replica, self, tick);
  add_guide(list_, settings.cut_guide);
  strokes_.look(replica, tick * replica.time().tick_seconds());
  level_of_detail_.choose(list_, settings.detail);
  if (scale) add_legend(list_, *scale);
  if (settings.help.empty()) add_notes(list_, settings.notes);
  if (settings.overlay) add_body_figures(replica);
  const bool overlay =
      settings.overlay && settings.help.empty() && fitting.over_frame;  // the help would cover the overlay
  if (overlay) add_session_overlay(list_, replica, self, settings);
  if (overlay && self.present) add_stroke_figures(replica, self, tick, settings);
  if (!fitting.over_frame) add_headset_text(list_, fmt::format("{}", fmt::join(settings.messages, "\n")));
  if (settings.parts.labels() && settings.help.empty()) add_part_labels(replica, settings);
  if (settings.parts_list != nullptr) add_parts_list(list_, *settings.parts_list);
  if (!settings.help.empty()) add_help(list_, settings.help);
  if (through != nullptr) add_centred_text(list_, through->words);
  return list_;
}

void SceneView::place_cameras(const Replica& replica, double tick, const LocalUser& self,
                              const ViewSettings& settings) {
  const CameraInfo& camera = replica.scene()->camera;
  Pose eye = look_at(camera.eye, camera.target);
  bool own = true;
  double fov = camera.fov;
  if (settings.eye) eye = *settings.eye;
  if (!settings.eye && self.present && self.input.head_tracked) {
    eye = self.input.head;
    fov = eye_fov;
  }
  if (const RosterEntry* followed = find_by_name(replica, settings.follow)) {
    const auto user = replica.user(followed->participant, tick);
    if (user && user->head_tracked) {
      eye = user->head;
      fov = fov_of(*followed, camera);
      own = false;
    }
  }
  list_.cameras.clear();
  list_.backdrop.reset();
  const auto mono = [&] { list_.cameras = {mono_camera(eye, fov, settings.width, settings.height)}; };
  std::visit(
      Overloaded{
          [&](const Mono&) { mono(); },
          [&](const StereoProfile& profile) {
            for (const DrawCamera& c : stereo_cameras(eye, profile, settings.width, settings.height))
              list_.cameras.push_back(c);
          },
          [&](const HeadsetEyes& eyes) { list_.cameras.assign(eyes.cameras.begin(), eyes.cameras.end()); },
          [&](const WindowCamera& window) {
            if (!own) return mono();
            list_.cameras = {resized(window.camera, settings.width, settings.height)};
          },
          [&](const CameraOverlay& through) {
            list_.backdrop = through.backdrop;
            if (list_.backdrop)
              list_.backdrop->step *= static_cast<double>(through.camera.width) / settings.width;
            list_.cameras = {resized(through.camera, settings.width, settings.height)};
          },
      },
      settings.projection);
}

/// Adds insets below each other at the upper right, each with its user's name.
void SceneView::add_insets(const Replica& replica, double tick, const ViewSettings& settings) {
  constexpr int gap = 6;  // pixels
  const int width = settings.width / inset_share, height = settings.height / inset_share;
  int below = settings.height;  // pixels from the bottom
  for (const std::string& name : settings.insets) {
    below -= height + gap;
    if (below < 0) return;
    const RosterEntry* entry = find_by_name(replica, name);
    const auto user = entry != nullptr ? replica.user(entry->participant, tick) : std::nullopt;
    const bool seen = user && user->head_tracked;
    const int left = settings.width - width - gap, top = settings.height - below - height;
    list_.texts.push_back({.text = seen ? name : settings.words.tr("{} is not in the session", name),
                           .at = Vec3(left + gap, top + gap, 0) / settings.scale,
                           .height = 11});
    if (!seen) continue;
    DrawCamera camera = mono_camera(user->head, fov_of(*entry, replica.scene()->camera), width, height);
    camera.x = left;
    camera.y = below;
    camera.inset = true;
    list_.cameras.push_back(camera);
  }
}

void SceneView::add_room(ItemRole showing) {
  if (room_.empty()) {
    room_ = room_items(next_mesh_id_);
    next_mesh_id_ += room_.size();
  }
  for (const DrawItem& item : room_) {
    list_.items.push_back(item);
    list_.items.back().showing = showing;
  }
}

void SceneView::add_bodies(Replica& replica, double tick, const ViewSettings& settings) {
  const auto& bodies = replica.scene()->bodies;
  const std::vector<PartLook> looks = looks_of(replica, settings.parts);
  cut_lines_.begin();
  for (BodyId id = 0; id < bodies.size(); ++id) {
    if (looks[id].hidden) continue;
    DrawItem item{.mesh = nullptr, .pose = {}, .appearance = bodies[id].appearance};
    if (is_openable(item.appearance)) item.solid = id + 1;
    if (bodies[id].part) bodies_.add_part(id);
    if (looks[id].color) item.appearance.color = *looks[id].color;
    std::shared_ptr<const DrawMesh> inner;
    const SoftReplica* cut = nullptr;
    if (bodies[id].kind == BodyKind::rigid) {
      auto& mesh = meshes_[id];
      const RigidReplica* rigid = replica.bodies().rigid(id);
      if (!mesh) mesh = rigid_mesh(rigid->mesh, next_mesh_id_++);
      item.mesh = mesh;
      item.pose = replica.rigid_pose(id, tick);
      if (is_held_blade(replica, id)) item.brightness = blade_brightness;
    } else {
      SoftReplica* soft = replica.bodies().soft(id);
      if (soft == nullptr || !soft->complete()) continue;  // a new piece that is not fully received
      const SoftBodyMesh& mesh =
          follow_soft(*soft, id, bodies[id].tube_diameter, tick, replica.time().tick_seconds());
      item.mesh = mesh.outer();
      inner = mesh.inner();
      if (bodies[id].tube_diameter == 0) cut = soft;
    }
    const PartState* part = replica.part(id);
    if (part != nullptr) {
      if (part->hidden) continue;
      if (part->inspected) item.shape = part->shape;
      item.seen_from_inside = part->inspected;
      item.opacity = part->opacity;
      // As bright as in a fully lit room, and more.
      if (part->lit) item.brightness = lit_brightness / std::max(replica.room_lights(), least_room_light);
      if (part->lit) add_light_shaft(item);
    }
    item.opacity *= looks[id].opacity;
    item.casts_shadow = item.opacity >= 1;
    if (std::ranges::find(settings.highlighted, id) != settings.highlighted.end())
      item.brightness *= highlighted_brightness;
    if (cut != nullptr) cut_lines_.put(id, *cut, *item.mesh, item.shape);
    const auto add = [&](DrawItem seen) {
      bodies_.add(id, list_.items.size(), seen.mesh == inner);
      list_.items.push_back(std::move(seen));
    };
    add(item);
    if (!inner) continue;
    item.mesh = inner;
    item.appearance = inner_appearance(item.appearance);
    add(item);
  }
}

/// Closes what the viewer's section opens. The caps can be picked.
void SceneView::close_section() {
  for (const auto& [solid, item] : section_caps_.add(list_, next_mesh_id_))
    bodies_.add(solid - 1, item, true);
}

SoftBodyMesh& SceneView::follow_soft(SoftReplica& soft, BodyId body, double tube_diameter, double tick,
                                     double dt) {
  const bool moved = soft.sample(tick, dt);
  const auto [mesh, is_new] = soft_meshes_.try_emplace(body, soft, tube_diameter, next_mesh_id_);
  if (is_new) next_mesh_id_ += SoftBodyMesh::meshes;
  mesh->second.follow(soft, moved || is_new);
  return mesh->second;
}

/// Adds the statistics of the local user's stroke, next to the pointer or next to the tip of the held blade.
void SceneView::add_stroke_figures(const Replica& replica, const LocalUser& self, double tick,
                                   const ViewSettings& settings) {
  constexpr double right = 16, below = 14, height = 13;  // points from the pointer
  const StrokeFigures* stroke = strokes_.of(self.participant);
  std::string text = stroke != nullptr ? in_words(*stroke, settings.words) : std::string();
  if (self.at_desk) {
    if (settings.cut_depth) {
      if (!text.empty()) text += '\n';
      text += depth_in_words(*settings.cut_depth, settings.words);
    }
    const Eigen::Vector2d at = settings.pointer / list_.scale + Eigen::Vector2d(right, below);
    if (!text.empty())
      list_.texts.push_back({.text = std::move(text), .at = {at.x(), at.y(), 0}, .height = height});
    return;
  }
  if (text.empty()) return;
  for (const std::size_t hand : {left_hand, right_hand}) {
    const HandRef ref{self.participant, static_cast<std::uint8_t>(hand)};
    const auto blade = held_blade(replica, ref, tick);
    const auto user = replica.user(self.participant, tick);
    if (!blade || !user) continue;
    list_.texts.push_back(
        {.text = text, .at = user->hands[hand].pose * blade->tip, .overlay = false, .height = height});
    return;
  }
}

/// Adds a light shaft from the surgical lamp, the first spot light; without one, from above.
void SceneView::add_light_shaft(const DrawItem& item) {
  Eigen::AlignedBox3d box;
  for (const auto& x : item.mesh->positions) box.extend(item.shape * (item.pose * x.cast<double>().eval()));
  if (box.isEmpty()) return;
  if (!shaft_) shaft_ = shaft_mesh(next_mesh_id_++);
  Vec3 lamp = box.center() + Vec3(0, 1.5, 0), color = Vec3::Ones();
  for (const LightInfo& light : list_.lights)
    if (light.kind == LightKind::spot) {
      lamp = light.position;
      color = light.color;
      break;
    }
  prosector::add_light_shaft(list_, shaft_, lamp, color, box.center(), box.sizes().norm() / 2);
}

/// Moves the lights that bodies carry; scales the others by the room's brightness.
void SceneView::place_lights(const Replica& replica, double tick) {
  list_.lights = replica.scene()->lights;
  const double room = replica.room_lights();
  list_.ambient = room * DrawList().ambient;
  for (LightInfo& light : list_.lights) {
    if (light.body < 0) {
      light.intensity *= room;
      continue;
    }
    const Pose carrier = replica.rigid_pose(static_cast<BodyId>(light.body), tick);
    light = light_in_room(carrier, light);
  }
}

/// Adds labels of the parts that can be grasped, clear of the other overlays.
void SceneView::add_part_labels(const Replica& replica, const ViewSettings& settings) {
  constexpr double border = 10, below_lines = 74, note_line = 17;  // points
  const OverlayFrame frame(list_);
  double right = frame.width - border, top = settings.overlay ? below_lines : border;
  if (settings.parts_list != nullptr) right = settings.parts_list->board.min().x() - border;
  if (!settings.insets.empty()) right = std::min(right, frame.width * (1 - 1.0 / inset_share) - border);
  if (!settings.notes.empty())
    top = notes_top + note_line * static_cast<double>(1 + std::ranges::count(settings.notes, '\n'));
  std::vector<NamedItem> named;
  for (const auto& [body, item, inner] : bodies_.items())
    if (const SceneBody& one = replica.scene()->bodies[body];
        one.part || one.moves || one.kind == BodyKind::soft)
      named.push_back({body, item, one.name});
  part_labels_.add(list_, named,
                   {Eigen::Vector2d(border, top), Eigen::Vector2d(right, frame.height - message_band)});
}

/// Adds statistics above each drawn body for which the scene requests them. They are above it as seen by the
/// first eye, so that they hide nothing of the body.
void SceneView::add_body_figures(const Replica& replica) {
  constexpr double clearance = 0.015;  // m
  const Pose eye = list_.cameras.front().pose, into_eye = eye.inverse();
  const auto& bodies = replica.scene()->bodies;
  for (BodyId id = 0; id < bodies.size(); ++id) {
    const BodyStatus* status = bodies[id].show_figures ? replica.body_status(id) : nullptr;
    const auto mesh = soft_meshes_.find(id);
    if (status == nullptr || mesh == soft_meshes_.end() || bodies_.box_of(list_, id).isEmpty()) continue;
    Eigen::AlignedBox3f box;
    for (const auto& x : mesh->second.outer()->positions) box.extend(x);
    if (box.isEmpty()) continue;
    const Vec3 middle = into_eye * Vec3(box.center().cast<double>());
    if (!(middle.z() < 0)) continue;          // behind the eye
    double slope = middle.y() / -middle.z();  // of the sight line to the body's highest point in the view
    for (const auto& vertex : mesh->second.outer()->positions)
      if (const Vec3 x = into_eye * Vec3(vertex.cast<double>()); x.z() < 0)
        slope = std::max(slope, x.y() / -x.z());
    const Vec3 above(middle.x(), slope * -middle.z() + clearance, middle.z());
    list_.texts.push_back({.text = body_figures(bodies[id], *status, list_.words),
                           .at = eye * above,
                           .overlay = false,
                           .height = 11});
  }
}

}  // namespace prosector
