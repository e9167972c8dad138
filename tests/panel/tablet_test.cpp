// A board in the hand is the panel; a stylus presses it.

#include <gtest/gtest.h>

#include <random>

#include "tests/panel/panel_room.h"

namespace prosector::test {
namespace {

Pose random_board(std::mt19937& random) {
  std::uniform_real_distribution<double> any(-1, 1);
  return {Vec3(any(random), 1 + any(random), any(random)),
          Quat(any(random), any(random), any(random), any(random)).normalized()};
}

panel::HeldPlace tablet_at(ParticipantId who, const Pose& at) {
  return {who, HeldObject::tablet, true, at};
}

int ticks_of(double seconds) {
  return static_cast<int>(std::ceil(seconds / tick));
}

const Pose& only_pose(const std::vector<Panel>& panels) {
  return panels.at(0).pose;
}

TEST(Tablet, ComesUpAsThePanelOfTheFirstPartWhereverItIsHeld) {
  std::mt19937 random(3);
  for (int round = 0; round < 50; ++round) {
    Room room;
    const Pose board = random_board(random);
    room.world.take(tablet_at(ada, board));
    room.step(std::vector<panel::PanelHand>{});
    const std::vector<Panel> panels = room.world.panels();
    ASSERT_EQ(panels.size(), 1u);
    EXPECT_EQ(panels[0].body, liver);
    EXPECT_EQ(panels[0].participant, ada);
    EXPECT_EQ(panels[0].pose.p, board.p);
    EXPECT_LT(panels[0].pose.q.angularDistance(board.q), 1e-12);
  }
}

TEST(Tablet, CarriesThePanelOfWhatItsOwnerTouchesFromTheFirstTickOn) {
  Room room;
  const Pose board{{0.1, 1.2, 0.3}, Quat(0.8, 0.6, 0, 0)};
  room.world.take(tablet_at(ada, board));
  for (int i = 0; i < 2 * moment(); ++i) {
    room.step(hand(ada, kidney));
    EXPECT_EQ(only_pose(room.world.panels()).p, board.p) << i;
  }
  EXPECT_EQ(room.world.panels()[0].body, kidney);
  room.step(hand(ada), moment());
  room.step(hand(ada, table), 2 * moment());
  EXPECT_EQ(room.world.panels().at(0).body, kidney) << "what is no part sends it not away";
}

TEST(Tablet, NeitherFistNorPointerNorTimeTakesItsPanel) {
  Room room;
  const Pose board{{0.1, 1.2, 0.3}, Quat::Identity()};
  room.world.take(tablet_at(ada, board));
  room.step(std::vector<panel::PanelHand>{});
  panel::PanelHand fist = hand(eve);
  fist.palm = board * Vec3(0.05, panel_head_bottom + 0.01, 0.02);
  room.step(fist, 2);
  fist.fist = true;
  for (int i = 0; i < 20; ++i) {
    fist.palm.x() += 0.01;
    room.step(fist);
  }
  room.world.take(
      panel::PanelEvent{.kind = panel::PanelEvent::Kind::put, .participant = ada, .at = {0, 1, 0}},
      room.bodies);
  room.event(panel::PanelEvent::Kind::put_back, ada);
  room.step(hand(ada), 2 * ticks_of(panel::panel_timeout));
  EXPECT_EQ(only_pose(room.world.panels()).p, board.p);
  EXPECT_TRUE(room.world.carriers().empty());
}

TEST(Tablet, ThatIsLostRestsThenLetsGoAndComesBack) {
  Room room;
  const Pose board{{0.1, 1.2, 0.3}, Quat(0.8, 0.6, 0, 0)};
  room.world.take(tablet_at(ada, board));
  room.step(std::vector<panel::PanelHand>{});
  room.world.take(panel::HeldPlace{ada, HeldObject::tablet, false, {}});
  room.step(hand(ada), ticks_of(panel::tablet_rest));
  room.event(panel::PanelEvent::Kind::put_back, ada);
  EXPECT_EQ(only_pose(room.world.panels()).p, board.p) << "it rests, and nobody moves it";
  room.step(hand(ada), 2);
  EXPECT_EQ(only_pose(room.world.panels()).p, board.p);
  room.event(panel::PanelEvent::Kind::put_back, ada);
  EXPECT_NE(only_pose(room.world.panels()).p, board.p) << "it was let go";
  room.world.take(tablet_at(ada, board));
  room.step(hand(ada));
  EXPECT_EQ(only_pose(room.world.panels()).p, board.p);
  room.world.take(panel::HeldPlace{ada, HeldObject::tablet, false, {}});
  room.step(hand(ada), ticks_of(panel::tablet_rest) + ticks_of(panel::panel_timeout) + 3);
  EXPECT_TRUE(room.world.panels().empty());
}

TEST(Tablet, ThatWasSentAwayComesUpAgainOnlyWhenItIsShownAnew) {
  Room room;
  room.world.take(tablet_at(ada, {}));
  room.step(hand(ada));
  room.event(panel::PanelEvent::Kind::close, ada);
  for (int i = 0; i < 100; ++i) {
    room.world.take(tablet_at(ada, {}));
    room.step(hand(ada));
  }
  EXPECT_TRUE(room.world.panels().empty());
  room.world.take(panel::HeldPlace{ada, HeldObject::tablet, false, {}});
  room.step(hand(ada), ticks_of(panel::tablet_rest) + 2);
  room.world.take(tablet_at(ada, {}));
  room.step(hand(ada));
  EXPECT_EQ(room.world.panels().size(), 1u);
}

/// What a finger that rests in the room asks of a tablet that is moved against it, or that trembles below it.
std::size_t asked_by_moving(const std::vector<double>& heights) {
  Room room;
  const Vec3 face = control_face(describe(PanelControl::light_shaft), 0);
  const panel::Capsule finger = finger_at({0, 1.2, 0});
  for (const double height : heights) {
    const Pose board{Vec3(-face.x(), 1.2 - face.y(), -height), Quat::Identity()};
    room.world.take(tablet_at(ada, board));
    panel::PanelHand still = hand(ada);
    still.palm = {0, 1.2, 0.1};
    still.fingers = {finger};
    room.step(still);
  }
  return room.actions.size();
}

TEST(Tablet, ThatIsMovedAgainstAFingerIsPressedAsByAFinger) {
  EXPECT_EQ(asked_by_moving({0.05, 0.04, 0.03, 0.02, 0.01, 0.005, 0.001, 0.001, 0.001, 0.02, 0.05}), 1u);
  std::vector<double> trembling;
  for (int i = 0; i < 200; ++i) trembling.push_back(0.015 + 0.003 * std::sin(1.7 * i));
  EXPECT_EQ(asked_by_moving(trembling), 0u) << "hands tremble";
}

/// A stylus whose tip is so high over a control, upright on the board.
panel::HeldPlace stylus_over(const Pose& board, PanelControl control, double height) {
  const Vec3 face = control_face(describe(control), 0);
  return {eve, HeldObject::stylus, true, board * Pose{{face.x(), face.y(), height}, Quat::Identity()}};
}

TEST(Tablet, AStylusPressesEachButtonOncePerPress) {
  std::mt19937 random(5);
  for (std::size_t k = 0; k < 5; ++k) {
    Room room;
    const Pose board = random_board(random);
    room.world.take(tablet_at(ada, board));
    room.step(std::vector<panel::PanelHand>{});
    for (const double height : {0.03, 0.02, 0.012, 0.008, 0.004, 0.001, 0.001, 0.001, 0.012, 0.03, 0.05}) {
      room.world.take(stylus_over(board, panel_controls[k].control, height));
      room.step(std::vector<panel::PanelHand>{});
    }
    ASSERT_EQ(room.actions.size(), 1u) << panel_controls[k].label;
    EXPECT_EQ(room.actions[0].control, panel_controls[k].control);
    EXPECT_EQ(room.actions[0].participant, ada) << "it is her panel";
  }
}

TEST(Tablet, AStylusThatIsLostPressesNothing) {
  Room room;
  room.world.take(tablet_at(ada, {}));
  room.world.take(stylus_over({}, PanelControl::attach, 0.03));
  room.step(std::vector<panel::PanelHand>{});
  room.world.take(panel::HeldPlace{eve, HeldObject::stylus, false, {}});
  room.step(std::vector<panel::PanelHand>{});
  for (const bool touched : {room.world.panels().at(0).controls[0].touched}) EXPECT_FALSE(touched);
  EXPECT_EQ(room.world.panels()[0].controls[0].position, 0);
}

TEST(Tablet, NonsenseIsPassedOver) {
  Room room;
  room.world.take(tablet_at(ada, {Vec3(0, std::nan(""), 0), Quat::Identity()}));
  room.world.take(panel::HeldPlace{eve, HeldObject::stylus, true, {Vec3(1e9, 0, 0), Quat::Identity()}});
  room.world.take(panel::HeldPlace{eve, HeldObject::tablet, false, {}});
  room.step(std::vector<panel::PanelHand>{});
  EXPECT_TRUE(room.world.panels().empty());
}

TEST(Tablet, GoesOnAfterARestoreAsIfThereHadBeenNone) {
  std::mt19937 random(11);
  Room run;
  std::vector<panel::HeldPlace> told;
  for (int i = 0; i < 60; ++i) {
    panel::HeldPlace place = stylus_over({}, PanelControl::attach, 0.03 - 0.0006 * i);
    place.seen = random() % 8 != 0;
    told.push_back(place);
    told.push_back({ada, HeldObject::tablet, random() % 5 != 0, {Vec3(0, 0.0001 * i, 0), Quat::Identity()}});
  }
  for (std::size_t i = 0; i < told.size(); ++i) {
    run.world.take(told[i]);
    run.step(std::vector<panel::PanelHand>{});
    if (i != told.size() / 2) continue;
    const auto saved = run.saved();
    panel::PanelWorld back(tick);
    load(back, saved, 10);
    run.world = back;
    EXPECT_EQ(run.saved(), saved);
  }
  Room straight;
  for (const panel::HeldPlace& place : told) {
    straight.world.take(place);
    straight.step(std::vector<panel::PanelHand>{});
  }
  EXPECT_EQ(run.saved(), straight.saved());
}

}  // namespace
}  // namespace prosector::test
