#include "drivers/camera/calibration/camera_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "drivers/camera/tags/standard_boards.h"

namespace prosector {
namespace {

constexpr double least_rate = 15, most_dropped = 0.05, most_noise = 8;

double middle(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Returns the noise of a pixel (standard deviation) from two images of a mostly static scene. It uses the
/// median difference, which moving objects hardly affect.
double noise_between(const GreyImage& a, const GreyImage& b) {
  std::array<std::size_t, 256> counts{};
  for (std::size_t i = 0; i < a.grey.size(); ++i)
    ++counts[static_cast<std::size_t>(std::abs(a.grey[i] - b.grey[i]))];
  std::size_t sum = 0, at = 0;
  while (at < counts.size() && 2 * (sum + counts[at]) < a.grey.size()) sum += counts[at++];
  const double share = at < counts.size() && counts[at] > 0
                           ? (0.5 * static_cast<double>(a.grey.size()) - static_cast<double>(sum)) /
                                 static_cast<double>(counts[at])
                           : 0;
  return 1.4826 * (static_cast<double>(at) - 0.5 + share) / std::sqrt(2.0);
}

/// Returns the standard deviations of positions along the camera's axis and across it, m.
std::pair<double, double> scatter(const std::vector<Vec3>& places) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : places) sum += p;
  const Vec3 at = sum / static_cast<double>(places.size());
  double along = 0, across = 0;
  for (const Vec3& p : places) {
    along += (p - at).z() * (p - at).z();
    across += (p - at).head<2>().squaredNorm() / 2;
  }
  const auto n = static_cast<double>(places.size());
  return {std::sqrt(along / n), std::sqrt(across / n)};
}

}  // namespace

CameraReport::CameraReport(std::optional<CameraCalibration> calibration)
    : calibration_(calibration), reader_(std::move(calibration)) {
  for (const StandardBoard& row : standard_boards()) {
    boards_.push_back({BoardTracker(grid_board(row.name, row.grid)), {}, 0});
    reader_.expect(boards_.back().tracker.board());
  }
}

void CameraReport::take(const Frame& frame, std::int64_t now_ns) {
  if (frames_++ == 0) {
    width_ = frame.image.width;
    height_ = frame.image.height;
    next_number_ = frame.number;
  }
  if (frame.image.width != width_ || frame.image.height != height_) {
    ++wrong_size_images_;
    return;
  }
  dropped_ += frame.number - next_number_;
  next_number_ = frame.number + 1;
  GreyImage picture = grey_of(frame.image);
  brightness_.push_back(brightness_of(picture));
  if (!last_.grey.empty()) {
    if (last_.grey == picture.grey) ++alike_;
    noise_.push_back(noise_between(last_, picture));
  }
  ages_.push_back(static_cast<double>(now_ns - frame.time_ns) * 1e-9);
  steps_.push_back(static_cast<double>(frame.time_ns) * 1e-9);
  look_for_boards(frame);
  last_ = std::move(picture);
}

void CameraReport::look_for_boards(const Frame& frame) {
  const TagImage& seen = reader_.read(frame);
  tags_.push_back(static_cast<double>(seen.tags.size()));
  for (Followed& board : boards_)
    if (const auto at = board.tracker.update(seen, reader_.optics())) {
      board.places.push_back(at->camera_board.p);
      board.followed += at->followed ? 1 : 0;
    }
}

bool CameraReport::is_good() const {
  if (frames_ < 2) return false;
  const double rate = static_cast<double>(frames_ - 1) / std::max(1e-9, steps_.back() - steps_.front());
  return wrong_size_images_ == 0 && rate >= least_rate &&
         static_cast<double>(dropped_) <= most_dropped * static_cast<double>(frames_) &&
         middle(brightness_) >= least_light && middle(noise_) <= most_noise;
}

std::vector<std::string> CameraReport::lines() const {
  if (frames_ < 2) return {"no images received"};
  std::vector<double> steps;
  for (std::size_t i = 1; i < steps_.size(); ++i) steps.push_back(steps_[i] - steps_[i - 1]);
  const double step = middle(steps), longest = *std::max_element(steps.begin(), steps.end());
  std::vector<std::string> out = {
      fmt::format(
          "{} images of {} × {} pixels; {} of another size; {} dropped; {} identical to the previous one",
          frames_, width_, height_, wrong_size_images_, dropped_, alike_),
      fmt::format("{:.1f} images per second, at most {:.0f} ms apart; delivered {:.0f} ms after "
                  "mid-exposure, as reported by the camera",
                  1 / std::max(1e-6, step), 1e3 * longest, 1e3 * middle(ages_)),
      fmt::format("brightness {:.0f} of 255{}; noise {:.1f}{}", middle(brightness_),
                  middle(brightness_) < least_light ? ": too dark" : "", middle(noise_),
                  middle(noise_) > most_noise ? ": too high; add light" : ""),
      fmt::format("{:.0f} tags per image", middle(tags_))};
  for (const Followed& board : boards_) {
    if (board.places.size() < 2) continue;
    const auto [along, across] = scatter(board.places);
    out.push_back(fmt::format(
        "board {}: detected in {} images, {} of them by optical flow only; distance {:.3f} m; noise {:.3f} "
        "mm along the optical axis, {:.3f} mm across (a board at rest: below 0.3 mm)",
        board.tracker.board().name, board.places.size(), board.followed, board.places.back().norm(),
        1e3 * along, 1e3 * across));
  }
  out.push_back(
      calibration_
          ? fmt::format("the camera is calibrated as \"{}\", error {:.3f} px in views not used for the fit",
                        calibration_->camera, calibration_->error)
          : "the camera is not calibrated: distances have an error of about 10 %");
  return out;
}

}  // namespace prosector
