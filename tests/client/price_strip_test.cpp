// The strip of prices below a panel: where its cells are, what they say, and the curve over them.

#include "client/view/price_strip.h"

#include <gtest/gtest.h>

namespace prosector {
namespace {

const std::vector<Price> prices = {{0.3, 0.81}, {0.07, 4.12}, {0.012, 22.4}};

Panel rotated_panel() {
  Panel panel;
  panel.open = true;
  panel.pose = {{0.2, 1.3, -0.1}, Quat(Eigen::AngleAxisd(0.7, Vec3::UnitY()))};
  return panel;
}

Ray straight_at(const Panel& panel, const Vec3& place) {
  return {panel.pose * (place + Vec3(0, 0, 0.5)), panel.pose.q * -Vec3::UnitZ()};
}

TEST(PriceStrip, IsMetWhereItsCellsAre) {
  const Panel panel = rotated_panel();
  for (std::size_t cells : {1u, 3u, static_cast<unsigned>(max_configuration_costs)})
    for (std::size_t cell = 0; cell < cells; ++cell)
      EXPECT_EQ(picked_price_cell(straight_at(panel, price_cell_centre(cell, cells)), panel, cells), cell)
          << cells;
  EXPECT_EQ(picked_price_cell(straight_at(panel, price_cell_centre(0, 1)), panel, 0), 0u) << "the question";
  for (const Vec3& beside : {Vec3(0, strip_y, 0), Vec3(0, 0, 0), Vec3(panel_width, price_strip_y, 0),
                             Vec3(0, price_strip_y - price_strip_height, 0)})
    EXPECT_FALSE(picked_price_cell(straight_at(panel, beside), panel, 3)) << beside.transpose();
  Ray behind = straight_at(panel, price_cell_centre(1, 3));
  behind.from = panel.pose * (price_cell_centre(1, 3) - Vec3(0, 0, 0.5));
  behind.along = -behind.along;
  EXPECT_FALSE(picked_price_cell(behind, panel, 3));
}

TEST(PriceStrip, DoesNotCoverTheEffortStrip) {
  EXPECT_LT(price_strip_y + price_strip_height / 2, strip_y - strip_height / 2);
}

TEST(PriceStrip, CurveFallsAsErrorsDoWithinTheStrip) {
  const std::vector<Vec3> curve = price_curve(prices);
  ASSERT_EQ(curve.size(), prices.size());
  for (std::size_t k = 0; k < curve.size(); ++k) {
    EXPECT_NEAR(curve[k].x(), price_cell_centre(k, prices.size()).x(), 1e-12);
    EXPECT_LT(std::abs(curve[k].y() - price_strip_y), price_strip_height / 2);
    if (k == 0) continue;
    EXPECT_LT(curve[k].y(), curve[k - 1].y());
  }
  EXPECT_TRUE(price_curve({}).empty());
}

TEST(PriceStrip, SaysWhatACellIsAndAsksForItAgain) {
  EXPECT_EQ(in_words(prices[1]), "7 %\n4.1 ms");
  EXPECT_GT(accuracy_of(prices[1]), 7);
  EXPECT_LT(accuracy_of(prices[1]), 7.1);
  EXPECT_EQ(accuracy_of({5, 1}), max_accuracy);
}

}  // namespace
}  // namespace prosector
