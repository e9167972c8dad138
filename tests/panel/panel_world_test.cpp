// Who gets a panel when, and what working it asks for.

#include <gtest/gtest.h>

#include "common/error.h"
#include "tests/panel/panel_room.h"

namespace prosector::test {
namespace {

TEST(PanelWorld, ATouchForAMomentCallsUpThePanelOfThePart) {
  Room room;
  room.world.take(panel::HeadPlace{ada, {0, 1.5, 0.7}});
  room.step(hand(ada, liver), moment() - 1);
  EXPECT_TRUE(room.world.panels().empty());
  room.step(hand(ada, liver));
  ASSERT_EQ(room.world.panels().size(), 1u);
  const Panel panel = room.world.panels()[0];
  EXPECT_EQ(panel.participant, ada);
  EXPECT_EQ(panel.body, liver);
  EXPECT_TRUE(panel.open);
  EXPECT_GT((panel.pose.q * Vec3::UnitZ()).dot((Vec3(0, 1.5, 0.7) - panel.pose.p).normalized()), 0.999);
}

TEST(PanelWorld, OnlyPartsHaveOne) {
  Room room;
  room.step(hand(ada, table), 100);
  room.event(panel::PanelEvent::Kind::open, ada, table);
  EXPECT_TRUE(room.world.panels().empty());
}

TEST(PanelWorld, TouchingElsewhereMovesOrClosesIt) {
  Room room;
  room.step(hand(ada, liver), moment());
  room.step(hand(ada), 30);
  room.step(hand(ada, kidney), moment());
  ASSERT_EQ(room.world.panels().size(), 1u);
  EXPECT_EQ(room.world.panels()[0].body, kidney);
  room.step(hand(ada), 30);
  room.step(hand(ada, table), moment());
  EXPECT_TRUE(room.world.panels().empty());
}

TEST(PanelWorld, GoesAfterAWhileWithoutTouch) {
  Room room;
  room.step(hand(ada, liver), moment());
  const int time_limit = static_cast<int>(std::ceil(panel::panel_timeout / tick));
  room.step(hand(ada, liver), 2 * time_limit);
  EXPECT_EQ(room.world.panels().size(), 1u) << "while the part is touched it stays";
  room.step(hand(ada), time_limit - 1);
  EXPECT_EQ(room.world.panels().size(), 1u);
  room.step(hand(ada), 3);
  EXPECT_TRUE(room.world.panels().empty());
}

TEST(PanelWorld, GoesWithItsPart) {
  Room room;
  room.step(hand(ada, liver), moment());
  room.bodies.parts.erase(liver);
  room.step(std::vector<panel::PanelHand>{});
  EXPECT_TRUE(room.world.panels().empty());
}

TEST(PanelWorld, AClosedOneComesBackOnlyWithANewTouch) {
  Room room;
  room.step(hand(ada, liver), moment());
  room.event(panel::PanelEvent::Kind::close, ada);
  room.step(hand(ada, liver), 200);
  EXPECT_TRUE(room.world.panels().empty());
  room.step(hand(ada), moment());
  room.step(hand(ada, liver), moment());
  EXPECT_EQ(room.world.panels().size(), 1u);
}

TEST(PanelWorld, AButtonActsOncePerPress) {
  for (std::size_t k = 0; k < 5; ++k) {
    const PanelControl control = panel_controls[k].control;
    Room room;
    room.event(panel::PanelEvent::Kind::open, ada, liver);
    const double before = room.bodies.parts[liver][k];
    press(room, ada, control);
    ASSERT_EQ(room.actions.size(), 1u) << panel_controls[k].label;
    EXPECT_EQ(room.actions[0].control, control);
    EXPECT_EQ(room.actions[0].participant, ada);
    EXPECT_EQ(room.actions[0].body, liver);
    EXPECT_EQ(room.actions[0].value, 1 - before);
    EXPECT_EQ(room.world.panels()[0].controls[k].on, before < 0.5);
    press(room, ada, control);
    ASSERT_EQ(room.actions.size(), 2u);
    EXPECT_EQ(room.actions[1].value, before) << "back again";
  }
}

TEST(PanelWorld, TremblingAtTheStopIsOnePress) {
  Room room;
  room.event(panel::PanelEvent::Kind::open, ada, liver);
  for (int i = 0; i < 120; ++i)
    room.step(at_panel(room, ada, over(PanelControl::light_shaft, 0.0035 + 0.001 * std::sin(1.3 * i))));
  EXPECT_EQ(room.actions.size(), 1u);
}

TEST(PanelWorld, WhatAFingerTouchesIsTouchedAndBack) {
  Room room;
  room.event(panel::PanelEvent::Kind::open, ada, liver);
  for (const double height : {0.03, 0.015, 0.008, 0.008})
    room.step(at_panel(room, ada, over(PanelControl::hide_others, height)));
  const auto touched = [&] {
    return room.world.panels()[0].controls[index_of(PanelControl::hide_others)].touched;
  };
  EXPECT_TRUE(touched());
  EXPECT_TRUE(room.actions.empty()) << "not yet pressed home";
  room.step(hand(ada));
  EXPECT_FALSE(touched());
}

TEST(PanelWorld, AnybodysFingerWorksIt) {
  Room room;
  room.event(panel::PanelEvent::Kind::open, ada, liver);
  press(room, eve, PanelControl::transparency);
  ASSERT_EQ(room.actions.size(), 1u);
  EXPECT_EQ(room.actions[0].participant, ada) << "it is her panel";
}

TEST(PanelWorld, AHandBehindTheBoardWorksNothing) {
  Room room;
  room.event(panel::PanelEvent::Kind::open, ada, liver);
  for (const double height : {-0.05, -0.03, -0.01, 0.01, 0.02, 0.0}) {
    panel::PanelHand reaching = at_panel(room, ada, over(PanelControl::attach, height));
    reaching.palm = room.world.panels()[0].pose * Vec3(0, 0, -0.1);
    room.step(reaching);
  }
  EXPECT_TRUE(room.actions.empty());
}

TEST(PanelWorld, AFingerThatPassesUnderTheFrontFromBesideItWorksNothingUntilItHasBeenOverIt) {
  for (const ControlDesc& control : panel_controls)
    for (const double height : {-0.05, -0.03, -0.015})
      for (const Vec3& from : {Vec3(0.4, 0, 0), Vec3(-0.4, 0, 0), Vec3(0, 0.4, 0), Vec3(0, -0.4, 0)}) {
        Room room;
        room.event(panel::PanelEvent::Kind::open, ada, liver);
        panel::Capsule finger = over(control.control, height);
        const auto move_to = [&](const Vec3& way) {
          const panel::Capsule at{finger.a + way, finger.b + way, finger.radius};
          room.step(at_panel(room, ada, at));
        };
        for (int i = 40; i >= -40; --i) move_to(i / 40.0 * from);
        for (int i = -40; i <= 0; ++i) move_to(i / 40.0 * from);
        EXPECT_TRUE(room.actions.empty()) << control.label << " at " << height << ", " << from.transpose();
        for (const double up : {0.02, 0.06, 0.1}) move_to({0, 0, up});
        EXPECT_TRUE(room.actions.empty()) << control.label << " from below, " << height;
        if (control.kind != ControlKind::button) continue;
        press(room, ada, control.control);
        EXPECT_EQ(room.actions.size(), 1u) << control.label;
      }
}

TEST(PanelWorld, TheSliderSetsAndShowsTheStiffness) {
  Room room;
  room.event(panel::PanelEvent::Kind::open, ada, liver);
  const auto k = index_of(PanelControl::stiffness);
  const Vec3 beside = control_face(panel_controls[k], 0.5) - Vec3(0.03, 0, 0.012);
  for (int i = 0; i <= 40; ++i) room.step(at_panel(room, ada, finger_at(beside + Vec3(0.001 * i, 0, 0))));
  room.step(hand(ada), 20);
  const double left_at = room.world.panels()[0].controls[k].position;
  EXPECT_GT(left_at, 0.55);
  EXPECT_NEAR(room.bodies.parts[liver][k], left_at, 1e-5);
  room.step(hand(ada), 100);
  EXPECT_NEAR(room.world.panels()[0].controls[k].position, left_at, 1e-5);
  room.bodies.parts[liver][k] = 0.25;  // somebody else's panel of the same part
  room.step(hand(ada), 2);
  EXPECT_NEAR(room.world.panels()[0].controls[k].position, 0.25, 1e-9);
}

TEST(PanelWorld, CommandsDoWhatFingersDo) {
  Room room;
  room.event(panel::PanelEvent::Kind::set, ada, 0, PanelControl::light_shaft, 1);
  room.step(std::vector<panel::PanelHand>{});
  EXPECT_TRUE(room.actions.empty()) << "no panel, no control";
  room.event(panel::PanelEvent::Kind::open, ada, liver);
  room.event(panel::PanelEvent::Kind::set, ada, 0, PanelControl::light_shaft, 1);
  room.event(panel::PanelEvent::Kind::set, ada, 0, PanelControl::stiffness, 0.8);
  room.event(panel::PanelEvent::Kind::set, eve, 0, PanelControl::attach, 0);
  room.step(std::vector<panel::PanelHand>{});
  ASSERT_EQ(room.actions.size(), 2u);
  EXPECT_EQ(room.actions[0].control, PanelControl::light_shaft);
  EXPECT_EQ(room.actions[1].value, 0.8);
  const Panel seen = room.world.panels()[0];
  EXPECT_TRUE(seen.controls[index_of(PanelControl::light_shaft)].touched);
  EXPECT_GT(seen.controls[index_of(PanelControl::light_shaft)].position, 0) << "it is seen going in";
  for (int i = 0; i < 60; ++i) room.step(std::vector<panel::PanelHand>{});
  EXPECT_EQ(room.actions.size(), 2u);
  EXPECT_FALSE(room.world.panels()[0].controls[index_of(PanelControl::light_shaft)].touched);
  EXPECT_EQ(room.world.panels()[0].controls[index_of(PanelControl::light_shaft)].position, 0);
}

/// A hand with its palm at a place of the world, open or closed.
panel::PanelHand palm_at(ParticipantId who, const Vec3& at, bool fist) {
  panel::PanelHand out = hand(who);
  out.palm = at;
  out.fingers = {{at, at + Vec3(0, 0, 0.02), 0.008}};
  out.fist = fist;
  return out;
}

/// A room with a panel, its reader and the place of its head.
struct RoomWithPanel : Room {
  const Vec3 eyes{0, 1.5, 0.7};
  Pose first;
  Vec3 head;
  RoomWithPanel() {
    world.take(panel::HeadPlace{ada, eyes});
    event(panel::PanelEvent::Kind::open, ada, liver);
    first = world.panels()[0].pose;
    head = first * Vec3(0.05, panel_head_bottom + 0.01, 0.02);
  }
  Pose pose() const { return world.panels()[0].pose; }
};

TEST(PanelWorld, AFistAtItsHeadCarriesItFacingItsReader) {
  for (const ParticipantId who : {ada, eve}) {
    RoomWithPanel room;
    const Vec3 grip = room.first.inverse() * room.head, way(0.2, -0.05, 0.1);
    room.step(palm_at(who, room.head, false), 3);
    EXPECT_EQ((room.pose().p - room.first.p).norm(), 0);
    for (int k = 0; k <= 30; ++k) room.step(palm_at(who, room.head + way * (k / 30.0), true));
    room.step(palm_at(who, room.head + way, true), 60);
    EXPECT_LT((room.pose() * grip - (room.head + way)).norm(), 1e-6) << "it stays in the fist";
    EXPECT_GT((room.pose().q * Vec3::UnitZ()).dot((room.eyes - room.pose().p).normalized()), 0.9999);
    EXPECT_NEAR((room.pose().q * Vec3::UnitX()).y(), 0, 1e-12) << "level";
    ASSERT_EQ(room.world.carriers().size(), 1u);
    EXPECT_EQ(room.world.carriers()[0].participant, who);
    const Pose left = room.pose();
    room.step(palm_at(who, room.head + way, false));
    room.step(palm_at(who, room.head, false), 30);
    EXPECT_EQ((room.pose().p - left.p).norm(), 0) << "and where it was let go";
    EXPECT_TRUE(room.world.carriers().empty());
    EXPECT_TRUE(room.actions.empty()) << "the fist pressed nothing";
  }
}

TEST(PanelWorld, APointerPutsItWhereNoFistCarriesIt) {
  RoomWithPanel room;
  panel::PanelEvent put{.kind = panel::PanelEvent::Kind::put, .participant = ada, .at = {0.3, 1.3, -0.1}};
  room.world.take(put, room.bodies);
  EXPECT_EQ(room.pose().p, put.at);
  EXPECT_GT((room.pose().q * Vec3::UnitZ()).dot((room.eyes - put.at).normalized()), 0.9999);
  for (const Vec3& nowhere : {Vec3(0, std::nan(""), 0), Vec3(0, 2 * max_coordinate, 0)}) {
    put.at = nowhere;
    room.world.take(put, room.bodies);
    EXPECT_EQ(room.pose().p, Vec3(0.3, 1.3, -0.1));
  }
  panel::PanelEvent back{.kind = panel::PanelEvent::Kind::put_back, .participant = ada};
  room.world.take(back, room.bodies);
  EXPECT_EQ(room.pose().p, room.first.p);
  EXPECT_EQ(room.pose().q.coeffs(), room.first.q.coeffs());
  room.step(palm_at(ada, room.head, false));
  room.step(palm_at(ada, room.head, true), 3);
  room.step(palm_at(ada, room.head + Vec3(0.1, 0, 0), true));
  const Vec3 carried = room.pose().p;
  EXPECT_GT((carried - room.first.p).norm(), 0.05);
  put.at = {0, 1, 0};
  room.world.take(put, room.bodies);
  room.world.take(back, room.bodies);
  EXPECT_EQ(room.pose().p, carried) << "a fist has it";
}

TEST(PanelWorld, TwoFistsInOnePlacePutItBack) {
  RoomWithPanel room;
  const auto close = [&](const Vec3& at, int ticks_open) {
    room.step(palm_at(ada, at, false), ticks_open);
    room.step(palm_at(ada, at, true), 5);
  };
  close(room.head, 1);
  const Vec3 there = room.head + Vec3(0.1, 0, 0);
  for (int k = 0; k <= 10; ++k) room.step(palm_at(ada, room.head + (there - room.head) * (k / 10.0), true));
  close(there, 5);
  EXPECT_GT((room.pose().p - room.first.p).norm(), 0.09) << "the palm went on: it is carried again";
  close(there, 90);
  EXPECT_GT((room.pose().p - room.first.p).norm(), 0.09) << "too late for a second one";
  close(there, 5);
  EXPECT_EQ((room.pose().p - room.first.p).norm(), 0);
  EXPECT_EQ(room.pose().q.coeffs(), room.first.q.coeffs());
}

TEST(PanelWorld, AHandAtItsHeadPressesNothing) {
  RoomWithPanel room;
  for (const double height : {0.03, 0.015, 0.008, 0.002, -0.002, -0.002, 0.01, 0.03}) {
    panel::PanelHand closing = at_panel(room, ada, over(PanelControl::attach, height));
    closing.palm = room.head;
    room.step(closing);
  }
  EXPECT_TRUE(room.actions.empty());
  press(room, ada, PanelControl::attach);
  EXPECT_EQ(room.actions.size(), 1u) << "but one before the buttons does";
}

/// A hand that closes from `bend` to a fist while its index finger sweeps through a button, as one does that
/// comes to the head from before the board. Returns how often something was asked for.
std::size_t presses_while_closing(double bend, const Vec3& second_finger) {
  RoomWithPanel room;
  for (const double height : {0.03, 0.015, 0.008, 0.002, -0.002, -0.002, 0.01, 0.03}) {
    panel::PanelHand closing = at_panel(room, ada, over(PanelControl::attach, height));
    closing.fingers.push_back(
        {room.first * second_finger, room.first * (second_finger + Vec3(0, 0, 0.02)), 0.008});
    closing.bend = bend;
    bend = std::min(0.9, bend + 0.1);
    room.step(closing);
  }
  return room.actions.size();
}

TEST(PanelWorld, AHandThatClosesPressesNothing) {
  const Vec3 at_head(0, panel_head_bottom + 0.005, 0.02), below(0, panel_head_bottom - 0.05, 0.05);
  EXPECT_EQ(presses_while_closing(0.25, at_head), 0u) << "its fingers reach the head";
  EXPECT_EQ(presses_while_closing(0.55, below), 0u) << "half a fist, on its way";
}

TEST(PanelWorld, AHandWithAStretchedFingerPressesWhereverItsOthersAre) {
  RoomWithPanel room;
  const Vec3 at_head(0, panel_head_bottom + 0.005, 0.02);
  for (const double height : {0.03, 0.015, 0.008, 0.002, -0.002, -0.002, 0.01, 0.03}) {
    panel::PanelHand pointing = at_panel(room, ada, over(PanelControl::attach, height));
    pointing.fingers.push_back({room.first * at_head, room.first * (at_head + Vec3(0, 0, 0.02)), 0.008});
    pointing.bend = 0.1;
    room.step(pointing);
  }
  EXPECT_EQ(room.actions.size(), 1u);
}

TEST(PanelWorld, AFistElsewhereOrThatComesClosedCarriesNothing) {
  for (const Vec3& at : {Vec3(0.05, panel_head_bottom - 0.03, 0.02), Vec3(0, panel_height / 2, 0.2),
                         Vec3(0.5, panel_head_bottom, 0)}) {
    RoomWithPanel room;
    room.step(palm_at(ada, room.first * at, false), 2);
    for (int k = 0; k < 10; ++k) room.step(palm_at(ada, room.first * at + Vec3(0.01 * k, 0, 0), true));
    EXPECT_EQ((room.pose().p - room.first.p).norm(), 0) << at.transpose();
  }
  RoomWithPanel room;
  room.step(palm_at(ada, room.head - Vec3(0.4, 0, 0), false));
  for (int k = 0; k < 40; ++k) room.step(palm_at(ada, room.head + Vec3(0.01 * k - 0.4, 0, 0), true));
  EXPECT_EQ((room.pose().p - room.first.p).norm(), 0) << "closed before it came";
}

TEST(PanelWorld, StaysWhileAFingerPointsAtIt) {
  RoomWithPanel room;
  panel::PanelHand pointing = hand(ada, kidney);
  const auto point = [&](double aside) {
    const Vec3 tip(aside, 0, 0.2);
    pointing.index = {room.first * tip, room.first * (tip + Vec3(0, 0, 0.02)), 0.008};
  };
  point(0.1);
  room.step(pointing, 3 * static_cast<int>(std::ceil(panel::panel_timeout / tick)));
  ASSERT_EQ(room.world.panels().size(), 1u);
  EXPECT_EQ(room.world.panels()[0].body, liver) << "although another part is touched";
  point(0.2);
  room.step(pointing, static_cast<int>(std::ceil(panel::pinned_by_hand / tick)) + moment());
  ASSERT_EQ(room.world.panels().size(), 1u);
  EXPECT_EQ(room.world.panels()[0].body, kidney) << "beside it, it goes as ever";
}

TEST(PanelWorld, StaysForAWhileWhenItIsAskedForAgain) {
  RoomWithPanel room;
  room.event(panel::PanelEvent::Kind::open, ada, liver);
  room.step(hand(ada, kidney), static_cast<int>(std::ceil(panel::pinned_from_afar / tick)) - 1);
  EXPECT_EQ(room.world.panels()[0].body, liver);
  room.step(hand(ada, kidney), moment());
  EXPECT_EQ(room.world.panels()[0].body, kidney);
}

TEST(PanelWorld, GoesOnTheSameAfterRestoreWhileItIsCarried) {
  RoomWithPanel room;
  room.step(palm_at(ada, room.head, false));
  room.step(palm_at(ada, room.head, true), 3);
  Room restored;
  load(restored.world, room.saved(), 10);
  const auto both = [&](const panel::PanelHand& hand) {
    room.step(hand);
    restored.step(hand);
    EXPECT_EQ(restored.saved(), room.saved());
  };
  for (int k = 0; k < 5; ++k) both(palm_at(ada, room.head + Vec3(0.01 * k, 0, 0), true));
  EXPECT_GT((room.pose().p - room.first.p).norm(), 0.03) << "it was carried on after the restore";
  both(palm_at(ada, room.head, false));
  both(palm_at(ada, room.head, true));
  EXPECT_EQ((room.pose().p - room.first.p).norm(), 0) << "the second fist there put it back";
}

TEST(PanelWorld, GoesOnTheSameAfterRestore) {
  Room room;
  room.world.take(panel::HeadPlace{ada, {0, 1.5, 0.7}});
  room.step(hand(ada, liver), moment());
  for (const double height : {0.03, 0.012, 0.007})
    room.step(at_panel(room, ada, over(PanelControl::attach, height)));
  Room restored;
  load(restored.world, room.saved(), 10);
  for (const double height : {0.004, -0.002, 0.01, 0.02}) {
    const panel::PanelHand finger = at_panel(room, ada, over(PanelControl::attach, height));
    room.step(finger);
    restored.step(finger);
    EXPECT_EQ(restored.saved(), room.saved()) << height;
  }
  EXPECT_EQ(restored.actions.size(), 1u);
}

TEST(PanelWorld, BrokenStatesAreRefused) {
  Room room;
  room.step(hand(ada, liver), moment());
  room.step({hand(ada), hand(eve, kidney)});
  const Vec3 head = room.world.panels()[0].pose * Vec3(0, panel_head_bottom + 0.01, 0);
  room.step(palm_at(ada, head, false));
  room.step(palm_at(ada, head, true));
  ASSERT_EQ(room.world.carriers().size(), 1u);
  const auto good = room.saved();
  const std::span<const std::uint8_t> all = good;
  for (std::size_t size = 0; size < good.size(); ++size) {
    Room other;
    EXPECT_THROW(load(other.world, all.first(size), 10), InputError) << size;
    EXPECT_TRUE(other.world.panels().empty());
  }
  Room other;
  EXPECT_THROW(load(other.world, good, liver), InputError) << "a body that isn't there";
}

TEST(PanelWorld, SomeoneGoneLeavesNothing) {
  Room room;
  const auto empty = room.saved();
  room.world.take(panel::HeadPlace{ada, {0, 1.5, 0.7}});
  room.step(hand(ada, liver), moment());
  room.event(panel::PanelEvent::Kind::close, ada);
  room.step(std::vector<panel::PanelHand>{});
  EXPECT_EQ(room.saved(), empty);
}

}  // namespace
}  // namespace prosector::test
