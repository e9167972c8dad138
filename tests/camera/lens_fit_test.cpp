#include <gtest/gtest.h>

#include <algorithm>

#include "common/error.h"
#include "drivers/camera/calibration/lens_guide.h"
#include "drivers/camera/tags/standard_boards.h"
#include "tests/camera/tag_cases.h"

namespace prosector {
namespace {

/// Views of the calibration board, as a person holds it before a camera: near, tilted, towards all sides.
std::vector<LensView> views_of(const Lens& lens, double response, int count, double nearest = 0.3) {
  Random random(5);
  const Board board = find_board("calibration");
  const TagDetector finder({1});
  std::vector<LensView> views;
  for (int k = 0; k < count; ++k) {
    SyntheticScene scene = usual_scene(lens);
    scene.sensor.response = response;
    scene.sensor.seed = static_cast<unsigned>(k + 1);
    Carrier carrier;
    const double distance = random.uniform(nearest, 1.5 * nearest);
    carrier.pose = board_before_camera(random, distance, 0.15, 0.7);
    carrier.pose.p.x() = random.uniform(-0.2, 0.2) * distance;
    carrier.pose.p.y() = random.uniform(-0.15, 0.15) * distance;
    scene.add_board(board, carrier);
    LensView view{grey_of(SceneRenderer(scene).paint(0)), {}};
    view.tags = finder.find(view.picture);
    views.push_back(std::move(view));
  }
  return views;
}

/// How far both lenses map directions apart, over what the true one sees, but for the turn that no view
/// tells.
std::vector<double> mapping_errors(const Lens& truth, const Lens& found) {
  std::vector<double> out;
  for (int y = 10; y < truth.height; y += 20)
    for (int x = 10; x < truth.width; x += 20)
      out.push_back((found.project(truth.ray({x, y})) - Vec2(x, y)).norm());
  return out;
}

class LensResponse : public testing::TestWithParam<double> {};

TEST_P(LensResponse, LensIsFoundToATenthOfAPixel) {
  const Lens truth = usual_lens();
  const auto views = views_of(truth, GetParam(), recommended_views);
  const LensFit fit = fit_lens(find_board("calibration"), views, "synthetic");
  const std::vector<double> errors = mapping_errors(truth, fit.calibration.lens);
  double mean = 0;
  for (const double e : errors) mean += e / static_cast<double>(errors.size());
  EXPECT_LE(mean, 0.11);
  EXPECT_NEAR(fit.calibration.response, GetParam(), 0.15);
  EXPECT_LT(fit.held_out, 0.15);
}

INSTANTIATE_TEST_SUITE_P(Table, LensResponse, testing::Values(1.4, 2.2));

// Of such pictures the edges of few tags can be fitted, or of none.
TEST(LensFit, IsFoundInSmallPicturesToo) {
  const Lens truth = usual_lens().scaled(320, 240);
  std::vector<LensView> views = views_of(truth, 2.2, recommended_views, 0.5);
  for (const bool by_edges : {true, false}) {
    if (!by_edges) {
      views = views_of(truth, 2.2, recommended_views, 0.35);
      for (LensView& view : views)
        std::fill(view.picture.grey.begin(), view.picture.grey.end(), std::uint8_t{128});
    }
    const LensFit fit = fit_lens(find_board("calibration"), views, "synthetic");
    EXPECT_EQ(fit.by_edges, by_edges);
    EXPECT_LT(fit.held_out, 0.6);
    EXPECT_NEAR(fit.calibration.lens.fx / truth.fx, 1, 0.02);
    EXPECT_NEAR(fit.calibration.lens.fy / truth.fy, 1, 0.02);
    double mean = 0;
    const std::vector<double> errors = mapping_errors(truth, fit.calibration.lens);
    for (const double e : errors) mean += e / static_cast<double>(errors.size());
    EXPECT_LT(mean, by_edges ? 0.6 : 1) << "pixels";
  }
}

std::string complaint_of(const std::vector<LensView>& views) {
  try {
    (void)fit_lens(find_board("calibration"), views, "synthetic");
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(LensFit, SaysWhyItCannot) {
  EXPECT_NE(complaint_of({}).find("at least 6 views"), std::string::npos);
  const std::vector<LensView> blank(8, LensView{{640, 480, std::vector<std::uint8_t>(640 * 480)}, {}});
  EXPECT_NE(complaint_of(blank).find("at least 4 tags"), std::string::npos);
  std::vector<LensView> jumbled = views_of(usual_lens(), 2.2, 6);
  for (LensView& view : jumbled)
    for (DetectedTag& tag : view.tags) std::swap(tag.corners[0], tag.corners[2]);
  EXPECT_NE(complaint_of(jumbled).find("not consistent with one lens"), std::string::npos);
}

// A person who shows the board as they are told gets all views; one who holds it where it was gets no
// further.
TEST(LensGuide, KeepsViewsThatAreNewAndAtRest) {
  const std::vector<LensView> views = views_of(usual_lens(), 2.2, recommended_views);
  LensGuide guide(find_board("calibration"));
  EXPECT_EQ(guide.step().views, 0u);
  const auto show = [&](const LensView& view) {
    Image image{view.picture.width, view.picture.height, {}};
    for (const std::uint8_t grey : view.picture.grey) image.rgb.insert(image.rgb.end(), 3, grey);
    guide.take(image);
  };
  show(views[0]);
  EXPECT_EQ(guide.step().views, 0u) << "the first picture of a board that may move";
  for (int k = 0; k < 3; ++k) show(views[0]);
  EXPECT_EQ(guide.step().views, 1u);
  for (const LensView& view : views)
    for (int k = 0; k < 2; ++k) show(view);
  EXPECT_GE(guide.step().views, recommended_views - 2);
  EXPECT_GT(guide.step().covered, LensGuide::enough_covered);
  guide.take(Image{64, 48, std::vector<std::uint8_t>(64 * 48 * 3)});
  EXPECT_NE(guide.step().instruction.find("size has changed"), std::string::npos);
}

}  // namespace
}  // namespace prosector
