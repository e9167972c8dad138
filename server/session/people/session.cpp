#include "server/session/people/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "common/assert.h"
#include "common/role_words.h"

namespace prosector {
namespace {

// Limits memory, since any process can become a visitor.
constexpr std::size_t max_visitors = 1024;
// More commands in a tick than a user can give; any more are dropped.
constexpr std::uint32_t max_commands_per_tick = 16;
constexpr std::size_t max_outgoing = 4096;  // limit between two ticks

}  // namespace

Session::Session(const SessionRules& rules)
    : rules_(rules),
      roster_(rules),
      lost_holds_(rules.regrasp_timeout),
      panels_(rules.parts, rules.input_timeout),
      pacing_(rules.recording ? max_pace : 1) {}

ConsumedInput Session::consume(std::span<const Received> received, std::uint64_t tick) {
  PROSECTOR_ASSERT(tick >= tick_);
  tick_ = tick;
  take_all(received);

  ConsumedInput out;
  // Hands of members that left come first: an id that rejoins in the same tick starts with new hands.
  std::stable_sort(vanishing_.begin(), vanishing_.end(), [](const HandEvent& a, const HandEvent& b) {
    return std::pair(a.participant, a.hand) < std::pair(b.participant, b.hand);
  });
  out.input.events.swap(vanishing_);
  out.input.efforts.swap(efforts_);
  for (auto& [id, seat] : seats_) consume_seat(id, seat, out);
  const auto may_touch = [&](ParticipantId id) {
    const Participant* member = roster_.find(id);
    return member != nullptr && member->role != Role::observer;
  };
  panels_.consume(may_touch, out.input);
  forget_visitors();
  return out;
}

void Session::listen(std::span<const Received> received) {
  take_all(received);
}

void Session::take_all(std::span<const Received> received) {
  for (auto& [id, seat] : seats_) seat.commands = 0;
  for (const Received& r : received) take(r);
  settle_joins();
}

void Session::take(const Received& received) {
  if (received.writer == 0) return drop("from an unknown process");
  if (const auto* p = std::get_if<Presence>(&received.message)) return take(*p, received);
  if (received.liveness == Liveness::gone) return;  // the end of a stream is ignored: Presence decides
  if (const auto* input = std::get_if<HandInput>(&received.message)) return take(*input, received.writer);
  if (const auto* command = std::get_if<Command>(&received.message)) return take(*command, received.writer);
  if (const auto* force = std::get_if<ArmForce>(&received.message)) return take(*force, received.writer);
  drop("not a message for a server");
}

void Session::take(const Presence& presence, const Received& received) {
  const ParticipantId id = presence.participant;
  Participant* member = roster_.find(id);
  if (received.liveness == Liveness::gone) {
    const auto it = visitors_.find(id);
    const std::uint64_t owner = member != nullptr       ? member->writer
                                : it != visitors_.end() ? it->second.writer
                                                        : 0;
    if (owner == 0) return;  // of a visitor that was forgotten
    if (received.writer != owner)
      return drop("Presence: discarded, because another process than the participant's reported its end");
    if (member != nullptr)
      leave(id, SessionEvent::Kind::lost);
    else
      it->second.join.reset();
    return;
  }
  if (member != nullptr) {
    if (member->writer != received.writer) return drop("Presence: another process's participant");
    if (presence.name != member->presence.name || presence.role != member->presence.role)
      return drop("Presence: discarded, because it changes the name or role of a participant in the session");
    member->presence = presence;  // a role assigned since then stays
    outgoing_.push_back({Roster::entry(*member)});
    return;
  }
  Visitor* v = visitor(id, received.writer, "Presence: another process's participant");
  if (v != nullptr) v->presence = presence;
}

void Session::take(const HandInput& input, std::uint64_t writer) {
  const Participant* member = roster_.find(input.participant);
  if (member == nullptr) {
    // Samples may arrive before their Presence, or after their sender has left.
    const auto it = visitors_.find(input.participant);
    if (it == visitors_.end())
      return drop("HandInput: discarded, because its participant is not in the session");
    if (it->second.writer != writer) return drop("HandInput: another process's participant");
    return;
  }
  if (member->writer != writer) return drop("HandInput: another process's participant");
  if (member->role == Role::observer) return drop("HandInput: from an observer");
  Seat& seat = seats_[input.participant];
  if (!admits(seat.sequences, input.sequence, "HandInput: numbering restarted")) return;
  seat.input = input;
  seat.fresh = true;
}

void Session::take(const Command& command, std::uint64_t writer) {
  const Participant* member = roster_.find(command.participant);
  if (member == nullptr) return take_of_visitor(command, writer);
  if (member->writer != writer) return drop("Command: another process's participant");
  Seat& seat = seats_[command.participant];
  if (++seat.commands > max_commands_per_tick)
    return drop("Command: discarded, because its participant sent too many commands in one tick");
  obey(command, *member, seat);
}

/// Processes a command of a sender that isn't a member: only joining and leaving are possible.
void Session::take_of_visitor(const Command& command, std::uint64_t writer) {
  if (std::holds_alternative<Join>(command.body)) {
    Visitor* v = visitor(command.participant, writer, "Command: another process's participant");
    if (v == nullptr) return;
    if (!v->join) v->join_tick = tick_;  // a repeated request does not restart the wait
    v->join = command;
    return;
  }
  const auto it = visitors_.find(command.participant);
  if (it == visitors_.end() || it->second.writer != writer)
    return drop("Command: discarded, because its participant is not in the session");
  answer(command, std::holds_alternative<Leave>(command.body) ? Refusal() : "join first");
}

/// Assigns the role at this tick. A member that becomes an observer loses hands and holds.
void Session::give(ParticipantId id, Role role) {
  PROSECTOR_ASSERT(roster_.find(id) != nullptr);
  Participant& member = *roster_.find(id);
  member.role = role;
  if (role == Role::observer) {
    Seat& seat = seats_[id];
    vanish_hands(id, seat);
    const std::uint32_t commands = seat.commands;
    seat = {};
    seat.commands = commands;
  }
  outgoing_.push_back({Roster::entry(member)});
  if (events_.size() < max_events)
    events_.push_back({SessionEvent::Kind::role, id, member.presence.name, role_word(role)});
}

void Session::add_body(const std::string& name, bool is_part) {
  ++rules_.bodies;
  rules_.names.push_back(name);
  panels_.add_body(is_part);
}

std::set<BodyId> Session::take_keyframe_requests() {
  return std::exchange(keyframes_, {});
}

void Session::vanish_hands(ParticipantId id, Seat& seat) {
  for (std::size_t h = 0; h < 2; ++h)
    if (seat.hands[h].present) vanishing_.push_back({HandEvent::Kind::vanish, id, h, BodyId{0}});
}

/// Decides on joins after all received samples were read, since Presence and join arrive separately.
void Session::settle_joins() {
  for (auto it = visitors_.begin(); it != visitors_.end();) {
    const ParticipantId id = it->first;
    Visitor& v = it->second;
    if (v.join) try_join(id, v);
    it = roster_.find(id) != nullptr ? visitors_.erase(it) : std::next(it);
  }
}

void Session::try_join(ParticipantId id, Visitor& v) {
  PROSECTOR_ASSERT(roster_.find(id) == nullptr && v.join.has_value());
  Refusal refusal;
  if (v.presence) {
    refusal = roster_.refusal(*v.presence);
    // A client that was killed and returns immediately meets its own entry, whose lease has not expired.
    if (roster_.in_anothers_place(*v.presence) && tick_ - v.join_tick < rules_.death_timeout) return;
  } else {
    if (tick_ - v.join_tick < rules_.presence_timeout) return;
    refusal = "your client's Presence message has not arrived in time: check the network and join again";
  }
  answer(*v.join, refusal);
  v.join.reset();
  const std::string name = v.presence ? v.presence->name : "";
  if (refusal) {
    if (events_.size() < max_events)
      events_.push_back({SessionEvent::Kind::refused, id, name, refusal.why()});
    return;
  }
  const Participant& member = roster_.admit(*v.presence, v.writer);
  seats_[id] = {};
  outgoing_.push_back({Roster::entry(member)});
  events_.push_back({SessionEvent::Kind::joined, id, name, role_word(member.role)});
  for (const ReleasedHolds::Lost& lost : lost_holds_.of(id))
    tell(id, fmt::format("your connection was lost, and your hand released the {}", name_of(lost.body)));
}

/// Removes the participant and its state. Its hands vanish at this tick.
void Session::leave(ParticipantId id, SessionEvent::Kind how) {
  PROSECTOR_ASSERT(roster_.find(id) != nullptr &&
                   (how == SessionEvent::Kind::left || how == SessionEvent::Kind::lost));
  const Participant member = *roster_.find(id);
  vanish_hands(id, seats_[id]);
  if (how == SessionEvent::Kind::lost) cut_off_.insert(id);
  events_.push_back({how, id, member.presence.name, role_word(member.role)});
  outgoing_.push_back({Roster::entry(member), true});
  seats_.erase(id);
  roster_.remove(id);
  // Stored as a visitor: after a network failure it may return without a new Presence.
  if (Visitor* v = visitor(id, member.writer, "")) v->presence = member.presence;
}

void Session::take(const ArmForce& force, std::uint64_t writer) {
  const Participant* member = roster_.find(force.participant);
  if (member == nullptr) return;  // it arrived before Presence, or its sender is leaving
  if (member->writer != writer) return drop("ArmForce: another process's participant");
  if (member->role == Role::observer) return drop("ArmForce: from an observer");
  if ((member->presence.arms >> force.hand & 1) == 0)
    return drop("ArmForce: discarded, because its participant has announced no haptic arm for this hand");
  Reaction& reaction = seats_[force.participant].reactions[force.hand];
  if (!admits(reaction.sequences, force.sequence, "ArmForce: numbering restarted")) return;
  reaction.tick = tick_;
  reaction.force = force.force.norm();
}

/// Returns whether a sample is the newest of its stream. If the stream's numbering restarts, that is counted
/// as `what`.
bool Session::admits(SequenceGate& sequences, std::uint64_t number, const char* what) {
  const SequenceGate::Verdict verdict = sequences.judge(number);
  if (verdict == SequenceGate::Verdict::restarted) drop(what);
  return verdict != SequenceGate::Verdict::overtaken;
}

/// Returns the force with which an arm pushes the hand back, N; nothing: no arm moves it. Too old a force
/// counts as 0.
std::optional<double> Session::reaction(ParticipantId id, const Seat& seat, std::size_t hand) const {
  if ((roster_.members().at(id).presence.arms >> hand & 1) == 0) return std::nullopt;
  const Reaction& last = seat.reactions[hand];
  return tick_ - last.tick > rules_.input_timeout ? 0 : last.force;
}

/// Makes a hand appear, follow its newest pose, or vanish. A stalled client's hands stay where they are, with
/// what they hold, until `stall_timeout`.
void Session::consume_hand(ParticipantId id, std::size_t h, Seat& seat, TickInput& out) {
  Hand& hand = seat.hands[h];
  const bool is_seen = seat.input && seat.input->hands[h].tracked;
  if (seat.fresh && is_seen) {
    const HandPose& pose = seat.input->hands[h];
    hand.target = {id, h, pose.pose, pose.flexion, (pose.buttons & draws_cut) != 0, reaction(id, seat, h)};
    hand.tracked_tick = tick_;
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
  if (is_seen && tick_ - seat.heard_tick <= rules_.stall_timeout) {
    hand.tracked_tick = tick_;
    return;
  }
  if (!is_seen && tick_ - hand.tracked_tick <= rules_.input_timeout) return;
  out.events.push_back({HandEvent::Kind::vanish, id, h, BodyId{0}});
  hand.present = false;
  hand.loss = is_seen ? Loss::stalled : Loss::untracked;
  ++hand_timeouts_;
  events_.push_back({is_seen ? SessionEvent::Kind::hand_stalled : SessionEvent::Kind::hand_timeout, id,
                     roster_.find(id)->presence.name, h == left_hand ? "left hand" : "right hand"});
}

void Session::consume_seat(ParticipantId id, Seat& seat, ConsumedInput& out) {
  PROSECTOR_ASSERT(roster_.find(id) != nullptr && (!seat.fresh || seat.input.has_value()));
  if (seat.fresh) seat.heard_tick = tick_;
  for (std::size_t h = 0; h < 2; ++h) consume_hand(id, h, seat, out.input);
  if (seat.fresh) {
    out.keys.push_back({id, seat.input->sequence});
    panels_.see(id, *seat.input, seat.hands[left_hand].present || seat.hands[right_hand].present);
  }
  seat.fresh = false;
  for (const HandEvent& e : seat.asked)
    if (e.kind == HandEvent::Kind::reset_body || seat.hands[e.hand].present) {
      out.input.events.push_back(e);
      if (e.kind == HandEvent::Kind::release) seat.opens[e.hand] = true;
    }
  seat.asked.clear();
  for (const PendingPart& part : seat.parts) {
    out.input.parts.push_back(part.event);
    stepping_.push_back(part.command);
  }
  seat.parts.clear();
  for (const PendingCut& cut : seat.cuts) {
    out.input.cuts.push_back(cut.event);
    cutting_.push_back(cut);
  }
  seat.cuts.clear();
}

void Session::finish_tick(std::span<const HandState> hands, const StepReport& report) {
  pacing_.finish_tick();
  for (std::size_t i = 0; i < std::min(stepping_.size(), report.part_answers.size()); ++i)
    answer(stepping_[i], report.part_answers[i]);
  stepping_.clear();
  for (std::size_t i = 0; i < cutting_.size(); ++i) {
    const auto& [command, event, rewinds_to] = cutting_[i];
    const Refusal refusal =
        i < report.cut_answers.size() ? report.cut_answers[i] : Refusal("nothing has been cut");
    answer(command, refusal);
    const bool rewound = !rewinds_to.empty() && !refusal;
    if (const Participant* member = roster_.find(command.participant); rewound && member != nullptr)
      events_.push_back(
          {SessionEvent::Kind::rewound, command.participant, member->presence.name, rewinds_to});
  }
  cutting_.clear();
  for (const PanelRefusal& refused : report.panel_refusals)
    if (roster_.find(refused.participant) != nullptr) tell(refused.participant, refused.why);
  for (const LetGo& let_go : report.let_go) take_loss(let_go);
  cut_off_.clear();
  for (const ReleasedHolds::Lost& lost : lost_holds_.follow(hands, tick_))
    if (roster_.find(lost.hand.participant) != nullptr)
      tell(lost.hand.participant, fmt::format("another hand took the {}", name_of(lost.body)));
  finish_hands(hands);
  for (auto& [id, seat] : seats_) {
    for (const PendingGrasp& grasp : seat.grasps) {
      const bool holds = std::any_of(hands.begin(), hands.end(), [&](const HandState& h) {
        return h.participant == id && h.hand == grasp.hand && h.holding;
      });
      const bool carries = std::binary_search(report.panel_carriers.begin(), report.panel_carriers.end(),
                                              HandRef{id, grasp.hand});
      answer(grasp.command, holds || carries ? Refusal() : "nothing within reach");
    }
    seat.grasps.clear();
    seat.opens = {};
  }
}

std::string Session::name_of(BodyId body) const {
  return body < rules_.names.size() ? rules_.names[body] : fmt::format("body {}", body);
}

/// Processes a hand's loss of its hold. After a stall or a broken connection the hand may grasp the body
/// again.
void Session::take_loss(const LetGo& let_go) {
  const HandRef hand{let_go.participant, static_cast<std::uint8_t>(let_go.hand)};
  const bool is_cut_off = cut_off_.contains(let_go.participant);
  const Participant* member = roster_.find(let_go.participant);
  const bool is_stalled =
      member != nullptr && seats_.at(let_go.participant).hands[let_go.hand].loss == Loss::stalled;
  if (is_cut_off || is_stalled) lost_holds_.note(hand, let_go.body, tick_);
  if (member == nullptr) return;
  events_.push_back({SessionEvent::Kind::let_go, let_go.participant, member->presence.name, let_go.why});
  tell_of_loss(let_go);
}

/// Informs the user that the hand lost its hold, unless a command opened it or the user is an observer now.
void Session::tell_of_loss(const LetGo& let_go) {
  const Seat& seat = seats_.at(let_go.participant);
  const Hand& hand = seat.hands[let_go.hand];
  if (seat.opens[let_go.hand]) return;
  if (hand.present) return tell(let_go.participant, "your hand released it: " + let_go.why);
  if (hand.loss == Loss::none) return;
  tell(let_go.participant, fmt::format("your hand released the {}: {}", name_of(let_go.body),
                                       hand.loss == Loss::stalled ? "your client sent nothing for too long"
                                                                  : "your hand was no longer tracked"));
}

/// Informs users if a hand could not grasp again what it lost in a stall.
void Session::finish_hands(std::span<const HandState> hands) {
  for (auto& [id, seat] : seats_)
    for (std::size_t h = 0; h < 2; ++h) {
      Hand& hand = seat.hands[h];
      hand.loss = Loss::none;
      const auto body = std::exchange(hand.regrasps, std::nullopt);
      const bool holds = std::ranges::any_of(hands, [&](const HandState& state) {
        return state.participant == id && state.hand == h && state.holding == body;
      });
      if (body && !holds)
        tell(id, fmt::format("the {} is out of your hand's reach: grasp it again", name_of(*body)));
    }
}

void Session::tell(ParticipantId participant, const std::string& words) {
  if (outgoing_.size() >= max_outgoing)
    return drop("a message to a participant was discarded, because too many are waiting to be sent");
  outgoing_.push_back({CommandResult{participant, 0, false, words}});
}

void Session::vanish(std::span<const HandState> hands) {
  for (const HandState& h : hands)
    vanishing_.push_back({HandEvent::Kind::vanish, h.participant, h.hand, BodyId{0}});
}

/// Returns the visitor. Null when the id belongs to another process (counted as `what`), or when there are
/// too many visitors.
Session::Visitor* Session::visitor(ParticipantId id, std::uint64_t writer, const char* what) {
  if (id == 0) {
    drop("participant id 0");
    return nullptr;
  }
  auto it = visitors_.find(id);
  if (it == visitors_.end()) {
    if (visitors_.size() >= max_visitors) {
      drop("too many visitors");
      return nullptr;
    }
    it = visitors_.emplace(id, Visitor{}).first;
    it->second.writer = writer;
  } else if (it->second.writer != writer) {
    drop(what);
    return nullptr;
  }
  it->second.seen = tick_;
  return &it->second;
}

/// Forgets visitors that have been silent for long, if there are many visitors.
void Session::forget_visitors() {
  PROSECTOR_ASSERT(visitors_.size() <= max_visitors && !visitors_.contains(0));
  if (visitors_.size() < max_visitors / 2) return;
  std::erase_if(visitors_,
                [&](const auto& v) { return tick_ - v.second.seen > 10 * rules_.presence_timeout; });
}

std::vector<Outgoing> Session::take_outgoing() {
  return std::exchange(outgoing_, {});
}

std::vector<SessionEvent> Session::take_events() {
  return std::exchange(events_, {});
}

const HandInput* Session::newest_input(ParticipantId id) const {
  const auto it = seats_.find(id);
  return it == seats_.end() || !it->second.input ? nullptr : &*it->second.input;
}

void Session::answer(const Command& command, const Refusal& refusal) {
  if (outgoing_.size() >= max_outgoing)
    return drop("a reply to a command was discarded, because too many are waiting to be sent");
  CommandCount& count = commands_[command.body.index()];
  ++(refusal ? count.refused : count.granted);
  outgoing_.push_back({CommandResult{command.participant, command.sequence, !refusal, refusal.why()}});
}

void Session::drop(const char* reason) {
  ++dropped_[reason];
  ++dropped_total_;
}

}  // namespace prosector
