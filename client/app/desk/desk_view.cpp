#include "client/app/desk/desk_view.h"

#include <algorithm>
#include <cmath>

#include "client/view/camera.h"

namespace prosector {
namespace {

constexpr double turn_per_pixel = 0.005;                 // rad
constexpr double zoom_per_pixel = 0.005;                 // change of log(distance)
constexpr double zoom_per_notch = 0.1;                   // change of log(distance)
constexpr double zoom_per_second = 1.2;                  // change of log(distance), by a key or a stick
constexpr double fly_speed = 0.6;                        // m/s
constexpr double pad_speed = 400;                        // pixels/s at full stick deflection
constexpr double largest_framed = 0.6;                   // m: larger boxes are approached, not framed
constexpr double roomy = 0.9;                            // fraction of the frame
constexpr double near_distance = 0.5;                    // m
constexpr double first_right = 0.9, first_below = 0.85;  // fractions of the frame: outside the framed anatomy

/// Returns the index of the saved view that a key selects, from 0 for key 1; nullopt: none.
std::optional<std::size_t> index_of_view(Key key) {
  if (key < key_of('1') || key > key_of('9')) return std::nullopt;
  return static_cast<std::size_t>(static_cast<int>(key) - '1');
}

}  // namespace

void DeskView::begin(const DeskStart& start, int width, int height) {
  orbit_.begin(start.home);
  fov_ = start.fov;
  views_ = start.views;
  width_ = std::max(width, 1);
  height_ = std::max(height, 1);
  pointer_ = {first_right * width_, first_below * height_};
}

void DeskView::follow_camera(const std::optional<DrawCamera>& camera) {
  leading_ = camera;
  if (!camera) return;
  const double ahead = orbit_.place().distance;
  leading_place_ = place_of(camera->pose.p, camera->pose * Vec3(0, 0, -ahead));
}

/// Returns the camera used when the screen does not act as a window.
DrawCamera DeskView::resting_camera() const {
  if (leading_) return *leading_;
  return mono_camera(place().pose(), fov_, width_, height_);
}

DrawCamera DeskView::camera() const {
  const DrawCamera rest = resting_camera();
  return look_ ? look_through(rest, place().distance, *look_) : rest;
}

Ray DeskView::pointer() const {
  return ray_through(camera(), pointer_.x(), pointer_.y());
}

void DeskView::take(const WindowEvent& event, const DeskRoom& room) {
  if (const auto* key = std::get_if<KeyEvent>(&event)) {
    keys_.take(*key);
    if (key->down && !key->repeat) press(key->key, room);
  }
  if (const auto* button = std::get_if<MouseButtonEvent>(&event);
      button != nullptr && button->button == MouseButton::right) {
    drags_ = button->down;
    const auto point = button->down ? room.surface(pointer()) : std::nullopt;
    drag_depth_ = point ? (place().eye() - point->at).dot(place().back()) : place().distance;
  }
  if (const auto* wheel = std::get_if<WheelTurned>(&event); wheel != nullptr && is_held(Key::control))
    orbit_.zoom(std::exp(-zoom_per_notch * wheel->y));
  if (const auto* mouse = std::get_if<MouseMoved>(&event)) {
    const Eigen::Vector2d to(mouse->x, mouse->y);
    if (drags_) drag(to - pointer_);
    pointer_ = to;
  }
  if (const auto* size = std::get_if<Resized>(&event)) {
    width_ = std::max(size->width, 1);
    height_ = std::max(size->height, 1);
  }
}

void DeskView::press(Key key, const DeskRoom& room) {
  if (key == key_of('F')) flies_ = !flies_;
  if (key == key_of('G')) frame_pointed(room);
  if (const auto view = view_of(key)) orbit_.go_to(*view);
  if (const auto index = index_of_view(key); index && is_held(Key::control)) views_[*index] = place();
}

std::optional<ViewPlace> DeskView::view_of(Key key) const {
  if (key == Key::home) return orbit_.home();
  const auto index = index_of_view(key);
  return index && !is_held(Key::control) ? views_[*index] : std::nullopt;
}

void DeskView::frame_pointed(const DeskRoom& room) {
  const auto point = room.surface(pointer());
  if (!point) return;
  const ViewPlace& now = place();
  const Eigen::AlignedBox3d box = room.box(point->body);
  if (box.sizes().norm() <= largest_framed)
    frame(box);
  else
    orbit_.go_to({point->at, now.yaw, now.pitch, std::min(now.distance, near_distance)});
}

void DeskView::frame(const Eigen::AlignedBox3d& box) {
  const double aspect = static_cast<double>(width_) / height_;
  if (!box.isEmpty()) orbit_.go_to(framed(box, place().yaw, place().pitch, fov_, aspect));
}

void DeskView::make_room_for(const Eigen::AlignedBox3d& box) {
  const ViewPlace& now = place();
  const double aspect = static_cast<double>(width_) / height_;
  // The new view also keeps its present target in the frame.
  const Eigen::AlignedBox3d all = box.merged(Eigen::AlignedBox3d(now.target, now.target));
  const Pose into = now.pose().inverse();
  const DrawCamera seen = resting_camera();
  for (int k = 0; k < 8; ++k) {
    const Vec3 x = into * box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k));
    const bool inside =
        x.z() < -seen.near && std::abs(x.x()) < -x.z() * seen.right && std::abs(x.y()) < -x.z() * seen.top;
    if (!inside) return orbit_.go_to(framed(all, now.yaw, now.pitch, fov_, aspect, roomy));
  }
}

/// Moves the view according to the pointer's motion, pixels, while the right button is pressed.
void DeskView::drag(const Eigen::Vector2d& by) {
  if (is_held(Key::shift)) {
    const double per_pixel =
        2 * std::tan(fov_ / 2) / height_ * drag_depth_;  // m per pixel at the dragged point
    orbit_.move(place().pose().q * Vec3(-per_pixel * by.x(), per_pixel * by.y(), 0));
  } else if (is_held(Key::control)) {
    orbit_.zoom(std::exp(zoom_per_pixel * by.y()));
  } else {
    turn(by);
  }
}

void DeskView::turn(const Eigen::Vector2d& by) {
  const Eigen::Vector2d angle = turn_per_pixel * by;
  flies_ ? orbit_.rotate_gaze(angle.x(), angle.y()) : orbit_.turn(angle.x(), angle.y());
}

void DeskView::fly(double seconds, const GamepadUser& pad) {
  const auto down = [&](char key) { return keys_.was_down(key_of(key)) ? 1.0 : 0.0; };
  const Vec3 keys(down('D') - down('A'), down('E') - down('Q'), down('S') - down('W'));
  const Vec3 step = (keys + pad.flight()).cwiseMax(-1).cwiseMin(1);
  if (!step.isZero(0)) {
    const Quat level(Eigen::AngleAxisd(place().yaw, Vec3::UnitY()));
    orbit_.move(fly_speed * seconds * ((flies_ ? place().pose().q : level) * step));
  }
  const double zoom = std::clamp(down('-') - down('=') + pad.zoom(), -1.0, 1.0);
  if (zoom != 0) orbit_.zoom(std::exp(zoom_per_second * seconds * zoom));
  keys_.forget_taps();
}

void DeskView::advance(double seconds, const GamepadUser& pad) {
  orbit_.advance(seconds);
  fly(seconds, pad);
  const PadStick turned = pad.turn(), pointed = pad.pointing();
  const double pixels = pad_speed * seconds;
  if (turned.right != 0 || turned.down != 0) turn(pixels * Eigen::Vector2d(turned.right, turned.down));
  pointer_.x() = std::clamp(pointer_.x() + pixels * pointed.right, 0.0, static_cast<double>(width_));
  pointer_.y() = std::clamp(pointer_.y() + pixels * pointed.down, 0.0, static_cast<double>(height_));
}

}  // namespace prosector
