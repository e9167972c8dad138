#include "server/session/people/member_hands.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace prosector {
namespace {

/// Returns the force with which an arm pushes the hand back, N; nothing: no arm moves it. A force that is
/// older than `timeout` ticks counts as 0.
std::optional<double> reaction(const Participant& member, const Seat& seat, std::size_t hand,
                               std::uint64_t tick, std::uint64_t timeout) {
  if ((member.presence.arms >> hand & 1) == 0) return std::nullopt;
  const ArmReaction& last = seat.reactions[hand];
  return tick - last.tick > timeout ? 0 : last.force;
}

}  // namespace

void MemberHands::consume(const Participant& member, Seat& seat, std::uint64_t tick, TickInput& out,
                          SessionOutput& output) {
  for (std::size_t h = 0; h < 2; ++h) consume_hand(member, h, seat, tick, out, output);
}

void MemberHands::consume_hand(const Participant& member, std::size_t h, Seat& seat, std::uint64_t tick,
                               TickInput& out, SessionOutput& output) {
  const ParticipantId id = member.presence.participant;
  MemberHand& hand = seat.hands[h];
  const bool is_seen = seat.input && seat.input->hands[h].tracked;
  if (seat.fresh && is_seen) {
    const HandPose& pose = seat.input->hands[h];
    hand.target = {id,
                   h,
                   pose.pose,
                   pose.flexion,
                   (pose.buttons & draws_cut) != 0,
                   reaction(member, seat, h, tick, input_timeout_)};
    hand.tracked_tick = tick;
    if (!hand.present) {
      out.events.push_back({HandEvent::Kind::appear, id, h, BodyId{0}});
      hand.regrasps = lost_holds_.take({id, static_cast<std::uint8_t>(h)});
      if (hand.regrasps) out.events.push_back({HandEvent::Kind::regrasp, id, h, *hand.regrasps});
    }
    hand.present = true;
    out.targets.push_back(hand.target);
    return;
  }
  if (!hand.present) return;
  if (is_seen && tick - seat.heard_tick <= stall_timeout_) {
    hand.tracked_tick = tick;
    return;
  }
  if (!is_seen && tick - hand.tracked_tick <= input_timeout_) return;
  out.events.push_back({HandEvent::Kind::vanish, id, h, BodyId{0}});
  hand.present = false;
  hand.loss = is_seen ? HandLoss::stalled : HandLoss::untracked;
  ++timeouts_;
  output.log({is_seen ? SessionEvent::Kind::hand_stalled : SessionEvent::Kind::hand_timeout, id,
              member.presence.name, h == left_hand ? "left hand" : "right hand"});
}

void MemberHands::vanish(ParticipantId id, const Seat& seat) {
  for (std::size_t h = 0; h < 2; ++h)
    if (seat.hands[h].present) vanishing_.push_back({HandEvent::Kind::vanish, id, h, BodyId{0}});
}

void MemberHands::vanish(std::span<const HandState> hands) {
  for (const HandState& h : hands)
    vanishing_.push_back({HandEvent::Kind::vanish, h.participant, h.hand, BodyId{0}});
}

std::vector<HandEvent> MemberHands::take_vanishing() {
  std::stable_sort(vanishing_.begin(), vanishing_.end(), [](const HandEvent& a, const HandEvent& b) {
    return std::pair(a.participant, a.hand) < std::pair(b.participant, b.hand);
  });
  return std::exchange(vanishing_, {});
}

void MemberHands::note_loss(const LetGo& let_go, const Seat* seat, std::uint64_t tick) {
  const HandRef hand{let_go.participant, static_cast<std::uint8_t>(let_go.hand)};
  const bool is_stalled = seat != nullptr && seat->hands[let_go.hand].loss == HandLoss::stalled;
  if (cut_off_.contains(let_go.participant) || is_stalled) lost_holds_.note(hand, let_go.body, tick);
}

std::vector<ReleasedHolds::Lost> MemberHands::finish_tick(std::span<const HandState> hands,
                                                          std::uint64_t tick) {
  cut_off_.clear();
  return lost_holds_.follow(hands, tick);
}

void tell_of_loss(const LetGo& let_go, const Seat& seat, const SessionRules& rules, SessionOutput& output) {
  const MemberHand& hand = seat.hands[let_go.hand];
  if (seat.opens[let_go.hand]) return;
  if (hand.present) return output.tell(let_go.participant, "your hand released it: " + let_go.why);
  if (hand.loss == HandLoss::none) return;
  output.tell(let_go.participant,
              fmt::format("your hand released the {}: {}", rules.name_of(let_go.body),
                          hand.loss == HandLoss::stalled ? "your client sent nothing for too long"
                                                         : "your hand was no longer tracked"));
}

void finish_regrasps(ParticipantId id, Seat& seat, std::span<const HandState> hands,
                     const SessionRules& rules, SessionOutput& output) {
  for (std::size_t h = 0; h < 2; ++h) {
    MemberHand& hand = seat.hands[h];
    hand.loss = HandLoss::none;
    const auto body = std::exchange(hand.regrasps, std::nullopt);
    const bool holds = std::ranges::any_of(hands, [&](const HandState& state) {
      return state.participant == id && state.hand == h && state.holding == body;
    });
    if (body && !holds)
      output.tell(id,
                  fmt::format("the {} is out of your hand's reach: grasp it again", rules.name_of(*body)));
  }
}

void answer_grasps(ParticipantId id, Seat& seat, std::span<const HandState> hands, const StepReport& report,
                   SessionOutput& output) {
  for (const PendingGrasp& grasp : seat.grasps) {
    const bool holds = std::any_of(hands.begin(), hands.end(), [&](const HandState& h) {
      return h.participant == id && h.hand == grasp.hand && h.holding;
    });
    const bool carries = std::binary_search(report.panel_carriers.begin(), report.panel_carriers.end(),
                                            HandRef{id, grasp.hand});
    output.answer(grasp.command, holds || carries ? Refusal() : "nothing within reach");
  }
  seat.grasps.clear();
  seat.opens = {};
}

}  // namespace prosector
