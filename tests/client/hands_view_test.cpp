// How hands and people are seen.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <thread>
#include <utility>

#include "client/view/scene_view.h"
#include "common/panel.h"
#include "tests/client/told_client.h"

namespace prosector {
namespace {

using namespace test;

std::vector<std::pair<Vec3, double>> hands_of(const DrawList& list) {
  std::vector<std::pair<Vec3, double>> out;
  for (const DrawItem& item : list.items)
    if (item.appearance.surface == Surface::skin) out.emplace_back(item.pose.p, item.opacity);
  return out;
}

TEST(SceneView, ADeskUsersHandIsWherePhysicsHasItWithAGhostWhereItIsWanted) {
  Client client;
  client.join();
  LocalUser self;
  self.participant = 7;
  self.present = self.at_desk = true;
  HandPose& target = self.input.hands[right_hand];
  target.tracked = true;
  target.pose.p = {0, 1.5, 0.18};
  UserState user;
  user.participant = self.participant;
  user.hands[right_hand] = target;
  client.tell(user);
  ViewSettings settings = plain(320, 240);
  settings.eye = look_at({1, 1.6, 0.2}, {0, 1.4, 0});
  while (hands_of(client.list(1, settings, self)).empty())  // the skin is on its way
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(hands_of(client.list(1, settings, self)).size(), 1u) << "they agree: no ghost";
  target.pose.p = {0, 1.3, 0.18};  // physics holds it up
  const auto hands = hands_of(client.list(1, settings, self));
  ASSERT_EQ(hands.size(), 2u);
  EXPECT_LT((hands[0].first - Vec3(0, 1.5, 0.18)).norm(), 1e-6);
  EXPECT_LT((hands[1].first - target.pose.p).norm(), 1e-6);
  EXPECT_LT(hands[1].second, 0.5) << "pale";
}

/// Who moves a hand with the mouse has none before the camera: theirs is drawn.
TEST(SceneView, ThroughACameraOnlyTrackedHandsAreReal) {
  Client client;
  client.join();
  LocalUser self;
  self.participant = 7;
  self.present = true;
  self.input.hands[right_hand].tracked = true;
  self.input.hands[right_hand].pose.p = {0, 1.5, 0.18};
  UserState user;
  user.participant = self.participant;
  user.hands = self.input.hands;
  client.tell(user);
  ViewSettings settings = plain(320, 240);
  CameraOverlay& through = settings.projection.emplace<CameraOverlay>();
  through.is_placed = true;
  through.camera = mono_camera(look_at({1, 1.6, 0.2}, {0, 1.4, 0}), 0.8, 320, 240);
  const auto real_items = [&] {
    return std::ranges::count(client.list(1, settings, self).items, ItemRole::real, &DrawItem::showing);
  };
  while (real_items() == 0)  // the skin is on its way
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(real_items(), 2) << "skin and nails";
  // An uncovered hand has its fingers bent as the tracker reports.
  const auto length = [&] {
    float least = 0;
    for (const DrawItem& item : client.list(1, settings, self).items)
      if (item.showing == ItemRole::real)
        for (const Eigen::Vector3f& x : item.mesh->positions) least = std::min(least, x.z());
    return -least;
  };
  const float stretched = length();
  self.input.hands[right_hand].flexion.fill(1);
  EXPECT_LT(length(), 0.75F * stretched);
  self.at_desk = true;
  EXPECT_EQ(real_items(), 0);
  EXPECT_FALSE(hands_of(client.list(1, settings, self)).empty());
}

/// Returns how opaque sleeves are, and shoulders where they are drawn.
std::vector<double> cloth_of(const DrawList& list) {
  std::vector<double> out;
  for (const DrawItem& item : list.items)
    if (item.appearance.surface == Surface::cloth) out.push_back(item.opacity);
  return out;
}

/// Tells the client of Ada, whose head and right hand are tracked. Returns her state.
UserState tell_of_ada(Client& client) {
  const RosterEntry ada = ada_entry();
  client.tell(ada);
  UserState user;
  user.participant = ada.participant;
  user.head_tracked = true;
  user.head = look_at({0.4, 1.5, 0.3}, {0, 1.1, 0});
  user.hands[right_hand].tracked = true;
  user.hands[right_hand].pose.p = {0.1, 1.2, 0.1};
  client.tell(user);
  return user;
}

TEST(SceneView, APersonIsSeenWholeOrNotYet) {
  Client client;
  client.join();
  tell_of_ada(client);
  ViewSettings settings = plain(320, 240);
  settings.eye = look_at({1, 1.6, 0.2}, {0, 1.4, 0});
  for (bool is_seen = false; !is_seen;) {
    const DrawList& list = client.list(1, settings);
    is_seen = !cloth_of(list).empty();
    ASSERT_EQ(!hands_of(list).empty(), is_seen) << "a hand without a sleeve, or a sleeve without a hand";
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST(SceneView, SleevesAreSeenThroughByWhomTheyBelongTo) {
  Client client;
  client.join();
  const UserState user = tell_of_ada(client);
  ViewSettings settings = plain(320, 240);
  LocalUser ada_herself;
  ada_herself.participant = user.participant;
  ada_herself.present = true;
  ada_herself.input.head_tracked = true;
  ada_herself.input.head = user.head;
  ada_herself.input.hands = user.hands;
  while (cloth_of(client.list(1, settings, ada_herself)).empty())  // her figure is on its way
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  const auto seen_through = [](double opacity) { return opacity < 0.5; };
  const auto solid = [](double opacity) { return opacity == 1; };
  EXPECT_TRUE(std::ranges::all_of(cloth_of(client.list(1, settings, ada_herself)), seen_through));
  EXPECT_TRUE(std::ranges::all_of(cloth_of(client.list(1, settings)), solid)) << "somebody else's eyes";
  ViewSettings outside = settings;
  outside.eye = look_at({1, 1.6, 0.2}, {0, 1.4, 0});
  EXPECT_TRUE(std::ranges::all_of(cloth_of(client.list(1, outside, ada_herself)), solid)) << "from outside";
  settings.follow = "ada";
  const auto followed = cloth_of(client.list(1, settings));
  EXPECT_FALSE(followed.empty());
  EXPECT_TRUE(std::ranges::all_of(followed, seen_through));
}

TEST(SceneView, ADeskUsersHandIsSeenThroughWhereItCoversWhatItIsAbove) {
  Client client;
  client.scene.bodies[part_body].moves = true;
  client.join();
  LocalUser self;
  self.participant = 7;
  self.present = self.at_desk = true;
  HandPose& target = self.input.hands[right_hand];
  target.tracked = true;
  target.pose.p = {0, 1.36, 0.16};  // the fingertips above the ball
  UserState user;
  user.participant = self.participant;
  user.hands[right_hand] = target;
  client.tell(user);
  ViewSettings settings = plain(320, 240);
  const auto opacity = [&](const Vec3& eye) {
    settings.eye = look_at(eye, {0, 1.3, 0});
    double last = 0;
    for (int picture = 0; picture < 8; ++picture) {
      while (hands_of(client.list(1, settings, self)).empty())  // the skin is on its way
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
      last = hands_of(client.list(1, settings, self))[0].second;
    }
    return last;
  };
  EXPECT_LT(opacity({0, 2, 0.05}), 0.5) << "from above it hides the ball";
  EXPECT_EQ(opacity({1, 1.4, 0.1}), 1) << "from the side it doesn't";
  EXPECT_EQ(opacity({0, 0.9, 0.05}), 1) << "behind the ball it hides nothing";
}

TEST(SceneView, TheSurfaceThatThePointerFindsIsNotThatOfWhatIsHeld) {
  Client client;
  client.join();
  client.list(1, plain(320, 240));
  const Ray down{{0, 2.5, 0}, -Vec3::UnitY()};
  const auto part = client.view().surface_at(down);
  ASSERT_TRUE(part);
  EXPECT_EQ(part->body, part_body);
  EXPECT_NEAR(part->at.y(), 1.3, 2e-3);
  EXPECT_GT(part->normal.y(), 0.95);
  const auto table = client.view().surface_at(down, {part_body});
  ASSERT_TRUE(table);
  EXPECT_EQ(table->body, 0u);
  EXPECT_NEAR(table->at.y(), 1, 1e-6);
  EXPECT_FALSE(client.view().surface_at({{3, 2.5, 3}, -Vec3::UnitY()})) << "the room's floor is no body";
  EXPECT_NEAR(client.view().box_of(part_body).sizes().y(), 0.2, 1e-3);
}

}  // namespace
}  // namespace prosector
