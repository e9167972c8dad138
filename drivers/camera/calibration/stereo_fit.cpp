#include "drivers/camera/calibration/stereo_fit.h"

#include <fmt/format.h>

#include "common/error.h"

namespace prosector {

MeanPose fit_stereo(std::span<const StereoView> views) {
  if (views.size() < least_stereo_views)
    throw InputError(
        fmt::format("{} views that both cameras share: at least {} are needed, and {} are better",
                    views.size(), least_stereo_views, usual_stereo_views));
  std::vector<MeasuredPose> seconds;
  for (const StereoView& view : views) {
    const Pose first_second = view.first_board.pose * view.second_board.pose.inverse();
    seconds.push_back(
        {first_second, view.first_board.spread + spread_in(first_second, view.second_board.spread)});
  }
  return mean_pose(seconds);
}

}  // namespace prosector
