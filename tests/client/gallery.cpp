#include "tests/client/gallery.h"

#include <cmath>

#include "client/app/desk/parts_board.h"
#include "client/view/avatar.h"
#include "client/view/body_mesh.h"
#include "client/view/camera.h"
#include "client/view/contact_overlay.h"
#include "client/view/corner_axes.h"
#include "client/view/hand_mesh.h"
#include "client/view/light_shaft.h"
#include "client/view/normals.h"
#include "client/view/panel_view.h"
#include "client/view/part_labels.h"
#include "client/view/parts_list.h"
#include "client/view/room.h"
#include "client/view/stereo_profile.h"
#include "client/view/value_paint.h"
#include "client/view/wireframe.h"
#include "common/error_map.h"
#include "common/index_tip.h"
#include "tests/client/gallery_stage.h"
#include "tests/client/many_scripts.h"
#include "tests/client/picture.h"

namespace prosector::test {
namespace {

DrawItem hand(std::size_t side, const HandPose& pose, std::uint64_t id) {
  const HandSkin skin(side);
  auto mesh = make_hand_mesh(skin, id);
  bend_hand(skin, *mesh, pose.flexion);
  DrawItem item;
  item.mesh = mesh;
  item.pose = pose.pose;
  item.appearance = {{0.66, 0.42, 0.32}, 0.5, 0.1, Surface::skin};
  return item;
}

GalleryPicture hands(const std::string& name, double flexion) {
  DrawList list = stage({0.05, 1.45, 0.45}, {0, 1.12, 0.0});
  HandPose pose{.pose = {{-0.11, 1.12, 0.09}, Quat::Identity()}};
  pose.flexion.fill(flexion);
  list.items.push_back(hand(left_hand, pose, 20));
  pose.pose = {{0.11, 1.12, 0.09}, Quat(Eigen::AngleAxisd(2.6, Vec3::UnitZ()))};  // shows its palm
  list.items.push_back(hand(right_hand, pose, 21));
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
  add_avatar(list, FigureMeshes(make_figure_surfaces(), 30), head, {0.9, 0.5, 0.1}, "Ada Lovelace");
  add_corner_axes(list, std::nullopt, list.cameras[0]);
  list.texts.push_back({"real time 1.00  step 4.2 ms", {8, 8, 0}, true, 14, {1, 1, 1}});
  return {"avatar", width, height, list};
}

/// A part of the anatomy on the table.
DrawItem organ_part() {
  PartDesc ball;
  ball.shape = "ellipsoid";
  ball.size = {0.20, 0.11, 0.14};
  ball.pose.p = {0, 1.055, 0};
  return rigid(ball, 11, {{0.42, 0.10, 0.08}, 0.45, 0.9, Surface::tissue});
}

/// As the headset user sees it who presses one button, while another one is on and the slider was moved.
GalleryPicture panel() {
  constexpr int wide = 640, high = 480;
  DrawList list = stage({0.02, 1.45, 0.5}, {-0.1, 1.12, 0}, 0.85);
  list.cameras = {mono_camera(list.cameras[0].pose, 0.85, wide, high)};
  list.items.push_back(table());
  list.items.push_back(organ_part());
  SceneBody part;
  part.name = "liver";
  part.description =
      "The largest gland: it stores glycogen, makes bile, and cleans the blood of what the gut took in.";
  Panel shown;
  shown.open = true;
  shown.pose = {{-0.26, 1.19, 0.02}, look_at({0.02, 1.45, 0.5}, {-0.26, 1.19, 0.02}).q};
  shown.controls[static_cast<std::size_t>(PanelControl::attach)].on = true;
  shown.controls[static_cast<std::size_t>(PanelControl::transparency)] = {0.9, false, true};
  shown.controls[static_cast<std::size_t>(PanelControl::stiffness)].position = 0.75;
  PanelView(40).add(list, shown, part);
  ContactSample contact;
  contact.point = {0.01, 1.108, 0.02};
  contact.depth = 0.0021;
  contact.impulse = 0.0145;
  contact.force = {0.1, -0.86, 0.02};
  add_contact_overlay(list, contact, part.name);
  add_corner_axes(list, PatientFrame{}, list.cameras[0]);
  return {"panel", wide, high, list};
}

/// What is seen through, what light falls on in a dimmed room, and what collides as a box.
GalleryPicture parts() {
  DrawList list = stage({0.1, 1.45, 0.75}, {0, 1.05, 0}, 0.6);
  for (LightInfo& light : list.lights) light.intensity *= 0.25;
  list.ambient *= 0.25;
  list.items.push_back(table());
  DrawItem clear = organ_part();
  clear.opacity = 0.35;
  clear.casts_shadow = false;
  PartDesc bone;
  bone.shape = "capsule";
  bone.size = {0.03, 0.22, 0};
  bone.pose = {{-0.02, 1.05, -0.01}, Quat(Eigen::AngleAxisd(1.571, Vec3(1, 0, 1.2).normalized()))};
  list.items.push_back(rigid(bone, 12, {{0.80, 0.74, 0.60}, 0.55, 0.2, Surface::bone}));
  list.items.push_back(clear);
  PartDesc box;
  box.size = {0.08, 0.06, 0.08};
  box.pose.p = {0.2, 1.03, 0.02};
  DrawItem lit = rigid(box, 13, {{0.3, 0.5, 0.7}, 0.5, 0, Surface::plain});
  lit.brightness = 6.4;
  list.items.push_back(lit);
  add_light_shaft(list, shaft_mesh(14), list.lights[0].position, Vec3::Ones(), box.pose.p, 0.065);
  const TriangleMesh outline = mesh_of(box);
  add_wireframe(list, visible_edges(outline), [&](std::uint32_t v) { return outline.positions[v]; });
  return {"parts", width, height, list};
}

/// A ball and a plate of glass before a bone and a mosaic of colours.
GalleryPicture glass() {
  DrawList list = stage({0.12, 1.25, 0.5}, {0, 1.03, 0}, 0.5);
  list.items.push_back(table());
  for (int k = 0; k < 5; ++k) {
    PartDesc post;
    post.size = {0.03, 0.12, 0.03};
    post.pose.p = {0.07 * (k - 2), 1.06, -0.1};
    list.items.push_back(rigid(post, 60 + static_cast<std::uint64_t>(k),
                               {{0.7 - 0.15 * k, 0.25, 0.1 + 0.15 * k}, 0.6, 0, Surface::plain}));
  }
  PartDesc ball;
  ball.shape = "sphere";
  ball.size = Vec3::Constant(0.09);
  ball.pose.p = {-0.07, 1.046, 0.06};
  list.items.push_back(rigid(ball, 70, {.roughness = 0.05, .surface = Surface::glass}));
  PartDesc plate;
  plate.size = {0.12, 0.1, 0.012};
  plate.pose = {{0.08, 1.052, 0.05}, Quat(Eigen::AngleAxisd(0.5, Vec3::UnitY()))};
  plate.rounding = 0.002;
  list.items.push_back(rigid(plate, 71,
                             {.roughness = 0.05,
                              .surface = Surface::glass,
                              .refractive_index = 1.62,
                              .abbe_number = 20,
                              .transmittance = {0.75, 0.95, 0.85}}));
  return {"glass", width, height, list};
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
      {all, {10, 6, 0}, true, 13, {1, 1, 1}},
      {"The quick brown fox jumps\nover the lazy dog: 0123456789", {10, 82, 0}, true, 12, {1, 1, 0.6}},
      {"(gap 1.25 mm) [N·s]", {10, 120, 0}, true, 20, {0.5, 1, 0.6}},
      {"key\twhat it does\nShift\trolls", {10, 152, 0}, true, 12, {1, 1, 1}}};
  list.texts[3].ground = TextGround::framed;
  list.texts.push_back({.text = "no ground", .at = {180, 160, 0}, .height = 12});
  list.texts.back().ground = TextGround::none;
  return {"text", width, height, list};
}

/// The same on a display with as many pixels a point.
GalleryPicture on_finer_display(GalleryPicture picture, int scale) {
  picture.list.scale = scale;
  picture.width *= scale;
  picture.height *= scale;
  for (DrawCamera& camera : picture.list.cameras)
    for (int* pixels : {&camera.x, &camera.y, &camera.width, &camera.height}) *pixels *= scale;
  picture.name.append("_").append(std::to_string(scale)).append("x");
  return picture;
}

/// Labels in the overlay and in the room, over a bright thing.
void add_labels(DrawList& list) {
  double y = 8;
  for (const Words& words : many_scripts) {
    if (words.name.size() > 60) continue;
    list.texts.push_back({.text = std::string(words.name), .at = {10, y, 0}, .height = 13});
    y += 20;
  }
  list.texts.push_back({.text = "肝脏 · ήπαρ", .at = {0, 1.13, 0}, .overlay = false, .height = 14});
  list.texts.push_back({.text = "الكبد 12 mm", .at = {0.03, 1.13, 0}, .overlay = false, .height = 14});
}

GalleryPicture scripts() {
  constexpr int wide = 400, high = 300;
  DrawList list = stage({0.1, 1.4, 0.6}, {-0.08, 1.08, 0}, 0.6);
  list.cameras = {mono_camera(list.cameras[0].pose, 0.6, wide, high)};
  list.items.push_back(table());
  list.items.push_back(organ_part());
  add_labels(list);
  return {"scripts", wide, high, list};
}

/// Adds a panel that faces the eye.
void add_panel(DrawList& list, std::string_view name, std::string description, const Vec3& at,
               const Vec3& eye) {
  SceneBody part;
  part.name = name;
  part.description = std::move(description);
  Panel panel;
  panel.open = true;
  panel.pose = {at, look_at(eye, at).q};
  PanelView(40).add(list, panel, part);
}

std::string description_in(std::string_view script) {
  for (const Words& words : many_scripts)
    if (words.script == script) return std::string(words.description);
  return {};
}

/// Long words, words from right to left, and words of fonts that step in.
GalleryPicture panel_scripts() {
  constexpr int wide = 480, high = 420;
  const Vec3 eye(-0.16, 1.2, 0.8);
  DrawList list = stage(eye, {-0.16, 1.2, 0}, 0.75);
  list.cameras = {mono_camera(list.cameras[0].pose, 0.75, wide, high)};
  add_panel(list, many_scripts[1].name, description_in("German"), {-0.33, 1.34, 0.02}, eye);
  add_panel(list, many_scripts[2].name, description_in("Turkish"), {-0.33, 1.06, 0.02}, eye);
  add_panel(list, "الكبد · כבד", description_in("Arabic"), {0.01, 1.34, 0.02}, eye);
  add_panel(list, "肝脏 · ήπαρ · печень", description_in("Chinese") + "\n" + description_in("Devanagari"),
            {0.01, 1.06, 0.02}, eye);
  return {"panel_scripts", wide, high, list};
}

/// What both eyes of a headset see: labels and a panel.
GalleryPicture scripts_stereo() {
  constexpr int wide = 800, high = 300;
  const Vec3 eye(0.02, 1.4, 0.65);
  DrawList list = stage(eye, {-0.06, 1.12, 0}, 0.9);
  const auto eyes = stereo_cameras(list.cameras[0].pose, StereoProfile{}, wide, high);
  list.cameras.assign(eyes.begin(), eyes.end());
  list.items.push_back(table());
  list.items.push_back(organ_part());
  add_panel(list, "الكبد", description_in("Arabic"), {-0.22, 1.14, 0.02}, eye);
  list.texts.push_back({.text = "karaciğer · печень", .at = {10, 10, 0}, .height = 13});
  list.texts.push_back({.text = "肝脏 · ήπαρ", .at = {0.05, 1.12, 0}, .overlay = false, .height = 14});
  list.texts.push_back({.text = "यकृत 12 mm", .at = {0.06, 1.12, 0}, .overlay = false, .height = 14});
  return {"scripts_stereo", wide, high, list};
}

/// Balls in a heap, named in many scripts.
std::vector<NamedItem> add_named_heap(DrawList& list) {
  std::vector<NamedItem> named;
  for (std::size_t k = 0; k < many_scripts.size(); ++k) {
    if (many_scripts[k].name.size() > 60) continue;
    const double turn = 2.4 * static_cast<double>(k);
    PartDesc ball;
    ball.shape = "ellipsoid";
    ball.size = {0.06, 0.05, 0.07};
    ball.pose.p = {0.07 * std::cos(turn), 1.03 + 0.012 * static_cast<double>(k), 0.07 * std::sin(turn)};
    named.push_back({static_cast<std::uint32_t>(k), list.items.size(), many_scripts[k].name});
    const Vec3 color(0.2 + 0.06 * static_cast<double>(k % 4), 0.12, 0.1 + 0.04 * static_cast<double>(k % 3));
    list.items.push_back(rigid(ball, 50 + k, {color, 0.45, 0.9, Surface::tissue}));
  }
  return named;
}

/// Names in many scripts beside what they name.
GalleryPicture labels(bool stereo) {
  const int wide = stereo ? 960 : 480;
  constexpr int high = 320;
  DrawList list = stage({0.1, 1.3, 0.55}, {0, 1.07, 0});
  list.items.push_back(table());
  const Pose eye = list.cameras[0].pose;
  list.cameras = {mono_camera(eye, 0.6, wide, high)};
  if (stereo) {
    const auto eyes = stereo_cameras(eye, StereoProfile{}, wide, high);
    list.cameras.assign(eyes.begin(), eyes.end());
  }
  const std::vector<NamedItem> named = add_named_heap(list);
  const double width = list.cameras[0].width;
  PartLabels().add(list, named, {Eigen::Vector2d(8, 8), Eigen::Vector2d(width - 8, high - 8)});
  return {stereo ? "labels_stereo" : "labels", wide, high, list};
}

/// Parts named in many scripts: one is hidden, one faint, one red and held, one held by two.
std::vector<PartRow> rows_in_many_scripts() {
  PartsData known;
  PartsChoice choice;
  for (const Words& words : many_scripts) {
    SceneBody& body = known.scene.bodies.emplace_back();
    body.name = words.name;
    body.appearance.color = {0.42, 0.10, 0.08};
    body.part = true;
  }
  known.organs = organs_of(known.scene, [](BodyId) { return -1; });
  known.holders.resize(known.scene.bodies.size());
  known.holders[3] = {{"Ada", {0.9, 0.5, 0.1}}};
  known.holders[5] = {{"Grace", {0.2, 0.5, 0.9}}, {"نور", {0.2, 0.8, 0.3}}};
  choice.obey({.kind = PartsOrder::Kind::hide, .parts = {known.scene.bodies[4].name}});
  choice.obey({.kind = PartsOrder::Kind::opacity, .parts = {known.scene.bodies[2].name}, .opacity = 0.4});
  choice.obey({.kind = PartsOrder::Kind::color,
               .parts = {known.scene.bodies[3].name},
               .color = part_colors()[1].color});
  return part_rows(known, choice, "");
}

/// The list of parts: the pointer is at an eye, and the colours of a row are open.
GalleryPicture parts_list() {
  constexpr int wide = 480, high = 420;
  DrawList list = stage({0.1, 1.3, 0.55}, {0.12, 1.05, 0});
  list.cameras = {mono_camera(list.cameras[0].pose, 0.6, wide, high)};
  list.items.push_back(table());
  add_named_heap(list);
  PartsListState state;
  state.hovered = PartsSpot{PartsSpot::Kind::eye, 5, 0};
  state.palette = many_scripts[5].name;
  state.pointed = 7;
  add_parts_list(list, lay_out_parts(rows_in_many_scripts(), state, {wide, high}));
  return {"parts_list", wide, high, list};
}

/// Returns a right hand with its index finger stretched, whose tip is so far before a point of the board (m).
HandPose finger_at(const Pose& board, const Eigen::Vector2d& point, double before) {
  HandPose hand{.tracked = true, .pose = {}, .flexion = {0.4, 0, 0.8, 0.85, 0.9}};
  const Quat comes_from_right_below(Eigen::AngleAxisd(0.5, Vec3::UnitY()) *
                                    Eigen::AngleAxisd(0.6, Vec3::UnitX()));
  const Eigen::Vector2d off = board_metres_per_point * (point - parts_board_picture / 2);
  hand.pose.q = board.q * comes_from_right_below;
  hand.pose.p = board * Vec3(off.x(), -off.y(), before) - index_tip(right_hand, hand);
  return hand;
}

/// What both eyes of a headset see whose user called the board, turned to it, opened the colours of a row,
/// and now has a fingertip at an eye.
GalleryPicture parts_board() {
  constexpr int wide = 1280, high = 480;
  const Vec3 eye(0.05, 1.42, 0.5);
  DrawList list = stage(eye, {0, 1.1, 0});
  const Pose called_from = list.cameras[0].pose;
  list.items.push_back(table());
  add_named_heap(list);
  PartsBoard board;
  board.toggle_open(called_from, right_hand);
  board.follow(rows_in_many_scripts(), {});
  const PlacedPartsList placed = *board.shown();
  StereoProfile headset;
  headset.fov_horizontal = 1.1;
  headset.fov_vertical = 0.86;
  const Pose turned_to = look_at(eye, placed.pose * Vec3(0.06, 0, 0));
  const auto eyes = stereo_cameras(turned_to, headset, wide, high);
  list.cameras.assign(eyes.begin(), eyes.end());
  const PartsList& shown = *placed.list;
  const auto move = [&](std::size_t line, double x, double before) {
    HandInput user;
    user.hands[right_hand] = finger_at(placed.pose, {x, shown.lines[line].top + 10}, before);
    board.follow(rows_in_many_scripts(), user);
    return user.hands[right_hand];
  };
  for (const double before : {0.02, 0.0, 0.02}) move(5, shown.board.min().x() + 14, before);
  move(7, shown.board.max().x() - 91, 0.006);
  const HandPose pointing = move(7, shown.board.max().x() - 91, 0.006);  // the board shows it a picture later
  list.items.push_back(hand(right_hand, pointing, 80));
  PartsBoardView(81).add(list, placed);
  return {"parts_board", wide, high, list};
}

}  // namespace

const std::vector<std::string>& gallery_names() {
  static const std::vector<std::string> names = {"hand_open",
                                                 "hand_half",
                                                 "hand_fist",
                                                 "organ",
                                                 "avatar",
                                                 "text",
                                                 "panel",
                                                 "parts",
                                                 "glass",
                                                 "scripts",
                                                 "scripts_2x",
                                                 "panel_scripts",
                                                 "panel_scripts_2x",
                                                 "scripts_stereo",
                                                 "labels",
                                                 "labels_stereo",
                                                 "parts_list",
                                                 "parts_list_2x",
                                                 "parts_board",
                                                 "error"};
  return names;
}

GalleryPicture gallery_picture(const std::string& name) {
  if (name == "hand_open") return hands(name, 0);
  if (name == "hand_half") return hands(name, 0.5);
  if (name == "hand_fist") return hands(name, 1);
  if (name == "organ") return organ();
  if (name == "avatar") return avatar();
  if (name == "panel") return panel();
  if (name == "parts") return parts();
  if (name == "glass") return glass();
  if (name == "scripts") return scripts();
  if (name == "scripts_2x") return on_finer_display(scripts(), 2);
  if (name == "panel_scripts") return panel_scripts();
  if (name == "panel_scripts_2x") return on_finer_display(panel_scripts(), 2);
  if (name == "scripts_stereo") return scripts_stereo();
  if (name == "labels") return labels(false);
  if (name == "labels_stereo") return labels(true);
  if (name == "parts_list") return parts_list();
  if (name == "parts_list_2x") return on_finer_display(parts_list(), 2);
  if (name == "parts_board") return parts_board();
  if (name == "error") return error();
  return text();
}

}  // namespace prosector::test
