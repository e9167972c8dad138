#include "client/app/desk/desk.h"

#include <algorithm>
#include <utility>

#include "common/clock.h"

namespace prosector {
namespace {

constexpr double reach_per_notch = 0.01;  // m
constexpr double wrist_per_notch = 0.1;   // rad
constexpr double pad_reach_speed = 0.4;   // m/s
constexpr double pad_wrist_speed = 1.5;   // rad/s
constexpr double first_reach =
    0.7;  // fraction of the distance to the view's target, before any surface is known
constexpr double farthest_surface = 4;  // m: surfaces farther away are out of the hand's reach

/// Returns the command that changes the pace of the session, which only the host may do. The server replies
/// to other users with a refusal. `pace`: present ratio of simulated to real time.
std::optional<CommandBody> pace_command(Key key, double pace) {
  if (key == Key::space) return SetPace{pace == 0 ? 1.0 : 0.0};
  if (key == key_of(',')) return SetPace{std::max(pace / 2, min_pace)};
  if (key == key_of('.')) return StepTicks{1};
  return std::nullopt;
}

OverlayFrame overlay_frame(const DeskView& view, double scale) {
  return {view.camera(), scale};
}

/// Returns the position of the pointer in points from the top left.
Eigen::Vector2d pointer_point(const DeskView& view, double scale) {
  return view.pointer_pixel() / scale;
}

/// Moves the view to the parts that the user has selected in the list.
void frame_parts(PartsDesk& parts, const DeskRoom& room, DeskView& view) {
  Eigen::AlignedBox3d box;
  for (const BodyId body : parts.take_framed()) box.extend(room.box(body));
  view.frame(box);
}

/// Returns a function that finds surfaces of the room. The room must outlive it.
FindSurface finder(const DeskRoom& room) {
  return [&room](const Ray& ray, std::optional<BodyId> only) -> std::optional<Picked> {
    const auto met = room.surface(ray);
    return met && (!only || met->body == *only) ? met : std::nullopt;
  };
}

}  // namespace

void Desk::begin(const DeskStart& start, std::chrono::steady_clock::time_point now) {
  view_.begin(start, window_.width(), window_.height());
  hand_.begin(view_.pointer(), first_reach * start.home.distance);
  last_update_ = now;
}

void Desk::update(const DeskSession& session, std::chrono::steady_clock::time_point now) {
  const double seconds = last_update_ ? std::chrono::duration<double>(now - *last_update_).count() : 0;
  last_update_ = now;
  panel_opening_.follow_touch(session.touched, now);
  const bool is_new = panel_.follow(session.own_panel, session.effort, session.hidden_panel_lines);
  if (panel_.should_keep_open(view_.pointer())) ask(OpenPanel{panel_.shown()->body});
  if (is_new) ask(panel_opening_.opened(panel_, hand_.hovers(), view_, now));
  pace_ = session.pace;
  scale_ = session.scale;
  time_.see(session.watched, std::chrono::duration<double>(now.time_since_epoch()).count());
  for (const WindowEvent& event : window_.poll_events()) take(event, session);
  frame_parts(parts_, session.room, view_);
  ask(panel_.take_placing());
  view_.advance(seconds, pad_);
  ask(panel_opening_.close_when_left(panel_, view_));
  move_hand(session, seconds);
  parts_.lay_out(session.parts, pointed_, Eigen::Vector2d(window_.width(), window_.height()) / session.scale);
}

void Desk::wait() {
  for (const WindowEvent& event : window_.poll_events()) {
    const auto* key = std::get_if<KeyEvent>(&event);
    if (std::get_if<CloseRequested>(&event) || (key && key->down && key->key == Key::escape)) closed_ = true;
  }
}

/// Processes an event, unless the list of parts consumes it.
void Desk::take(const WindowEvent& event, const DeskSession& session) {
  if (const auto* pad = std::get_if<GamepadMoved>(&event)) {
    for (const WindowEvent& same : pad_.take(pad->now)) take(same, session);
    for (int calls = pad_.take_list_calls(); calls > 0; --calls) parts_.toggle_without_search();
    const int notches = pad_.take_notches();
    if (notches != 0 && points_over_room()) take(WheelTurned{0, static_cast<double>(notches)}, session);
  }
  Eigen::Vector2d pointer = view_.pointer_pixel();
  if (const auto* mouse = std::get_if<MouseMoved>(&event)) pointer = {mouse->x, mouse->y};
  if (!parts_.take(event, pointer / session.scale)) act(event, session);
}

void Desk::act(const WindowEvent& event, const DeskSession& session) {
  const DeskRoom& room = session.room;
  view_.take(event, room);
  if (std::get_if<CloseRequested>(&event)) closed_ = true;
  if (const auto* key = std::get_if<KeyEvent>(&event); key != nullptr && key->down && !key->repeat)
    press(key->key);
  if (const auto* key = std::get_if<KeyEvent>(&event);
      key != nullptr && key->key == section_key && !key->repeat)
    key->down ? display_.press_section(view_, room) : display_.release_section();
  if (const auto* button = std::get_if<MouseButtonEvent>(&event)) {
    if (button->button == MouseButton::left) button->down ? press_button(room) : let_go();
    trace_cut(session);
    if (button->button == MouseButton::middle && button->down) panel_opening_.request(view_.pointer());
  }
  if (const auto* wheel = std::get_if<WheelTurned>(&event))
    turn_wheel(wheel->y != 0 ? wheel->y : wheel->x);  // some systems scroll horizontally while Shift is held
  if (!std::get_if<MouseMoved>(&event)) return;
  ask(time_.move(overlay_frame(view_, scale_), pointer_point(view_, scale_)));
  ask(panel_mouse_.move(panel_, view_.pointer()));
  trace_cut(session);
}

void Desk::press(Key key) {
  if (key == Key::escape) closed_ = true;
  display_.press(key, view_.is_held(Key::shift));
  if (key == key_of('P')) panel_opening_.request(view_.pointer());
  if (panel_.shown() && view_.view_of(key)) panel_opening_.leave();
  if (key == key_of('Z')) {
    // A blade that is drawing a cut leaves the tissue before the undo, because it would cut on its way out.
    hand_.lift_blade();
    undo_pending_ = true;
  }
  ask(time_.press(key));
  ask(pace_command(key, pace_));
}

void Desk::turn_wheel(double notches) {
  if (view_.is_held(section_key)) {
    display_.move_section(notches);
    return;
  }
  if (view_.is_held(Key::control)) return;  // the view zooms
  if (panel_.covers(view_.pointer()) && !hand_.is_pressed())
    panel_.scroll(-notches);
  else if (view_.is_held(Key::shift))
    hand_.turn(wrist_per_notch * notches, 0);
  else if (view_.is_held(Key::alt))
    hand_.turn(0, wrist_per_notch * notches);
  else
    hand_.reach(reach_per_notch * notches);
}

void Desk::move_hand(const DeskSession& session, double seconds) {
  const PadStick wrist = pad_.wrist();
  if (!points_over_room()) hand_.reach(pad_reach_speed * seconds * pad_.reach());
  hand_.turn(pad_wrist_speed * seconds * wrist.right, -pad_wrist_speed * seconds * wrist.down);
  HandGuide guide;
  guide.pointer = view_.pointer();
  guide.back = view_.place().back();
  guide.yaw = view_.place().yaw;
  guide.pitch = view_.place().pitch;
  guide.still = points_over_room() && !hand_.is_pressed();  // the hand would cover the panel or the list
  const auto point = session.room.surface(guide.pointer);
  pointed_ = point && !points_over_room() ? std::optional(point->body) : std::nullopt;
  if (point && point->distance < farthest_surface) {
    guide.surface = point->distance;
    guide.soft = session.is_soft(point->body);
    guide.level = point->normal.y();
  }
  guide.gap = [&](const Vec3& place) -> std::optional<double> {
    const Vec3 way = place - guide.pointer.from;
    const auto behind = session.room.surface({guide.pointer.from, way.normalized()});
    return behind ? std::optional(behind->distance - way.norm()) : std::nullopt;
  };
  guide.physical = session.physical_hand;
  guide.is_paused = session.pace == 0;
  guide.tip = session.tip;
  guide.blade = session.blade;
  guide.at_blade = point && session.is_blade && session.is_blade(point->body);
  guide.right = view_.place().pose().q * Vec3::UnitX();
  if (point && guide.soft && !panel_.covers(guide.pointer)) guide.tissue = point;
  guide.find = finder(session.room);
  hand_.advance(guide, seconds);
  if (!hand_.draws() && std::exchange(undo_pending_, false)) ask(Undo{});
  for (const HandRequest wish : hand_.take_wishes())
    ask(wish == HandRequest::grasp ? CommandBody(Grasp{right_hand, pressed_at_})
                                   : CommandBody(Release{right_hand}));
}

/// Records the pointer's path on tissue while a blade may be drawn along it: several events arrive between
/// two frames.
void Desk::trace_cut(const DeskSession& session) {
  if (!hand_.is_pressed() || !hand_.cut_depth()) return;
  const auto point = session.room.surface(view_.pointer());
  if (point && session.is_soft(point->body) && !panel_.covers(view_.pointer()))
    hand_.trace(*point, finder(session.room));
}

/// Handles the button press: on the user's panel it operates the controls, elsewhere it grasps. The second
/// press of a double click frames the part; the first one is too short to grasp.
void Desk::press_button(const DeskRoom& room) {
  if (const auto wanted = time_.press(overlay_frame(view_, scale_), pointer_point(view_, scale_)))
    return ask(wanted);
  const Ray pointer = view_.pointer();
  const Eigen::Vector2d& pixel = view_.pointer_pixel();
  if (panel_.covers(pointer))
    return ask(panel_mouse_.press(panel_, pointer, view_.place().back(), clicks_, pixel));
  pressed_at_ = pointed_;
  clicks_.press(pixel) ? view_.frame_pointed(room) : hand_.press();
}

void Desk::let_go() {
  ask(time_.let_go());
  panel_mouse_.release(panel_);
  if (hand_.is_pressed()) hand_.let_go();
}

void Desk::ask(const std::optional<CommandBody>& command) {
  if (command) commands_.push_back(*command);
}

HandInput Desk::input() const {
  HandInput input;
  input.time_ns = monotonic_ns();
  input.head_tracked = true;
  input.head = view_.eye();
  HandPose& hand = input.hands[right_hand];
  hand.tracked = !hand_.is_withdrawn();
  hand.pose = hand_.pose();
  hand.flexion.fill(hand_.flexion());
  hand.gesture = hand_.is_closed() ? Gesture::fist : Gesture::flat;
  if (hand_.is_drawing()) hand.buttons = draws_cut;
  return input;
}

std::vector<CommandBody> Desk::take_commands() {
  return std::exchange(commands_, {});
}

}  // namespace prosector
