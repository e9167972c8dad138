// From a glove's bends to what is asked of the server.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "client/app/terminal/panel_call.h"
#include "client/app/user/device_rig.h"
#include "client/app/user/handled_bodies.h"
#include "common/clock.h"
#include "drivers/device/gesture.h"

namespace prosector {
namespace {

/// What a rig makes of a glove that shows these gestures one after the other.
std::vector<GestureTrigger> triggers(const std::vector<const char*>& gestures, ClientConfig config = {}) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) /
      (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".csv");
  std::ofstream out(file);
  out << "time,thumb,index,middle,ring,little,gesture\n";
  for (const char* gesture : gestures) out << "0,0,0,0,0,0," << gesture << "\n";
  out.close();
  config.gloves[right_hand].address = "recorded:" + file.string();
  DeviceRig rig(config);
  const std::int64_t end = monotonic_ns() + 5'000'000'000;
  std::vector<GestureTrigger> all;
  std::size_t quiet = 0;
  while (quiet < 3 && monotonic_ns() < end) {
    quiet = rig.poll(monotonic_ns()) ? 0 : quiet + 1;
    for (const GestureTrigger& t : rig.take_triggers()) all.push_back(t);
  }
  return all;
}

TEST(Gestures, EachAsksForWhatTheTableSays) {
  const std::map<Gesture, GestureEvent> expected = {{Gesture::fist, GestureEvent::grasp},
                                                    {Gesture::pinch, GestureEvent::grasp},
                                                    {Gesture::flat, GestureEvent::release},
                                                    {Gesture::index_little, GestureEvent::panel},
                                                    {Gesture::three, GestureEvent::parts}};
  EXPECT_EQ(ClientConfig{}.gestures, expected);
  for (const GestureRow& row : gesture_table()) {
    const auto asked = triggers({row.name});
    const auto wanted = expected.find(without_thumb(row.gesture));
    ASSERT_EQ(asked.size(), wanted == expected.end() ? 0u : 1u) << row.name;
    if (asked.empty()) continue;
    EXPECT_EQ(asked[0].event, wanted->second) << row.name;
    EXPECT_EQ(asked[0].hand, right_hand);
  }
}

TEST(Gestures, AskOnceUntilAnotherIsMade) {
  const auto asked = triggers({"fist", "fist", "none", "fist", "point", "none", "fist", "flat", "flat"});
  std::vector<GestureEvent> events;
  for (const GestureTrigger& t : asked) events.push_back(t.event);
  EXPECT_EQ(events, (std::vector{GestureEvent::grasp, GestureEvent::grasp, GestureEvent::release}));
}

// A thumb asks for nothing of its own until the configuration says so.
TEST(Gestures, ThatNeedAThumbAskAsTheirFingersUntilTheyAreNamed) {
  const auto as_fingers = triggers({"thumb_up", "fist", "thumb_up", "four", "flat", "thumb_index"});
  ASSERT_EQ(as_fingers.size(), 2u);
  EXPECT_EQ(as_fingers[0].event, GestureEvent::grasp);
  EXPECT_EQ(as_fingers[1].event, GestureEvent::release);
  const ClientConfig config = parse_client_config(
      "[gestures]\nthumb_up = 'reset'\nfist = 'grasp'\nfour = 'parts'\nthumb_index = 'panel'\n", "c.toml");
  std::vector<GestureEvent> named;
  for (const GestureTrigger& t :
       triggers({"fist", "thumb_up", "fist", "flat", "four", "point", "thumb_index"}, config))
    named.push_back(t.event);
  EXPECT_EQ(named, (std::vector{GestureEvent::grasp, GestureEvent::reset, GestureEvent::grasp,
                                GestureEvent::parts, GestureEvent::panel}));
}

TEST(Gestures, FollowTheConfiguration) {
  const ClientConfig config =
      parse_client_config("[gestures]\npoint = 'panel'\nfist = 'none'\nthree = 'reset'\n", "c.toml");
  const auto asked = triggers({"fist", "flat", "point", "three"}, config);
  ASSERT_EQ(asked.size(), 2u);
  EXPECT_EQ(asked[0].event, GestureEvent::panel);
  EXPECT_EQ(asked[1].event, GestureEvent::reset);
}

constexpr ParticipantId ada = 7, grace = 9;

Replica room() {
  SceneInfo scene;
  for (const bool part : {false, true, true}) scene.bodies.emplace_back().part = part;
  Replica out;
  out.apply({.message = scene});
  RosterEntry present;
  present.participant = ada;
  out.apply({.message = present});
  return out;
}

void touch(Replica& replica, BodyId body, bool touching = true) {
  ContactSample sample;
  sample.participant = ada;
  sample.touching = touching;
  sample.body = body;
  replica.apply({.message = sample});
}

/// Returns the body whose panel a call opens; nullopt: it opens none.
std::optional<BodyId> opened(const std::optional<CommandBody>& call) {
  const auto* const open = call ? std::get_if<OpenPanel>(&*call) : nullptr;
  return open == nullptr ? std::nullopt : std::optional(open->body);
}

TEST(PanelCall, OpensThePartThatIsTouchedElseTheOnePointedAt) {
  Replica replica = room();
  EXPECT_FALSE(call_panel(replica, ada, right_hand, std::nullopt));
  EXPECT_FALSE(call_panel(replica, ada, right_hand, 0)) << "no part of the anatomy";
  EXPECT_FALSE(call_panel(replica, ada, right_hand, 99));
  EXPECT_EQ(opened(call_panel(replica, ada, right_hand, 2)), 2u);
  touch(replica, 1);
  const auto touched = call_panel(replica, ada, right_hand, 2);
  EXPECT_EQ(opened(touched), 1u);
  EXPECT_EQ(opened(call_panel(replica, ada, left_hand, 2)), 2u) << "the other hand touches nothing";
  EXPECT_EQ(opened(call_panel(replica, grace, right_hand, 2)), 2u) << "nor does somebody else's";
}

TEST(PanelCall, ClosesOnesOwnAlone) {
  Replica replica = room();
  touch(replica, 1);
  Panel panel;
  panel.participant = grace;
  panel.open = true;
  panel.body = 1;
  replica.apply({.message = panel});
  EXPECT_EQ(opened(call_panel(replica, ada, right_hand, std::nullopt)), 1u);
  EXPECT_TRUE(std::holds_alternative<ClosePanel>(call_panel(replica, grace, right_hand, 1).value()));
}

/// Sets the hands that hold a body.
void hold(Replica& replica, BodyId body, const std::vector<HandRef>& holders) {
  PartState part;
  part.body = body;
  part.holders = holders;
  replica.apply({.message = part});
}

/// Sets the run of the server that the replica follows.
void open_session(Replica& replica, std::uint64_t server_run) {
  SessionInfo session;
  session.server_run = server_run;
  replica.apply({.message = session});
}

class LastHandled : public testing::Test {
 protected:
  LastHandled() { open_session(replica_, 1); }

  Replica replica_ = room();

  /// Returns the body that a hand of Ada's handled last, after an update.
  std::optional<BodyId> last(std::size_t hand = right_hand) {
    bodies_.update(replica_, ada);
    return bodies_.last(hand);
  }

 private:
  HandledBodies bodies_;
};

TEST_F(LastHandled, IsTheHeldBodyWhateverTheHandTouches) {
  touch(replica_, 1);
  hold(replica_, 2, {{ada, right_hand}});
  EXPECT_EQ(last(), 2u);
  hold(replica_, 2, {});
  EXPECT_EQ(last(), 1u) << "still touched";
}

TEST_F(LastHandled, RemainsAfterReleaseAndAfterTheTouch) {
  hold(replica_, 2, {{ada, right_hand}});
  EXPECT_EQ(last(), 2u);
  hold(replica_, 2, {});
  EXPECT_EQ(last(), 2u);
  touch(replica_, 1);
  EXPECT_EQ(last(), 1u);
  touch(replica_, 1, false);
  EXPECT_EQ(last(), 1u);
}

TEST_F(LastHandled, IsNoneBeforeTheFirstTouch) {
  touch(replica_, 1, false);  // a touch that is expected soon
  EXPECT_EQ(last(), std::nullopt);
  hold(replica_, 1, {{ada, left_hand}, {grace, right_hand}});
  EXPECT_EQ(last(), std::nullopt) << "held by Ada's other hand and by another participant";
  EXPECT_EQ(last(left_hand), 1u);
}

TEST_F(LastHandled, IsNoneForABodyThatTheSceneLacks) {
  touch(replica_, 99);
  EXPECT_EQ(last(), std::nullopt);
}

TEST_F(LastHandled, IsForgottenWithTheServersRun) {
  touch(replica_, 1);
  EXPECT_EQ(last(), 1u);
  touch(replica_, 1, false);
  open_session(replica_, 2);
  EXPECT_EQ(last(), std::nullopt);
}

}  // namespace
}  // namespace prosector
