// Wire conversion of hand messages: HandInput, UserState, ContactSample.

#include "idl/wire/fields.h"

namespace prosector {
namespace {

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

template <class Io>
void fields(Io& io, MessageOf<Io, HandPose>& m, WireOf<Io, prosector_HandPose>& w) {
  io(m.tracked, w.tracked);
  io(m.gesture, w.gesture);
  io(m.pose, w.pose);
  for (std::size_t i = 0; i < fingers; ++i) io(m.flexion[i], w.flexion[i]);
  io(m.buttons, w.buttons);
}

template <class Io>
void fields(Io& io, MessageOf<Io, HeldPose>& m, WireOf<Io, prosector_HeldPose>& w) {
  io(m.tracked, w.tracked);
  io(m.pose, w.pose);
}

template <class Io>
void fields(Io& io, MessageOf<Io, HandInput>& m, WireOf<Io, prosector_HandInput>& w) {
  io(m.participant, w.participant);
  io(m.sequence, w.number);
  io(m.time_ns, w.time_ns);
  io(m.head_tracked, w.head_tracked);
  io(m.head, w.head);
  for (std::size_t i = 0; i < 2; ++i) fields(io, m.hands[i], w.hands[i]);
  for (std::size_t i = 0; i < held_things; ++i) fields(io, m.held[i], w.held[i]);
}

template <class Io>
void fields(Io& io, MessageOf<Io, UserState>& m, WireOf<Io, prosector_UserState>& w) {
  io(m.participant, w.participant);
  io(m.time, w.time);
  io(m.input_sequence, w.input_number);
  io(m.head_tracked, w.head_tracked);
  io(m.head, w.head);
  for (std::size_t i = 0; i < 2; ++i) fields(io, m.hands[i], w.hands[i]);
}

template <class Io>
void fields(Io& io, MessageOf<Io, ContactSample>& m, WireOf<Io, prosector_ContactSample>& w) {
  io(m.participant, w.participant);
  io(m.hand, w.hand);
  io(m.time, w.time);
  io(m.touching, w.touching);
  io(m.body, w.body);
  io(m.point, w.touch_point);
  io(m.normal, w.normal);
  io(m.depth, w.depth);
  io(m.impulse, w.impulse);
  io(m.local_point, w.local_point);
  io(m.force, w.force);
  io(m.impact, w.impact);
}

}  // namespace

PROSECTOR_WIRE_BY_FIELDS(HandInput);

Refusal check(HandInput& m) {
  for (HeldPose& held : m.held)
    if (const Refusal pose = check_pose(held.pose)) return pose;
  return check_user(m);
}

PROSECTOR_WIRE_BY_FIELDS(UserState);

Refusal check(UserState& m) {
  return check_user(m);
}

PROSECTOR_WIRE_BY_FIELDS(ContactSample);

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
