// Panels as clients see and work them, over the in-process network.

#include <gtest/gtest.h>

#include "common/hand.h"
#include "common/panel.h"
#include "common/panel_placement.h"
#include "server/session/journal/input_bytes.h"
#include "server/session/people/panel_inputs.h"
#include "tests/session/hosted.h"

namespace prosector {
namespace {

using test::Guest;
using test::Hosted;

SceneDesc scene_with_parts() {
  SceneDesc scene = test::hosted_scene();
  scene.soft[0].part = true;
  scene.soft[0].description = "a block";
  scene.rigid.push_back(test::part_body("bone", "box", {0.05, 0.05, 0.05}, {-0.3, 0.03, 0}));
  scene.rigid.back().part = true;
  return scene;
}
constexpr BodyId bone = 2, liver = 3;

/// Fingers stretched or not: the index points, the others are in a fist.
constexpr std::array<double, fingers> pointing = {0.8, 0, 1, 1, 1};

/// The wrist's pose that puts the index finger's tip there, square to the panel.
Pose pointing_at(const Panel& panel, const Vec3& tip_in_panel) {
  const HandSegment& last = hand_segments(right_hand)[4];
  const Vec3 tip = hand_pose(right_hand, pointing)[4] * Vec3(0, 0, -last.length) + Vec3(0, 0, -last.radius);
  return {panel.pose * Vec3(tip_in_panel - tip), panel.pose.q};
}

struct Session {
  explicit Session(Journal* journal = nullptr, const SceneDesc& scene = scene_with_parts())
      : hosted({}, journal, 1, scene) {
    hosted.tick();
    ada.greet("ada", Role::dissector);
    eve.greet("eve", Role::observer);
    tick();
    tick();
  }
  void tick(int times = 1) {
    for (int i = 0; i < times; ++i) {
      hosted.tick();
      ada.take();
      eve.take();
    }
  }
  void hold(const Pose& wrist, int ticks, const std::array<double, fingers>& flexion = pointing) {
    for (int i = 0; i < ticks; ++i) {
      HandInput input = ada.hand_at(wrist.p);
      input.hands[right_hand].pose = wrist;
      input.hands[right_hand].flexion = flexion;
      input.head_tracked = true;
      input.head.p = {0, 0.5, 0.6};
      ada.bus->publish(input);
      tick();
    }
  }
  void touch_liver() {
    for (std::uint64_t t = 0; t < 80; ++t) hold({test::press(t), Quat::Identity()}, 1, {});
    hold({{0, 0.4, 0.3}, Quat::Identity()}, 20, {});
  }
  void press(PanelControl control) {
    const Panel panel = eve.replica.panels().begin()->second;
    const Vec3 face = control_face(describe(control), 0);
    for (const double height : {0.08, 0.04, 0.02, 0.01, 0.0, -0.005, 0.01, 0.04, 0.08})
      hold(pointing_at(panel, {face.x(), face.y(), height}), 12);
  }
  CommandResult ask(Guest& guest, const CommandBody& body) {
    guest.command(body);
    const std::size_t before = guest.results.size();
    tick(3);
    return guest.results.size() > before ? guest.results.back() : CommandResult{};
  }
  const ControlState& control(const Guest& guest, PanelControl c) {
    return guest.replica.panels().at(ada.id).controls[static_cast<std::size_t>(c)];
  }

  Hosted hosted;
  Guest ada = hosted.guest(1, BusEnd::dissector);
  Guest eve = hosted.guest(2, BusEnd::observer);
};

TEST(PanelSession, ATouchBringsItUpForEveryone) {
  Session s;
  s.touch_liver();
  for (Guest* guest : {&s.ada, &s.eve}) {
    ASSERT_EQ(guest->replica.panels().size(), 1u);
    const Panel& panel = guest->replica.panels().at(s.ada.id);
    EXPECT_EQ(panel.body, liver);
    const Vec3 to_head = (Vec3(0, 0.5, 0.6) - panel.pose.p).normalized();
    EXPECT_GT((panel.pose.q * Vec3::UnitZ()).dot(to_head), 0.99);
  }
  Guest late = s.hosted.guest(3, BusEnd::observer);
  late.greet("late", Role::observer);
  s.tick(3);
  late.take();
  EXPECT_EQ(late.replica.panels().size(), 1u);
}

TEST(PanelSession, AFingerPressesAButtonAndPartAndPictureFollow) {
  Session s;
  s.touch_liver();
  ASSERT_FALSE(s.eve.replica.panels().empty());
  s.press(PanelControl::transparency);
  EXPECT_TRUE(s.control(s.eve, PanelControl::transparency).on);
  ASSERT_NE(s.eve.replica.part(liver), nullptr);
  EXPECT_LT(s.eve.replica.part(liver)->opacity, 1);
  s.press(PanelControl::transparency);
  EXPECT_FALSE(s.control(s.eve, PanelControl::transparency).on);
  EXPECT_EQ(s.eve.replica.part(liver)->opacity, 1);
  s.press(PanelControl::room_lights);
  EXPECT_LT(s.eve.replica.room_lights(), 0.5);
  s.press(PanelControl::hide_others);
  ASSERT_NE(s.eve.replica.part(bone), nullptr);
  EXPECT_TRUE(s.eve.replica.part(bone)->hidden);
  EXPECT_EQ(s.eve.replica.part(liver)->hidden, false);
}

TEST(PanelSession, AButtonThatRefusesTellsItsUserWhy) {
  SceneDesc scene = scene_with_parts();
  scene.soft[0].snap = 0;  // a block that sags is never near enough
  Session s(nullptr, scene);
  s.touch_liver();
  ASSERT_FALSE(s.eve.replica.panels().empty());
  s.press(PanelControl::attach);
  ASSERT_NE(s.eve.replica.part(liver), nullptr);
  ASSERT_FALSE(s.eve.replica.part(liver)->attached) << "the first press detaches";
  s.ada.results.clear();
  s.eve.results.clear();
  s.press(PanelControl::attach);
  EXPECT_FALSE(s.eve.replica.part(liver)->attached);
  ASSERT_EQ(s.ada.results.size(), 1u);
  EXPECT_NE(s.ada.results[0].reason.find("cm from its original position"), std::string::npos)
      << s.ada.results[0].reason;
  EXPECT_TRUE(s.eve.results.empty()) << "it is for who pressed";
}

TEST(PanelSession, AFingerMovesTheSlider) {
  Session s;
  s.touch_liver();
  ASSERT_FALSE(s.eve.replica.panels().empty());
  const Panel panel = s.eve.replica.panels().at(s.ada.id);
  const Vec3 knob = control_face(describe(PanelControl::stiffness), 0.5);
  s.hold(pointing_at(panel, knob + Vec3(-0.035, 0, 0.06)), 30);
  for (int i = 0; i <= 60; ++i)
    s.hold(pointing_at(panel, knob + Vec3(-0.035 + 0.001 * i, 0, 0.004 - knob_height)), 1);
  s.hold(pointing_at(panel, knob + Vec3(0.0, 0.05, 0.1)), 30);
  const double position = s.control(s.eve, PanelControl::stiffness).position;
  EXPECT_GT(position, 0.55);
  ASSERT_NE(s.eve.replica.part(liver), nullptr);
  EXPECT_NEAR(s.eve.replica.part(liver)->stiffness, stiffness_at(position), 0.02);
}

TEST(PanelSession, AHandThatPressesIsToldWithWhatForce) {
  Session s;
  for (std::uint64_t t = 0; t < 80; ++t) s.hold({test::press(t), Quat::Identity()}, 1, {});
  const ContactSample* contact = s.eve.replica.contact(s.ada.id, right_hand);
  ASSERT_NE(contact, nullptr);
  ASSERT_TRUE(contact->touching);
  EXPECT_LT(contact->force.y(), -0.1) << "down";
  const double together = contact->impulse * s.hosted.simulation.scene().tick_rate;
  EXPECT_LE(contact->force.norm(), together * (1 + 1e-5));
  EXPECT_GT(contact->force.norm(), 0.5 * together);
}

TEST(PanelSession, CommandsAreForOnesOwnPanelOnly) {
  Session s;
  const OpenPanel open{bone};
  EXPECT_FALSE(s.ask(s.eve, open).accepted) << "an observer";
  EXPECT_FALSE(s.ask(s.ada, OpenPanel{0}).accepted) << "the table";
  EXPECT_FALSE(s.ask(s.ada, OpenPanel{99}).accepted);
  const SetControl light{PanelControl::light_shaft, 1};
  EXPECT_FALSE(s.ask(s.ada, light).accepted) << "no panel yet";
  EXPECT_FALSE(s.ask(s.ada, ClosePanel{}).accepted);
  EXPECT_TRUE(s.ask(s.ada, open).accepted);
  ASSERT_EQ(s.eve.replica.panels().size(), 1u);
  EXPECT_EQ(s.eve.replica.panels().at(s.ada.id).body, bone);
  Guest bob = s.hosted.guest(4, BusEnd::dissector);
  bob.greet("bob", Role::dissector);
  s.tick(2);
  bob.take();
  EXPECT_FALSE(s.ask(bob, light).accepted);
  EXPECT_TRUE(s.ask(s.ada, light).accepted);
  s.tick(2);
  EXPECT_TRUE(s.control(s.eve, PanelControl::light_shaft).on);
  EXPECT_TRUE(s.eve.replica.part(bone)->lit);
  EXPECT_TRUE(s.ask(s.ada, ClosePanel{}).accepted);
  s.tick(2);
  EXPECT_TRUE(s.eve.replica.panels().empty());
}

TEST(PanelSession, ItsOwnerPutsItSomewhereForEveryoneAndBack) {
  Session s;
  OpenPanel put{liver, PanelPlacement::put, {0.3, 1.4, -0.2}};
  EXPECT_FALSE(s.ask(s.ada, put).accepted) << "no panel yet";
  s.ask(s.ada, OpenPanel{liver});
  const Pose first = s.eve.replica.panels().at(s.ada.id).pose;
  EXPECT_FALSE(s.ask(s.eve, put).accepted) << "an observer, and not hers";
  EXPECT_TRUE(s.ask(s.ada, put).accepted);
  s.tick(2);
  EXPECT_LT((s.eve.replica.panels().at(s.ada.id).pose.p - put.at).norm(), 1e-6);
  put.placing = PanelPlacement::put_back;
  EXPECT_TRUE(s.ask(s.ada, put).accepted);
  s.tick(2);
  EXPECT_LT((s.eve.replica.panels().at(s.ada.id).pose.p - first.p).norm(), 1e-6);
  put.placing = static_cast<PanelPlacement>(fmt::underlying(last_panel_placement) + 1);
  EXPECT_FALSE(s.ask(s.ada, put).accepted) << "no such way";
}

TEST(PanelSession, ItGoesWithItsOwner) {
  Session s;
  s.ask(s.ada, OpenPanel{liver});
  ASSERT_EQ(s.eve.replica.panels().size(), 1u);
  s.ada.command(Leave{});
  s.tick(3);
  EXPECT_TRUE(s.eve.replica.panels().empty());
  EXPECT_TRUE(s.hosted.simulation.panels().empty());
}

TEST(PanelSession, ATabletIsThePanelForEveryoneUntilItIsLost) {
  Session s;
  const auto show = [&](const Pose& board, bool seen, int ticks) {
    for (int i = 0; i < ticks; ++i) {
      HandInput input = s.ada.hand_at({0, 0.4, 0.3});
      input.held[static_cast<std::size_t>(HeldObject::tablet)] = {seen, board};
      s.ada.bus->publish(input);
      s.tick();
    }
  };
  for (int k = 0; k < 10; ++k) {
    const Pose board{Vec3(0.01 * k, 0.5, 0.2), Quat(Eigen::AngleAxisd(-0.1 * k, Vec3::UnitX()))};
    show(board, true, 4);
    ASSERT_EQ(s.eve.replica.panels().size(), 1u);
    const Panel& panel = s.eve.replica.panels().at(s.ada.id);
    EXPECT_EQ(panel.body, bone) << "the first part";
    EXPECT_LT((panel.pose.p - board.p).norm(), 1e-6);
    EXPECT_LT(panel.pose.q.angularDistance(board.q), 1e-3);
  }
  const Pose last = s.eve.replica.panels().at(s.ada.id).pose;
  const OpenPanel back{bone, PanelPlacement::put_back};
  show({}, false, 60);
  s.ask(s.ada, back);
  EXPECT_EQ(s.eve.replica.panels().at(s.ada.id).pose.p, last.p) << "it rests";
  show({}, false, 240);
  s.ask(s.ada, back);
  EXPECT_NE(s.eve.replica.panels().at(s.ada.id).pose.p, last.p) << "it was let go";
  show(last, true, 4);
  s.ada.command(Leave{});
  s.tick(3);
  EXPECT_TRUE(s.eve.replica.panels().empty()) << "it goes with its owner";
}

/// Whither a head faces is told, however it looks down, once it turned enough.
TEST(PanelSession, AHeadIsToldWithTheDirectionThatItFaces) {
  PanelInputs inputs({true}, 60);
  HandInput input;
  input.head_tracked = true;
  const auto heads_after = [&](double turned, double down) {
    input.head.q = Quat(Eigen::AngleAxisd(turned, Vec3::UnitY()) * Eigen::AngleAxisd(-down, Vec3::UnitX()));
    inputs.see(7, input, true);
    TickInput out;
    inputs.consume([](ParticipantId) { return true; }, out);
    return out.heads;
  };
  ASSERT_EQ(heads_after(0, 1.5).size(), 1u);
  EXPECT_TRUE(heads_after(0, 0.3).empty()) << "it looks up, where it was, in the same direction";
  EXPECT_TRUE(heads_after(0.02, 1.5).empty());
  const std::vector<panel::HeadPlace> turned = heads_after(1.2, 1.5);
  ASSERT_EQ(turned.size(), 1u);
  EXPECT_NEAR((turned[0].ahead - Vec3(-std::sin(1.2), 0, -std::cos(1.2))).norm(), 0, 1e-12);
  input.head.q = Quat(Eigen::AngleAxisd(1.5707963, Vec3::UnitZ()));  // it lies on its side
  inputs.see(7, input, true);
  TickInput out;
  inputs.consume([](ParticipantId) { return true; }, out);
  ASSERT_EQ(out.heads.size(), 1u);
  EXPECT_EQ(out.heads[0].ahead, Vec3::Zero());
}

TEST(PanelSession, InputsAreKeptBitForBit) {
  ConsumedInput input;
  input.input.heads = {{7, {0.1, 1.5, -0.2}, {1, 0, 0}}, {9, {1e-300, 2, 3}, {0, 0, 0}}};
  input.input.panels = {{panel::PanelEvent::Kind::open, 7, 3, PanelControl::attach, 0},
                        {panel::PanelEvent::Kind::set, 9, 0, PanelControl::stiffness, 0.123456789}};
  const auto bytes = encode_input(input);
  const ConsumedInput back = decode_input(bytes);
  EXPECT_EQ(encode_input(back), bytes);
  ASSERT_EQ(back.input.heads.size(), 2u);
  EXPECT_EQ(back.input.heads[0].ahead, Vec3(1, 0, 0));
  EXPECT_EQ(back.input.heads[1].at, input.input.heads[1].at);
  ASSERT_EQ(back.input.panels.size(), 2u);
  EXPECT_EQ(back.input.panels[1].control, PanelControl::stiffness);
  EXPECT_EQ(back.input.panels[1].value, 0.123456789);
}

/// The same inputs, for another number of threads, and from a checkpoint in the middle of a press.
TEST(PanelSession, SameInputsSameHash) {
  const SceneDesc scene = scene_with_parts();
  std::vector<TickInput> inputs;
  const auto hand = [&](const Pose& wrist, const std::array<double, fingers>& flexion) {
    TickInput input;
    if (inputs.empty()) input.events.push_back({HandEvent::Kind::appear, 7, right_hand, 0});
    input.targets.push_back({7, right_hand, wrist, flexion});
    inputs.push_back(input);
  };
  Simulation first(scene, test::options(1));
  std::vector<std::uint64_t> hashes;
  const auto step = [&] {
    first.step(inputs.back());
    hashes.push_back(first.state_hash());
  };
  for (std::uint64_t t = 0; t < 80; ++t) {
    hand({test::press(t), Quat::Identity()}, {});
    if (t == 5) inputs.back().heads = {{7, {0, 0.5, 0.6}, {0, 0, -1}}};
    step();
  }
  ASSERT_EQ(first.panels().size(), 1u);
  const Panel panel = first.panels()[0];
  const Vec3 face = control_face(describe(PanelControl::hide_others), 0);
  for (int t = 0; t < 60; ++t) {
    hand(pointing_at(panel, {face.x(), face.y(), 0.09 - 0.0016 * t}), pointing);
    step();
  }
  EXPECT_TRUE(first.part(bone).hidden) << "it was pressed";
  const std::size_t middle = 130;
  Simulation again(scene, test::options(3)), from_middle(scene, test::options(1)),
      through(scene, test::options(1));
  std::vector<std::uint8_t> saved;
  for (std::size_t t = 0; t < inputs.size(); ++t) {
    again.step(inputs[t]);
    ASSERT_EQ(again.state_hash(), hashes[t]) << t;
    if (t == middle) {
      saved = through.checkpoint();
      from_middle.restore(saved);
      EXPECT_EQ(from_middle.state_hash(), through.state_hash());
    }
    through.step(inputs[t]);
    if (t < middle) continue;
    from_middle.step(inputs[t]);
    ASSERT_EQ(from_middle.state_hash(), through.state_hash()) << t;
  }
}

}  // namespace
}  // namespace prosector
