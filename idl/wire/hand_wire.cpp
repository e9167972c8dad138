// Wire conversion of hand messages: HandInput, UserState, ContactSample.

#include "idl/wire/primitives.h"

namespace prosector {
namespace {

void hand_to_wire(const HandPose& m, prosector_HandPose& w) {
  w.tracked = m.tracked;
  w.gesture = static_cast<std::uint8_t>(m.gesture);
  to_wire(m.pose, w.pose);
  for (std::size_t i = 0; i < fingers; ++i) w.flexion[i] = static_cast<float>(m.flexion[i]);
  w.buttons = m.buttons;
}

HandPose hand_from_wire(const prosector_HandPose& w) {
  HandPose m;
  m.tracked = w.tracked != 0;
  m.gesture = static_cast<Gesture>(w.gesture);
  m.pose = from_wire(w.pose);
  for (std::size_t i = 0; i < fingers; ++i) m.flexion[i] = w.flexion[i];
  m.buttons = w.buttons;
  return m;
}

Refusal check_hand(HandPose& m) {
  if (const Refusal pose = check_pose(m.pose)) return pose;
  Checks checks;
  for (const double x : m.flexion)
    checks.that(within(x, -flexion_slack, 1 + flexion_slack), "flexion outside [0, 1]");
  return checks.that(enum_within(m.gesture, Gesture::four), "unknown gesture").refusal();
}

template <class M>
Refusal check_user(M& m) {
  if (m.participant == 0) return "participant id 0";
  if (const Refusal head = check_pose(m.head)) return head;
  for (HandPose& hand : m.hands)
    if (const Refusal refusal = check_hand(hand)) return refusal;
  return {};
}

}  // namespace

void to_wire(const HandInput& m, prosector_HandInput& w, WireArena&) {
  w.participant = m.participant;
  w.number = m.sequence;
  w.time_ns = m.time_ns;
  w.head_tracked = m.head_tracked;
  to_wire(m.head, w.head);
  for (std::size_t i = 0; i < 2; ++i) hand_to_wire(m.hands[i], w.hands[i]);
  for (std::size_t i = 0; i < held_things; ++i) {
    w.held[i].tracked = m.held[i].tracked;
    to_wire(m.held[i].pose, w.held[i].pose);
  }
}

Refusal from_wire(const prosector_HandInput& w, HandInput& m) {
  m.participant = w.participant;
  m.sequence = w.number;
  m.time_ns = w.time_ns;
  m.head_tracked = w.head_tracked != 0;
  m.head = from_wire(w.head);
  for (std::size_t i = 0; i < 2; ++i) m.hands[i] = hand_from_wire(w.hands[i]);
  for (std::size_t i = 0; i < held_things; ++i)
    m.held[i] = {w.held[i].tracked != 0, from_wire(w.held[i].pose)};
  return {};
}

Refusal check(HandInput& m) {
  for (HeldPose& held : m.held)
    if (const Refusal pose = check_pose(held.pose)) return pose;
  return check_user(m);
}

void to_wire(const UserState& m, prosector_UserState& w, WireArena&) {
  w.participant = m.participant;
  w.time = to_wire(m.time);
  w.input_number = m.input_sequence;
  w.head_tracked = m.head_tracked;
  to_wire(m.head, w.head);
  for (std::size_t i = 0; i < 2; ++i) hand_to_wire(m.hands[i], w.hands[i]);
}

Refusal from_wire(const prosector_UserState& w, UserState& m) {
  m.participant = w.participant;
  m.time = from_wire(w.time);
  m.input_sequence = w.input_number;
  m.head_tracked = w.head_tracked != 0;
  m.head = from_wire(w.head);
  for (std::size_t i = 0; i < 2; ++i) m.hands[i] = hand_from_wire(w.hands[i]);
  return {};
}

Refusal check(UserState& m) {
  return check_user(m);
}

void to_wire(const ContactSample& m, prosector_ContactSample& w, WireArena&) {
  w.participant = m.participant;
  w.hand = m.hand;
  w.time = to_wire(m.time);
  w.touching = m.touching;
  w.body = m.body;
  to_wire(m.point, w.touch_point);
  to_wire(m.normal, w.normal);
  w.depth = static_cast<float>(m.depth);
  w.impulse = static_cast<float>(m.impulse);
  to_wire(m.local_point, w.local_point);
  to_wire(m.force, w.force);
  w.impact = static_cast<float>(m.impact);
}

Refusal from_wire(const prosector_ContactSample& w, ContactSample& m) {
  m.participant = w.participant;
  m.hand = w.hand;
  m.time = from_wire(w.time);
  m.touching = w.touching != 0;
  m.body = w.body;
  m.point = from_wire(w.touch_point);
  m.normal = from_wire(w.normal);
  m.depth = w.depth;
  m.impulse = w.impulse;
  m.local_point = from_wire(w.local_point);
  m.force = from_wire(w.force);
  m.impact = w.impact;
  return {};
}

Refusal check(ContactSample& m) {
  constexpr double max_impulse = 1e6;  // N·s: far beyond human hands, but finite
  constexpr double max_force = 1e9;    // N: force of that impulse within a short tick
  return Checks()
      .that(m.participant != 0, "participant id 0")
      .that(m.hand <= right_hand, "no such hand")
      .that(m.body < max_bodies, "no such body")
      .that(within(m.point, max_coordinate), "point out of range")
      .that(within(m.normal, 1 + quaternion_slack), "normal out of range")
      .that(within(m.depth, -max_coordinate, max_coordinate), "depth out of range")
      .that(within(m.impulse, 0, max_impulse), "impulse out of range")
      .that(within(m.local_point, 2 * max_coordinate),
            "the contact point in the body's frame is out of range")
      .that(within(m.force, max_force), "force out of range")
      .that(within(m.impact, -1, 1), "the contact's time of impact is out of range")
      .refusal();
}

}  // namespace prosector
