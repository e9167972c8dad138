#include "client/app/desk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "client/view/camera.h"
#include "common/clock.h"

namespace prosector {
namespace {

constexpr double turn_per_pixel = 0.005;  // rad
constexpr double reach_per_notch = 0.02;  // m
constexpr double wrist_per_notch = 0.1;   // rad
constexpr double fly_speed = 0.6;         // m/s
constexpr double pad_speed = 400;  // pixels/s of the pointer or of a turn, for a stick that is pushed fully
constexpr double pad_reach_speed = 0.4;  // m/s
constexpr double pad_wrist_speed = 1.5;  // rad/s
constexpr double first_reach = 0.7;      // of the way to what the view is of: beside it, not in it
constexpr double steepest = 1.5;         // rad: the view never turns over
constexpr std::chrono::milliseconds slide_interval{40};  // a server takes no more than 50 commands a second

Shown next(Shown shown) {
  return static_cast<Shown>((static_cast<std::size_t>(shown) + 1) % value_scales.size());
}

}  // namespace

void Desk::begin(const CameraInfo& start) {
  view_ = start;
  const Vec3 back = start.eye - start.target;
  distance_ = back.norm();
  yaw_ = std::atan2(back.x(), back.z());
  pitch_ = std::asin(std::clamp(back.y() / distance_, -1.0, 1.0));
  hand_.begin(first_reach * distance_);
  pointer_x_ = 0.5 * window_.width();
  pointer_y_ = 0.5 * window_.height();
  last_update_ = std::chrono::steady_clock::now();
}

void Desk::update(const CameraInfo& start, const Panel* own_panel) {
  if (!view_) begin(start);
  panel_ = own_panel != nullptr ? std::optional(*own_panel) : std::nullopt;
  for (const WindowEvent& event : window_.poll_events()) take(event);
  const auto now = std::chrono::steady_clock::now();
  const double seconds = std::chrono::duration<double>(now - last_update_).count();
  last_update_ = now;
  fly(seconds);
  pressed_keys_.clear();
  follow_pad(seconds);
  hand_.advance(seconds);
  eye_ = look_at(view_->target + distance_ * back(), view_->target);
  if (hand_.closed() || !at_panel()) hand_pose_ = hand_.pose(pointer(), yaw_);
}

void Desk::wait() {
  for (const WindowEvent& event : window_.poll_events()) {
    const auto* key = std::get_if<KeyEvent>(&event);
    if (std::get_if<CloseRequested>(&event) || (key && key->down && key->key == Key::escape)) closed_ = true;
  }
}

void Desk::take(const WindowEvent& event) {
  if (std::get_if<CloseRequested>(&event)) closed_ = true;
  if (const auto* key = std::get_if<KeyEvent>(&event)) {
    if (key->down && !key->repeat) press(key->key);
    if (key->down) pressed_keys_.insert(key->key);
    if (key->down)
      held_keys_.insert(key->key);
    else
      held_keys_.erase(key->key);
  }
  if (const auto* button = std::get_if<MouseButtonEvent>(&event)) {
    if (button->button == MouseButton::left) button->down ? press() : let_go();
    if (button->button == MouseButton::middle && button->down) panel_request_ = pointer();
    if (button->button == MouseButton::right) turning_ = button->down;
  }
  if (const auto* wheel = std::get_if<WheelTurned>(&event))
    turn_wheel(wheel->y != 0 ? wheel->y : wheel->x);  // some systems turn it sideways while Shift is held
  if (const auto* pad = std::get_if<GamepadMoved>(&event))
    for (const WindowEvent& same : pad_.take(pad->now)) take(same);
  if (const auto* mouse = std::get_if<MouseMoved>(&event)) {
    if (turning_) turn(mouse->x - pointer_x_, mouse->y - pointer_y_);
    pointer_x_ = mouse->x;
    pointer_y_ = mouse->y;
    if (sliding_ && panel_ && std::chrono::steady_clock::now() - last_slide_ > slide_interval)
      if (const auto point = meet(pointer(), *panel_)) slide(point->at);
  }
}

void Desk::press(Key key) {
  if (key == Key::escape) closed_ = true;
  if (key == Key::tab) ++follow_requests_;
  if (key == Key::f1 || key == key_of('H')) help_ = !help_;
  if (key == Key::f11) full_screen_ = !full_screen_;
  if (key == key_of('C')) wireframes_ = !wireframes_;
  if (key == key_of('F')) flying_ = !flying_;
  if (key == key_of('I')) figures_ = !figures_;
  if (key == key_of('P')) panel_request_ = pointer();
  if (key == key_of('V')) shown_ = next(shown_);
  if (key == key_of('Z')) ask(CommandKind::undo);
}

Vec3 Desk::back() const {
  return {std::sin(yaw_) * std::cos(pitch_), std::sin(pitch_), std::cos(yaw_) * std::cos(pitch_)};
}

/// Turns the view by pixels of the pointer.
void Desk::turn(double right, double down) {
  const Vec3 eye = view_->target + distance_ * back();
  yaw_ -= turn_per_pixel * right;
  pitch_ = std::clamp(pitch_ + turn_per_pixel * down, -steepest, steepest);
  if (flying_) view_->target = eye - distance_ * back();
}

void Desk::fly(double seconds) {
  const auto held = [&](char key) {
    return held_keys_.contains(key_of(key)) || pressed_keys_.contains(key_of(key)) ? 1.0 : 0.0;
  };
  const Vec3 keys(held('D') - held('A'), held('E') - held('Q'), held('S') - held('W'));
  const Vec3 step = (keys + pad_.flight()).cwiseMax(-1).cwiseMin(1);
  const Quat level(Eigen::AngleAxisd(yaw_, Vec3::UnitY()));
  const Quat heading = flying_ ? Quat(level * Eigen::AngleAxisd(-pitch_, Vec3::UnitX())) : level;
  view_->target += fly_speed * seconds * (heading * step);
}

void Desk::follow_pad(double seconds) {
  const double pixels = pad_speed * seconds;
  turn(pixels * pad_.turn().right, pixels * pad_.turn().down);
  hand_.reach(pad_reach_speed * seconds * pad_.reach());
  const PadStick wrist = pad_.wrist();
  hand_.turn(pad_wrist_speed * seconds * wrist.right, -pad_wrist_speed * seconds * wrist.down);
  if (const PadStick stick = pad_.pointing(); stick.right != 0 || stick.down != 0)
    take(
        MouseMoved{std::clamp(pointer_x_ + pixels * stick.right, 0.0, static_cast<double>(window_.width())),
                   std::clamp(pointer_y_ + pixels * stick.down, 0.0, static_cast<double>(window_.height()))});
}

void Desk::turn_wheel(double notches) {
  if (held_keys_.contains(Key::shift))
    hand_.turn(wrist_per_notch * notches, 0);
  else if (held_keys_.contains(Key::control))
    hand_.turn(0, wrist_per_notch * notches);
  else
    hand_.reach(reach_per_notch * notches);
}

/// Takes the button: on the user's panel it works the controls, elsewhere it grasps.
void Desk::press() {
  const auto point = panel_ ? meet(pointer(), *panel_) : std::nullopt;
  if (!point) {
    hand_.close(true);
    ask(CommandKind::grasp);
  } else if (point->control == PanelControl::stiffness) {
    sliding_ = true;
    slide(point->at);
  } else if (point->control) {
    const ControlState& button = panel_->controls[static_cast<std::size_t>(*point->control)];
    ask(CommandKind::set_control, *point->control, button.on ? 0 : 1);
  }
}

void Desk::let_go() {
  sliding_ = false;
  if (!hand_.closed()) return;
  hand_.close(false);
  ask(CommandKind::release);
}

void Desk::slide(const Vec3& at) {
  last_slide_ = std::chrono::steady_clock::now();
  ask(CommandKind::set_control, PanelControl::stiffness, slider_position(at));
}

void Desk::ask(CommandKind kind, PanelControl control, double value) {
  Command& command = commands_.emplace_back();
  command.kind = kind;
  command.control = control;
  command.value = value;
}

DrawCamera Desk::camera() const {
  return mono_camera(eye_, view_->fov, window_.width(), window_.height());
}

HandInput Desk::input() const {
  HandInput input;
  input.time_ns = monotonic_ns();
  input.head_tracked = true;
  input.head = eye_;
  HandPose& hand = input.hands[right_hand];
  hand.tracked = true;
  hand.pose = hand_pose_;
  hand.flexion.fill(hand_.flexion());
  hand.gesture = hand_.closed() ? Gesture::fist : Gesture::flat;
  return input;
}

std::vector<Command> Desk::take_commands() {
  return std::exchange(commands_, {});
}

std::size_t Desk::take_follow_requests() {
  return std::exchange(follow_requests_, 0);
}

std::optional<Ray> Desk::take_panel_request() {
  return std::exchange(panel_request_, std::nullopt);
}

}  // namespace prosector
