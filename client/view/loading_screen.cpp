#include "client/view/loading_screen.h"

#include <algorithm>

#include "client/view/camera.h"
#include "client/view/overlay_frame.h"

namespace prosector {
namespace {

constexpr double bar_share = 0.5;                      // fraction of the view's width
constexpr double bar_width = 8;                        // points, thickness
constexpr double title_height = 20, text_height = 13;  // points
constexpr double title_above = 40, text_below = 16;    // points, from the bar
const Vec3 rail{0.10, 0.12, 0.14}, done{0.20, 0.62, 0.86}, pale_writing{0.85, 0.88, 0.90};

}  // namespace

DrawList loading_picture(const std::string& title, const std::string& waits_for, double progress, int width,
                         int height, double scale) {
  DrawList list;
  list.scale = scale;
  list.cameras.push_back(mono_camera(Pose{}, CameraInfo().fov, width, height));
  const OverlayFrame frame(list);
  const double left = (1 - bar_share) / 2 * frame.width, length = bar_share * frame.width;
  const double middle = frame.height / 2;
  const auto bar = [&](double share, const Vec3& color) {
    list.lines.push_back(
        {frame.at(left, middle), frame.at(left + share * length, middle), color, bar_width, true});
  };
  bar(1, rail);
  bar(std::clamp(progress, 0.0, 1.0), done);
  list.texts.push_back(
      {.text = title, .at = {left, middle - title_above, 0}, .height = title_height, .color = pale_writing});
  list.texts.push_back({.text = waits_for,
                        .at = {left, middle + text_below, 0},
                        .height = text_height,
                        .color = pale_writing,
                        .wrap = length});
  return list;
}

}  // namespace prosector
