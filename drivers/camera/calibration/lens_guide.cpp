#include "drivers/camera/calibration/lens_guide.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "common/error.h"

namespace prosector {
namespace {

constexpr double least_share = 0.5;  // share of the board's tags that must be visible
constexpr double still_px = 0.7;     // pixels, largest motion of a corner between images of a board at rest
constexpr double new_middle = 0.08;  // share of the image's width; a larger difference makes a new view
constexpr double new_lean = 0.04,
                 new_size = 0.1;    // lean; log of the size ratio: larger differences make a new view
constexpr double least_size = 0.2;  // share of the image's width; a smaller board is too far away

/// Reports whether the tags are at rest between two images.
bool is_at_rest(const std::vector<DetectedTag>& before, const std::vector<DetectedTag>& now) {
  int same = 0;
  for (const DetectedTag& tag : now)
    for (const DetectedTag& old : before)
      if (old.code == tag.code) {
        ++same;
        for (std::size_t c = 0; c < tag.corners.size(); ++c)
          if ((tag.corners[c] - old.corners[c]).norm() > still_px) return false;
      }
  return same > 0;
}

/// Returns the name of the part of the image with the fewest tags in the views.
std::string uncovered_part(std::span<const LensView> views) {
  std::array<std::array<int, 3>, 3> seen{};
  for (const LensView& view : views)
    for (const DetectedTag& tag : view.tags) {
      const auto third = [](double at, int side) {
        return static_cast<std::size_t>(std::clamp(static_cast<int>(3 * at / side), 0, 2));
      };
      ++seen[third(tag.corners[0].y(), view.picture.height)][third(tag.corners[0].x(), view.picture.width)];
    }
  constexpr std::array<std::array<const char*, 3>, 3> names = {
      {{"upper left", "upper middle", "upper right"},
       {"left", "middle", "right"},
       {"lower left", "lower middle", "lower right"}}};
  std::size_t row = 1, column = 1;
  for (std::size_t y = 0; y < 3; ++y)
    for (std::size_t x = 0; x < 3; ++x)
      if (seen[y][x] < seen[row][column]) {
        row = y;
        column = x;
      }
  return names[row][column];
}

}  // namespace

LensGuide::LensGuide(Board board) : board_(std::move(board)), finder_(TagDetectorSettings{1}) {
  if (board_.tags.empty())
    throw InputError(fmt::format("board {}: has no tags, but the camera calibration needs a board with tags",
                                 board_.name));
}

LensGuide::BoardAppearance LensGuide::look_of(const std::vector<DetectedTag>& tags, int width) const {
  // Compares opposite sides of each tag: the nearer side is longer.
  BoardAppearance look{Vec2::Zero(), Vec2::Zero(), 0};
  Eigen::AlignedBox2d box;
  for (const DetectedTag& tag : tags) {
    for (const Vec2& corner : tag.corners) box.extend(corner);
    const auto side = [&](std::size_t a, std::size_t b) { return (tag.corners[a] - tag.corners[b]).norm(); };
    look.lean += Vec2(std::log(side(1, 2) / side(0, 3)), std::log(side(0, 1) / side(3, 2)));
    // A tilt foreshortens the sides perpendicular to its axis.
    look.lean += Vec2(0.5, 0.5) * std::log((side(0, 1) + side(3, 2)) / (side(1, 2) + side(0, 3)));
  }
  look.lean /= static_cast<double>(tags.size());
  look.middle = box.center() / width;
  look.size = box.sizes().maxCoeff() / width;
  return look;
}

bool LensGuide::differs(const BoardAppearance& a, const BoardAppearance& b) {
  return (a.middle - b.middle).norm() > new_middle || (a.lean - b.lean).norm() > new_lean ||
         std::abs(std::log(a.size / b.size)) > new_size;
}

void LensGuide::take(const Image& picture) {
  resting_.reset();
  if (!views_.empty() &&
      (views_.front().picture.width != picture.width || views_.front().picture.height != picture.height)) {
    problem_ = "the camera's image size has changed: start the calibration again";
    return;
  }
  LensView view{grey_of(picture), {}};
  view.tags = finder_.find(view.picture);
  std::erase_if(view.tags, [&](const DetectedTag& tag) { return board_.find(tag.code) == nullptr; });
  const std::vector<DetectedTag> before = std::exchange(last_, view.tags);
  if (static_cast<double>(view.tags.size()) < least_share * static_cast<double>(board_.tags.size())) {
    problem_ = view.tags.empty() ? "show the camera the board" : "show more of the board";
    return;
  }
  const BoardAppearance look = look_of(view.tags, picture.width);
  if (look.size < least_size) {
    problem_ = "hold the board nearer";
  } else if (!is_at_rest(before, view.tags)) {
    problem_ = "hold it still";
  } else {
    problem_.clear();
    if (std::none_of(looks_.begin(), looks_.end(),
                     [&](const BoardAppearance& old) { return !differs(look, old); })) {
      looks_.push_back(look);
      views_.push_back(view);
    }
    resting_ = std::move(view);
  }
}

LensGuideStep LensGuide::step() const {
  LensGuideStep step;
  step.views = views_.size();
  step.covered = covered_share(views_);
  step.seen = last_;
  step.done = step.views >= recommended_views && step.covered >= enough_covered;
  if (step.done)
    step.instruction = "that is enough";
  else if (!problem_.empty())
    step.instruction = problem_;
  else
    // Every other view asks for a tilt, because untilted views don't determine the focal length.
    step.instruction = step.views % 2 == 1
                           ? "tilt the board, each time in another direction"
                           : fmt::format("move the board to the image's {}", uncovered_part(views_));
  return step;
}

}  // namespace prosector
