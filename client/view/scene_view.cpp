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
#include "client/view/shown_effort.h"
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
  if (settings.shown != Shown::none) paint_bodies(replica, settings.shown);
  if (through != nullptr) replace_table(replica, *through);
  close_section();
  if (settings.wireframes) add_wireframes(replica, tick);
  add_panels(replica, self.participant, settings.panel);
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
  strokes_.look(replica, tick * replica.tick_seconds());
  level_of_detail_.choose(list_, settings.detail);
  if (settings.shown != Shown::none) add_legend(list_, scale_);
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

/// Replaces the scene's table, which is the fixed body below the board, by the real table in the camera
/// image. All bodies are lit like it, and phantoms occlude.
void SceneView::replace_table(const Replica& replica, const CameraOverlay& through) {
  constexpr double below = 0.005;  // m, below the board
  const Pose& board = through.room_board;
  const Vec3 up = board.q * Vec3::UnitZ();
  const Vec3 shown = rendered_paper_color(list_, board.p, up);
  for (const auto& [body, index, inner] : bodies_.items()) {
    const SceneBody& one = replica.scene()->bodies[body];
    DrawItem& item = list_.items[index];
    if (through.found && one.name == through.found->body) {
      item.showing = ItemRole::real;
      item.pose = through.found->place.value_or(item.pose);
      continue;
    }
    if (std::ranges::find(through.phantoms, one.name) != through.phantoms.end()) {
      item.showing = ItemRole::real;
      continue;
    }
    if (through.paper) match_lighting(item, shown, *through.paper);
    if (one.kind != BodyKind::rigid || one.moves || one.part ||
        !bodies_.box_of(list_, body).contains(board.p - below * up))
      continue;
    item.showing = ItemRole::around;
    item.casts_shadow = false;
  }
  DrawItem plane = table_plane(board, next_mesh_id_);
  if (!table_) {
    table_ = plane.mesh;
    ++next_mesh_id_;
  }
  plane.mesh = table_;
  list_.items.push_back(plane);
  if (!through.found || !through.found->shape || !through.found->place) return;
  if (!phantom_) phantom_ = rigid_mesh(*through.found->shape, next_mesh_id_++);
  list_.items.push_back(
      {.mesh = phantom_, .pose = *through.found->place, .appearance = {}, .showing = ItemRole::real});
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
      const RigidReplica* rigid = replica.rigid(id);
      if (!mesh) mesh = rigid_mesh(rigid->mesh, next_mesh_id_++);
      item.mesh = mesh;
      item.pose = replica.rigid_pose(id, tick);
      if (is_held_blade(replica, id)) item.brightness = blade_brightness;
    } else {
      SoftReplica* soft = replica.soft(id);
      if (soft == nullptr || !soft->complete()) continue;  // a new piece that is not fully received
      const SoftBodyMesh& mesh =
          follow_soft(*soft, id, bodies[id].tube_diameter, tick, replica.tick_seconds());
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

/// Colours all soft bodies with one scale.
void SceneView::paint_bodies(const Replica& replica, Shown shown) {
  const auto& bodies = replica.scene()->bodies;
  std::vector<const DrawnBodies::Item*> soft;
  for (const DrawnBodies::Item& one : bodies_.items())
    if (bodies[one.body].kind == BodyKind::soft) soft.push_back(&one);
  scale_ = scale_of(shown);
  if (shown == Shown::strain) {
    std::vector<double> strains;
    for (const DrawnBodies::Item* one : soft) {
      const DrawMesh& mesh = *list_.items[one->index].mesh;
      const std::vector<double>& of_mesh = painted_of(mesh).strains(mesh);
      strains.insert(strains.end(), of_mesh.begin(), of_mesh.end());
    }
    scale_.most = strain_range_.follow(std::move(strains));
  }
  for (const DrawnBodies::Item* one : soft)
    paint(list_.items[one->index], shown, replica.body_status(one->body));
}

void SceneView::paint(DrawItem& item, Shown shown, const BodyStatus* status) {
  std::optional<double> value;  // of the whole body
  if (shown == Shown::residual) value = status != nullptr ? status->residual : not_known;
  const bool known = status != nullptr && status->error >= 0;
  if (shown == Shown::error) value = known ? status->error : not_known;
  const ErrorMap* map = shown == Shown::error && known ? &status->error_map : nullptr;
  item.mesh = painted_of(*item.mesh).of(*item.mesh, scale_, value, map);
  item.painted = true;
}

PaintedMesh& SceneView::painted_of(const DrawMesh& mesh) {
  const auto [painted, is_new] = painted_.try_emplace(mesh.id, next_mesh_id_);
  if (is_new) ++next_mesh_id_;
  return painted->second;
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

void SceneView::add_wireframes(Replica& replica, double tick) {
  const auto& bodies = replica.scene()->bodies;
  for (BodyId id = 0; id < bodies.size(); ++id) {
    const PartState* part = replica.part(id);
    if (part != nullptr && (part->hidden || part->inspected)) continue;  // not in contact
    if (bodies[id].kind == BodyKind::soft) {
      const SoftReplica* known = replica.soft(id);
      if (known == nullptr || !known->complete()) continue;
      const SoftReplica& soft = *known;
      const auto [wires, is_new] = wires_.try_emplace(id);
      if (is_new || wire_shapes_[id] != soft.shape()) wires->second = all_edges(soft.rest().triangles);
      wire_shapes_[id] = soft.shape();
      add_wireframe(list_, wires->second,
                    [&](std::uint32_t v) -> Vec3 { return soft.surface()[v].cast<double>(); });
    } else if (const TriangleMesh* outline = replica.outline(id)) {
      const auto [wires, is_new] = wires_.try_emplace(id);
      if (is_new) wires->second = visible_edges(*outline);
      const Pose pose = replica.rigid_pose(id, tick);
      add_wireframe(list_, wires->second,
                    [&](std::uint32_t v) -> Vec3 { return pose * outline->positions[v]; });
    }
  }
}

void SceneView::add_panels(const Replica& replica, ParticipantId self, const PanelLook& look) {
  hidden_panel_lines_ = 0;
  for (const auto& [who, panel] : replica.panels()) {
    if (panel.body >= replica.scene()->bodies.size()) continue;
    if (!panel_view_) {
      panel_view_.emplace(next_mesh_id_);
      next_mesh_id_ += PanelView::meshes;
    }
    const SceneBody& part = replica.scene()->bodies[panel.body];
    Panel seen = panel;
    if (who == self) {
      hidden_panel_lines_ = panel_view_->hidden_lines(part);
      seen.pose = look.place.value_or(panel.pose);
    }
    panel_view_->add(list_, seen, part, shown_effort(replica, panel.body, self),
                     who == self ? look.first_line : 0);
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
