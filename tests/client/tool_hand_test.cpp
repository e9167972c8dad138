// A tracked instrument that is a blade of the scene: it is fetched, brought, led, and rests where it was
// lost.

#include "client/app/user/tool_hand.h"

#include <gtest/gtest.h>

#include <vector>

namespace prosector {
namespace {

constexpr std::int64_t step_ns = 16'000'000, ns_of_second = 1'000'000'000;

/// A session of one scalpel that lies on a table, and a hand that goes where it is told to.
class Wielded {
 public:
  Wielded() {
    tool.body = 3;
    tool.pose = {Vec3(0.3, 0.908, 0.06), Quat(Eigen::AngleAxisd(0.4, Vec3::UnitY()))};
    tool.blade = {Vec3(-0.0035, 0, -0.1), -Vec3::UnitZ(), -Vec3::UnitX(), 0.04};
  }

  ToolState tool;
  ToolHand hand;
  int wishes = 0;
  std::vector<Vec3> tips;  // of the blade, while it is held

  void show(const std::optional<Pose>& instrument, double seconds) {
    const auto steps = static_cast<std::int64_t>(seconds * ns_of_second) / step_ns;
    for (std::int64_t k = 0; k < steps; ++k) show_once(instrument);
  }
  BladeFrame blade() const { return tool.pose * tool.blade; }

 private:
  std::int64_t now_ns_ = 7 * ns_of_second;

  void show_once(const std::optional<Pose>& instrument) {
    const HandPose followed = hand.follow(tool, instrument, now_ns_ += step_ns);
    if (!followed.tracked) {
      tool.wrist.reset();
      tool.is_held = false;
      return;
    }
    if (tool.is_held) tool.pose = followed.pose * tool.wrist->inverse() * tool.pose;
    tool.wrist = followed.pose;
    if (tool.is_held) tips.push_back(blade().tip);
    const auto wish = hand.take_command();
    if (!wish) return;
    ++wishes;
    std::holds_alternative<Release>(*wish) ? tool.is_hindered = false : tool.is_held = true;
  }
};

Pose leant(const Vec3& tip, double angle) {
  return {tip, Quat(Eigen::AngleAxisd(angle, Vec3(1, 0.3, -0.2).normalized()))};
}

TEST(ToolHand, IsNoneUntilTheInstrumentIsSeen) {
  Wielded user;
  user.show(std::nullopt, 1);
  EXPECT_FALSE(user.hand.leads());
  EXPECT_EQ(user.wishes, 0);
}

TEST(ToolHand, BringsTheTipToTheInstrumentsAndGoesWithIt) {
  Wielded user;
  const Pose first = leant({-0.1, 1.02, -0.05}, -1);
  user.show(first, 3);
  EXPECT_EQ(user.wishes, 1);
  EXPECT_LT((user.blade().tip - first.p).norm(), 1e-9);
  EXPECT_LT((user.blade().along + first.q * Vec3::UnitZ()).norm(), 1e-9) << "the shaft is the instrument's";
  EXPECT_LT((user.blade().ahead + first.q * Vec3::UnitY()).norm(), 1e-9) << "the edge looks along its -y";
  const Pose next = leant({-0.06, 1.0, -0.05}, -1.2);
  user.show(next, 0.02);
  EXPECT_LT((user.blade().tip - next.p).norm(), 1e-9) << "at once";
}

TEST(ToolHand, PassesOverWhatLiesBetween) {
  Wielded user;
  const Vec3 to = {-0.1, 1.02, -0.05};
  user.show(leant(to, -1), 3);
  std::size_t between = 0;
  for (const Vec3& tip : user.tips) {
    if (tip.x() > 0.2 || tip.x() < to.x() + 0.021) continue;
    ++between;
    EXPECT_GT(tip.y(), to.y() + 0.1);
  }
  EXPECT_GT(between, 10u);
}

TEST(ToolHand, AsksAgainUntilItHolds) {
  Wielded user;
  std::int64_t now = 7 * ns_of_second;
  int wishes = 0;
  for (int k = 0; k < 125; ++k) {
    const HandPose followed = user.hand.follow(user.tool, leant({0, 1, 0}, 0), now += step_ns);
    user.tool.wrist = followed.pose;
    const auto wish = user.hand.take_command();
    wishes += wish && std::get<Grasp>(*wish).body == user.tool.body;
  }
  EXPECT_GE(wishes, 3);
  EXPECT_LE(wishes, 5) << "twice a second";
}

TEST(ToolHand, LetsGoFirstWhereItHoldsSomethingElse) {
  Wielded user;
  const Pose at = {Vec3(-0.2, 1.05, 0.1), Quat::Identity()};
  user.tool.wrist = at;
  user.tool.is_hindered = true;
  user.show(leant({-0.1, 1.02, -0.05}, -1), 0.02);
  EXPECT_FALSE(user.tool.is_hindered);
  EXPECT_LT((user.tool.wrist->p - at.p).norm(), 1e-9) << "where it is";
  user.show(leant({-0.1, 1.02, -0.05}, -1), 3);
  EXPECT_TRUE(user.tool.is_held);
  EXPECT_EQ(user.wishes, 2);
}

TEST(ToolHand, RestsWhereTheInstrumentWasLostThenLetsGo) {
  Wielded user;
  const Pose at = leant({-0.1, 1.02, -0.05}, -1);
  user.show(at, 3);
  user.show(std::nullopt, 4);
  EXPECT_TRUE(user.hand.leads());
  EXPECT_LT((user.blade().tip - at.p).norm(), 1e-9);
  user.show(std::nullopt, 1.5);
  EXPECT_FALSE(user.hand.leads());
  EXPECT_FALSE(user.tool.wrist.has_value());
}

TEST(ToolHand, IsBroughtAnewWhereTheInstrumentComesBackElsewhere) {
  Wielded user;
  user.show(leant({-0.1, 1.02, -0.05}, -1), 3);
  user.show(std::nullopt, 1);
  user.tips.clear();
  const Pose back = leant({0.1, 1.02, -0.05}, -1);
  user.show(back, 2);
  double highest = 0, fastest = 0;
  for (std::size_t k = 1; k < user.tips.size(); ++k) {
    highest = std::max(highest, user.tips[k].y());
    fastest = std::max(fastest, (user.tips[k] - user.tips[k - 1]).norm());
  }
  EXPECT_GT(highest, 1.13);
  EXPECT_LT(fastest, 0.02) << "m a step";
  EXPECT_LT((user.blade().tip - back.p).norm(), 1e-9);
}

}  // namespace
}  // namespace prosector
