#pragma once
// A room in which panels are worked.

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "server/physics/base/record.h"
#include "tests/panel/fingers.h"

namespace prosector::test {

inline constexpr ParticipantId ada = 5, eve = 9;
inline constexpr BodyId liver = 3, kidney = 4, table = 0;

/// Bodies that do what their panel says.
struct Bodies : panel::PanelSubjects {
  std::map<BodyId, panel::ShownControls> parts = {{liver, {1, 0, 0, 0, 1, 0.5}},
                                                  {kidney, {1, 0, 0, 0, 1, 0.5}}};
  bool has_panel(BodyId body) const override { return parts.contains(body); }
  std::pair<Vec3, Vec3> box(BodyId) const override { return {{-0.05, 1, -0.05}, {0.05, 1.1, 0.05}}; }
  panel::ShownControls shown(BodyId body) const override { return parts.at(body); }
  std::optional<BodyId> first() const override { return parts.begin()->first; }
};

struct Room {
  Bodies bodies;
  panel::PanelWorld world{tick};
  std::vector<panel::PanelAction> actions;

  void step(std::vector<panel::PanelHand> hands) {
    std::sort(hands.begin(), hands.end(), [](const auto& a, const auto& b) { return a.who < b.who; });
    for (const panel::PanelAction& action : world.step(hands, bodies)) {
      actions.push_back(action);
      bodies.parts[action.body][index_of(action.control)] = action.value;
    }
    world.show(bodies);
  }
  void step(const panel::PanelHand& hand, int times = 1) {
    for (int i = 0; i < times; ++i) step(std::vector{hand});
  }
  void event(panel::PanelEvent::Kind kind, ParticipantId who, BodyId body = 0,
             PanelControl control = PanelControl::attach, double value = 0) {
    world.take(panel::PanelEvent{kind, who, body, control, value}, bodies);
  }
  std::vector<std::uint8_t> saved() const {
    ByteWriter out;
    RecordWriter io(out);
    world.save(io);
    return out.bytes();
  }
};

/// Reads a saved world, all of its bytes. Throws InputError.
inline void load(panel::PanelWorld& world, std::span<const std::uint8_t> bytes, std::size_t bodies) {
  ByteReader in(bytes, "panels");
  RecordReader io(in);
  world.load(io, bodies);
  in.end();
}

inline panel::PanelHand hand(ParticipantId who, std::optional<BodyId> touches = {}) {
  panel::PanelHand out;
  out.who = {who, right_hand};
  out.palm = {0, 1.1, 0.3};
  out.fingers = {finger_at({0, 1.1, 0.2})};
  out.touches = touches;
  out.touched_at = {0.01, 1.1, 0};
  return out;
}

/// A hand whose fingertip is somewhere before somebody's panel.
inline panel::PanelHand at_panel(const Room& room, ParticipantId who, const panel::Capsule& in_panel) {
  const Pose pose = room.world.panels().front().pose;
  panel::PanelHand out = hand(who);
  out.palm = pose * Vec3(0, 0, 0.1);
  out.fingers = {{pose * in_panel.a, pose * in_panel.b, in_panel.radius}};
  return out;
}

inline void press(Room& room, ParticipantId who, PanelControl control) {
  for (const double height : {0.03, 0.02, 0.01, 0.004, -0.002, -0.002, -0.002, 0.01, 0.03, 0.05})
    room.step(at_panel(room, who, over(control, height)));
  room.step(hand(who), 20);
}

inline int moment() {
  return static_cast<int>(std::ceil(panel::touch_moment / tick));
}

}  // namespace prosector::test
