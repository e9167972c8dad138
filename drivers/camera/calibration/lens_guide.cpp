#include "drivers/camera/calibration/lens_guide.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "common/error.h"

namespace prosector {
namespace {

constexpr double least_share = 0.5;                // of the board's tags that must be seen
constexpr double still_px = 0.7;                   // that corners may move from picture to picture
constexpr double new_middle = 0.08;                // of the picture's width …
constexpr double new_lean = 0.04, new_size = 0.1;  // … that make a view a new one
constexpr double least_size = 0.2;                 // of the picture's width: what is smaller is too far

/// Tells whether the tags rest from picture to picture.
bool rests(const std::vector<SeenTag>& before, const std::vector<SeenTag>& now) {
  int same = 0;
  for (const SeenTag& tag : now)
    for (const SeenTag& old : before)
      if (old.code == tag.code) {
        ++same;
        for (std::size_t c = 0; c < tag.corners.size(); ++c)
          if ((tag.corners[c] - old.corners[c]).norm() > still_px) return false;
      }
  return same > 0;
}

/// Returns the words for the part of the picture that no view has covered.
std::string uncovered_part(std::span<const LensView> views) {
  std::array<std::array<int, 3>, 3> seen{};
  for (const LensView& view : views)
    for (const SeenTag& tag : view.tags) {
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

LensGuide::LensGuide(Board board) : board_(std::move(board)), finder_(TagFinderSettings{1}) {
  if (board_.tags.empty())
    throw InputError(fmt::format("board {}: has no tags, which calibration needs", board_.name));
}

LensGuide::Look LensGuide::look_of(const std::vector<SeenTag>& tags, int width) const {
  // Sides of tags: a side that is nearer is longer.
  Look look{Vec2::Zero(), Vec2::Zero(), 0};
  Eigen::AlignedBox2d box;
  for (const SeenTag& tag : tags) {
    for (const Vec2& corner : tag.corners) box.extend(corner);
    const auto side = [&](std::size_t a, std::size_t b) { return (tag.corners[a] - tag.corners[b]).norm(); };
    look.lean += Vec2(std::log(side(1, 2) / side(0, 3)), std::log(side(0, 1) / side(3, 2)));
    // Tilt shortens what stands across it.
    look.lean += Vec2(0.5, 0.5) * std::log((side(0, 1) + side(3, 2)) / (side(1, 2) + side(0, 3)));
  }
  look.lean /= static_cast<double>(tags.size());
  look.middle = box.center() / width;
  look.size = box.sizes().maxCoeff() / width;
  return look;
}

bool LensGuide::differs(const Look& a, const Look& b) {
  return (a.middle - b.middle).norm() > new_middle || (a.lean - b.lean).norm() > new_lean ||
         std::abs(std::log(a.size / b.size)) > new_size;
}

void LensGuide::take(const Image& picture) {
  resting_.reset();
  if (!views_.empty() &&
      (views_.front().picture.width != picture.width || views_.front().picture.height != picture.height)) {
    trouble_ = "the pictures' size has changed: start again";
    return;
  }
  LensView view{grey_of(picture), {}};
  view.tags = finder_.find(view.picture);
  std::erase_if(view.tags, [&](const SeenTag& tag) { return board_.find(tag.code) == nullptr; });
  const std::vector<SeenTag> before = std::exchange(last_, view.tags);
  if (static_cast<double>(view.tags.size()) < least_share * static_cast<double>(board_.tags.size())) {
    trouble_ = view.tags.empty() ? "show the camera the board" : "show more of the board";
    return;
  }
  const Look look = look_of(view.tags, picture.width);
  if (look.size < least_size) {
    trouble_ = "hold the board nearer";
  } else if (!rests(before, view.tags)) {
    trouble_ = "hold it still";
  } else {
    trouble_.clear();
    if (std::none_of(looks_.begin(), looks_.end(), [&](const Look& old) { return !differs(look, old); })) {
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
  step.done = step.views >= usual_views && step.covered >= enough_covered;
  if (step.done)
    step.instruction = "that is enough";
  else if (!trouble_.empty())
    step.instruction = trouble_;
  else
    // Every other view asks for a tilt: without tilts no view tells the focal length.
    step.instruction = step.views % 2 == 1
                           ? "tilt the board, each time another way"
                           : fmt::format("move the board to the picture's {}", uncovered_part(views_));
  return step;
}

}  // namespace prosector
