// The list of parts on a board in the room, worked by a fingertip.

#include "client/app/desk/parts_board.h"

#include <gtest/gtest.h>

#include "common/index_tip.h"

namespace prosector {
namespace {

using Kind = PartsOrder::Kind;

class AFingerAtTheBoard : public testing::Test {
 protected:
  PartsBoard board;
  const Pose eyes{{0.1, 1.5, 0.6}, Quat(Eigen::AngleAxisd(0.3, Vec3::UnitY()))};
  static constexpr std::size_t parts = 40;
  PartsChoice choice;

  void SetUp() override {
    board.toggle_open(eyes, right_hand);
    board.follow(rows(), {});
  }
  std::vector<PartRow> rows() const {
    std::vector<PartRow> out;
    for (std::size_t k = 0; k < parts; ++k) {
      PartRow row;
      row.text = "part " + std::to_string(k);
      row.parts = {row.text};
      row.bodies = {static_cast<BodyId>(k)};
      row.color = Vec3::Constant(0.5);
      out.push_back(row);
    }
    return out;
  }
  Pose pose() const { return board.shown()->pose; }
  const PartsList& list() const { return *board.shown()->list; }
  /// Brings a hand's index fingertip to a point of the list, so far before the board, m.
  void bring(const Eigen::Vector2d& point, double before, double bent = 0, std::size_t side = right_hand) {
    HandInput user;
    HandPose& hand = user.hands[side];
    hand.tracked = true;
    hand.flexion[1] = bent;
    const Vec3 from_wrist = index_tip(side, hand);
    const Eigen::Vector2d off = board_metres_per_point * (point - parts_board_picture / 2);
    hand.pose = pose() * Pose{Vec3(off.x(), -off.y(), before) - from_wrist, Quat::Identity()};
    board.follow(rows(), user);
  }
  void touch(const Eigen::Vector2d& point) {
    for (const double before : {0.04, 0.02, 0.002, -0.004, 0.004, 0.02}) bring(point, before);
  }
  Eigen::Vector2d at(std::size_t line, double from_right) const {
    return {list().board.max().x() - from_right, list().lines[line].top + 10};
  }
};

TEST_F(AFingerAtTheBoard, ItComesUpInReachFacingTheEyesBesideWhereTheyLook) {
  const Vec3 towards = (eyes.p - pose().p).normalized();
  EXPECT_GT((pose().q * Vec3::UnitZ()).dot(towards), 0.999);
  EXPECT_NEAR((pose().q * Vec3::UnitX()).y(), 0, 1e-12) << "level";
  EXPECT_LT((eyes.p - pose().p).norm(), 0.6);
  EXPECT_LT((eyes.inverse() * pose().p).x(), -0.1) << "the right hand's is at the left";
  board.toggle_open(eyes, right_hand);
  EXPECT_FALSE(board.shown());
  board.toggle_open(eyes, left_hand);
  board.follow(rows(), {});
  EXPECT_GT((eyes.inverse() * pose().p).x(), 0.1);
  for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(-Vec3::UnitX())}) {  // straight up, straight down
    board.toggle_open(eyes, right_hand);
    board.toggle_open({eyes.p, Quat(Eigen::AngleAxisd(1.5707963267948966, axis))}, right_hand);
    board.follow(rows(), {});
    ASSERT_TRUE(is_finite(pose()));
    EXPECT_LT((eyes.p - pose().p).norm(), 0.6);
  }
}

TEST_F(AFingerAtTheBoard, PressesAnEyeARingAndAColourOnce) {
  touch(at(2, 91));
  touch(at(3, 69));
  std::vector<PartsOrder> orders = board.take_orders();
  ASSERT_EQ(orders.size(), 2u);
  EXPECT_EQ(orders[0].kind, Kind::hide);
  EXPECT_EQ(orders[0].parts, std::vector<std::string>{"part 2"});
  EXPECT_EQ(orders[1].kind, Kind::isolate_next);
  touch({list().board.min().x() + 14, list().lines[1].top + 10});
  ASSERT_TRUE(list().state.palette);
  bring({0, 0}, 0.3);
  touch({list().board.min().x() + 26 + 26 + 10, list().lines[2].top + 10});
  orders = board.take_orders();
  ASSERT_EQ(orders.size(), 1u);
  EXPECT_EQ(orders[0].kind, Kind::color);
  EXPECT_EQ(orders[0].parts, std::vector<std::string>{"part 1"});
}

TEST_F(AFingerAtTheBoard, SlidesOpacity) {
  bring(at(4, 10), 0.02);
  bring(at(4, 10), 0.0);
  for (int k = 0; k <= 20; ++k) bring(at(4, 10 + 22 * k / 20.0), 0.0);
  bring(at(4, 32), 0.03);
  const std::vector<PartsOrder> orders = board.take_orders();
  ASSERT_GT(orders.size(), 5u);
  EXPECT_EQ(orders.back().kind, Kind::opacity);
  EXPECT_EQ(orders.back().parts, std::vector<std::string>{"part 4"});
  EXPECT_NEAR(orders.back().opacity, 0.5, 0.03);
}

TEST_F(AFingerAtTheBoard, DrawnAlongNamesItScrollsAndAsksForNothing) {
  const Eigen::Vector2d name(list().board.min().x() + 100, list().lines[6].top + 10);
  bring(name, 0.02);
  for (int k = 0; k <= 30; ++k) bring(name - Eigen::Vector2d(0, 2.1 * k), 0.0);
  bring(name, 0.03);
  EXPECT_EQ(list().state.first, 3u) << "63 points up: three lines on";
  bring(name, 0.03);
  EXPECT_EQ(list().state.first, 3u) << "nothing is pressed any more";
  EXPECT_TRUE(board.take_orders().empty());
  EXPECT_EQ(board.hovered_bodies().size(), 1u) << "the row that it is at";
}

TEST_F(AFingerAtTheBoard, PressesNothingBentOrFromBehindOrBeside) {
  for (const double before : {0.04, 0.002, -0.004, 0.02}) bring(at(2, 91), before, 0.8);
  for (const double before : {-0.3, -0.03, -0.01, 0.0, 0.03}) bring(at(2, 91), before);
  bring({0, 0}, 0.3);
  for (const double before : {0.04, 0.002, -0.004, 0.02}) bring(at(2, -30), before);
  EXPECT_TRUE(board.take_orders().empty());
}

TEST_F(AFingerAtTheBoard, IsDrawnAsOneMeshInItsOwnColoursWithTextsOnIt) {
  DrawList out;
  PartsBoardView(7).add(out, *board.shown());
  ASSERT_EQ(out.items.size(), 1u);
  ASSERT_GT(out.texts.size(), 15u);
  const DrawMesh& mesh = *out.items[0].mesh;
  EXPECT_TRUE(out.items[0].painted);
  ASSERT_EQ(mesh.rest_positions.size(), mesh.positions.size()) << "a colour each";
  float nearest = 0;
  for (const Eigen::Vector3f& at : mesh.positions) {
    EXPECT_LT(std::abs(at.x()), 0.14);
    EXPECT_LT(std::abs(at.y()), 0.19);
    EXPECT_LT(std::abs(at.z()), 0.01);
    nearest = std::max(nearest, at.z());
  }
  const Pose into = pose().inverse();
  for (const DrawText& text : out.texts) {
    ASSERT_TRUE(text.surface);
    EXPECT_FALSE(text.overlay);
    EXPECT_LT(text.height, 0.02) << "m";
    EXPECT_GT((into * text.surface->p).z(), nearest);
  }
}

TEST_F(AFingerAtTheBoard, FacesTheReaderWithAllButItsSidesAndItsBack) {
  DrawList out;
  PartsBoardView(7).add(out, *board.shown());
  const DrawMesh& mesh = *out.items[0].mesh;
  std::size_t front = 0, back = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3f& from = mesh.positions[a];
    const float turned = (mesh.positions[b] - from).cross(mesh.positions[c] - from).z();
    if (from.z() < 0) {
      EXPECT_LE(turned, 1e-12F) << "what is behind is the back";
      ++back;
    } else {
      EXPECT_GE(turned, -1e-12F);
      ++front;
    }
  }
  EXPECT_GT(back, 10u);
  EXPECT_GT(front, 20 * back);
}

TEST_F(AFingerAtTheBoard, ItsMeshChangesOnlyWithWhatItShows) {
  PartsBoardView view(7);
  const auto revision = [&] {
    DrawList out;
    view.add(out, *board.shown());
    return out.items[0].mesh->revision;
  };
  const std::uint64_t before = revision();
  EXPECT_EQ(revision(), before);
  for (int k = 0; k < 2; ++k) bring(at(2, 91), 0.02);
  EXPECT_GT(revision(), before) << "the row that a finger is at is bright";
}

TEST_F(AFingerAtTheBoard, ItsRingsAreRound) {
  DrawList out;
  PartsBoardView(7).add(out, *board.shown());
  const Eigen::Vector2d middle(list().board.max().x() - 69, list().lines[2].top + 10);  // of a row's ring
  std::vector<double> distances;
  for (const Eigen::Vector3f& at : out.items[0].mesh->positions)
    if (const double off = (board_point(at.cast<double>()) - middle).norm(); off > 3 && off < 9 && at.z() > 0)
      distances.push_back(off);
  ASSERT_GT(distances.size(), 20u);
  for (const double distance : distances) EXPECT_NEAR(distance, distance > 5.2 ? 6 : 4.5, 0.02) << "points";
}

TEST_F(AFingerAtTheBoard, ItOffersNothingThatNeedsKeys) {
  DrawList out;
  PartsBoardView(7).add(out, *board.shown());
  for (const DrawText& text : out.texts) EXPECT_NE(text.text, "search");
  EXPECT_EQ(describe_spot(list(), {PartsSpot::Kind::search, 0, 0}), "");
  EXPECT_EQ(describe_spot(list(), {PartsSpot::Kind::name, 2, 0}), "drag along the names to scroll");
}

}  // namespace
}  // namespace prosector
