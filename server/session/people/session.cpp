#include "server/session/people/session.h"

#include <fmt/format.h>

#include "common/assert.h"
#include "common/role_words.h"

namespace prosector {
namespace {

/// Returns whether a sample is the newest of its stream. If the stream's numbering restarts, that is counted
/// as `what`.
bool admits(SequenceGate& sequences, std::uint64_t number, const char* what, SessionOutput& output) {
  const SequenceGate::Verdict verdict = sequences.judge(number);
  if (verdict == SequenceGate::Verdict::restarted) output.drop(what);
  return verdict != SequenceGate::Verdict::overtaken;
}

}  // namespace

Session::Session(const SessionRules& rules)
    : rules_(rules),
      roster_(rules),
      hands_(rules),
      panels_(rules.parts, rules.input_timeout),
      pacing_(rules.recording ? max_pace : 1) {}

ConsumedInput Session::consume(std::span<const Received> received, std::uint64_t tick) {
  PROSECTOR_ASSERT(tick >= tick_);
  tick_ = tick;
  listen(received);

  ConsumedInput out;
  // Hands of members that left come first: an id that rejoins in the same tick starts with new hands.
  out.input.events = hands_.take_vanishing();
  out.input.efforts = requests_.take_efforts();
  for (auto& [id, seat] : seats_) consume_seat(id, seat, out);
  const auto may_touch = [&](ParticipantId id) {
    const Participant* member = roster_.find(id);
    return member != nullptr && member->role != Role::observer;
  };
  panels_.consume(may_touch, out.input);
  visitors_.forget_silent(tick_, 10 * rules_.presence_timeout);
  return out;
}

void Session::listen(std::span<const Received> received) {
  for (auto& [id, seat] : seats_) seat.commands = 0;
  for (const Received& r : received) take(r);
  // Presence and join arrive separately: joins are decided after all received samples were read.
  visitors_.remove_if([&](ParticipantId id, Visitor& visitor) {
    if (visitor.join) settle_join(id, visitor);
    return roster_.find(id) != nullptr;
  });
}

void Session::take(const Received& received) {
  if (received.writer == 0) return output_.drop("from an unknown process");
  if (const auto* p = std::get_if<Presence>(&received.message)) return take(*p, received);
  if (received.liveness == Liveness::gone) return;  // the end of a stream is ignored: Presence decides
  if (const auto* input = std::get_if<HandInput>(&received.message)) return take(*input, received.writer);
  if (const auto* command = std::get_if<Command>(&received.message)) return take(*command, received.writer);
  if (const auto* force = std::get_if<ArmForce>(&received.message)) return take(*force, received.writer);
  output_.drop("not a message for a server");
}

void Session::take(const Presence& presence, const Received& received) {
  if (received.liveness == Liveness::gone) return take_end(presence, received.writer);
  const ParticipantId id = presence.participant;
  Participant* member = roster_.find(id);
  if (member != nullptr) {
    if (member->writer != received.writer) return output_.drop("Presence: another process's participant");
    if (presence.name != member->presence.name || presence.role != member->presence.role)
      return output_.drop(
          "Presence: discarded, because it changes the name or role of a participant in the session");
    member->presence = presence;  // a role assigned since then stays
    output_.send({Roster::entry(*member)});
    return;
  }
  Visitor* v =
      visitors_.admit(id, received.writer, tick_, "Presence: another process's participant", output_);
  if (v != nullptr) v->presence = presence;
}

/// Processes the end of a Presence: its process has left or lost its connection.
void Session::take_end(const Presence& presence, std::uint64_t writer) {
  const ParticipantId id = presence.participant;
  const Participant* member = roster_.find(id);
  Visitor* visitor = visitors_.find(id);
  const std::uint64_t owner = member != nullptr ? member->writer : visitor != nullptr ? visitor->writer : 0;
  if (owner == 0) return;  // of a visitor that was forgotten
  if (writer != owner)
    return output_.drop(
        "Presence: discarded, because another process than the participant's reported its end");
  if (member != nullptr)
    leave(id, SessionEvent::Kind::lost);
  else
    visitor->join.reset();
}

void Session::take(const HandInput& input, std::uint64_t writer) {
  const Participant* member = roster_.find(input.participant);
  if (member == nullptr) {
    // Samples may arrive before their Presence, or after their sender has left.
    const Visitor* visitor = visitors_.find(input.participant);
    if (visitor == nullptr)
      return output_.drop("HandInput: discarded, because its participant is not in the session");
    if (visitor->writer != writer) return output_.drop("HandInput: another process's participant");
    return;
  }
  if (member->writer != writer) return output_.drop("HandInput: another process's participant");
  if (member->role == Role::observer) return output_.drop("HandInput: from an observer");
  Seat& seat = seats_[input.participant];
  if (!admits(seat.sequences, input.sequence, "HandInput: numbering restarted", output_)) return;
  seat.input = input;
  seat.fresh = true;
}

/// Processes a command of a sender that isn't a member: only joining and leaving are possible.
void Session::take_of_visitor(const Command& command, std::uint64_t writer) {
  if (std::holds_alternative<Join>(command.body)) {
    Visitor* v = visitors_.admit(command.participant, writer, tick_, "Command: another process's participant",
                                 output_);
    if (v == nullptr) return;
    if (!v->join) v->join_tick = tick_;  // a repeated request does not restart the wait
    v->join = command;
    return;
  }
  const Visitor* visitor = visitors_.find(command.participant);
  if (visitor == nullptr || visitor->writer != writer)
    return output_.drop("Command: discarded, because its participant is not in the session");
  output_.answer(command, std::holds_alternative<Leave>(command.body) ? Refusal() : "join first");
}

/// Assigns the role at this tick. A member that becomes an observer loses hands and holds.
void Session::give(ParticipantId id, Role role) {
  PROSECTOR_ASSERT(roster_.find(id) != nullptr);
  Participant& member = *roster_.find(id);
  member.role = role;
  if (role == Role::observer) {
    Seat& seat = seats_[id];
    hands_.vanish(id, seat);
    const std::uint32_t commands = seat.commands;
    seat = {};
    seat.commands = commands;
  }
  output_.send({Roster::entry(member)});
  output_.log_if_room({SessionEvent::Kind::role, id, member.presence.name, role_word(role)});
}

void Session::add_body(const std::string& name, bool is_part) {
  ++rules_.bodies;
  rules_.names.push_back(name);
  panels_.add_body(is_part);
}

/// Decides on the join of a visitor, or waits for its Presence or for the end of a crashed member.
void Session::settle_join(ParticipantId id, Visitor& v) {
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
  output_.answer(*v.join, refusal);
  v.join.reset();
  const std::string name = v.presence ? v.presence->name : "";
  if (refusal) return output_.log_if_room({SessionEvent::Kind::refused, id, name, refusal.why()});
  const Participant& member = roster_.admit(*v.presence, v.writer);
  seats_[id] = {};
  output_.send({Roster::entry(member)});
  output_.log({SessionEvent::Kind::joined, id, name, role_word(member.role)});
  for (const ReleasedHolds::Lost& lost : hands_.lost_by(id))
    output_.tell(id, fmt::format("your connection was lost, and your hand released the {}",
                                 rules_.name_of(lost.body)));
}

/// Removes the participant and its state. Its hands vanish at this tick.
void Session::leave(ParticipantId id, SessionEvent::Kind how) {
  PROSECTOR_ASSERT(roster_.find(id) != nullptr &&
                   (how == SessionEvent::Kind::left || how == SessionEvent::Kind::lost));
  const Participant member = *roster_.find(id);
  hands_.vanish(id, seats_[id]);
  if (how == SessionEvent::Kind::lost) hands_.cut_off(id);
  output_.log({how, id, member.presence.name, role_word(member.role)});
  output_.send({Roster::entry(member), true});
  seats_.erase(id);
  roster_.remove(id);
  // Stored as a visitor: after a network failure it may return without a new Presence.
  if (Visitor* v = visitors_.admit(id, member.writer, tick_, "", output_)) v->presence = member.presence;
}

void Session::take(const ArmForce& force, std::uint64_t writer) {
  const Participant* member = roster_.find(force.participant);
  if (member == nullptr) return;  // it arrived before Presence, or its sender is leaving
  if (member->writer != writer) return output_.drop("ArmForce: another process's participant");
  if (member->role == Role::observer) return output_.drop("ArmForce: from an observer");
  if ((member->presence.arms >> force.hand & 1) == 0)
    return output_.drop(
        "ArmForce: discarded, because its participant has announced no haptic arm for this hand");
  ArmReaction& reaction = seats_[force.participant].reactions[force.hand];
  if (!admits(reaction.sequences, force.sequence, "ArmForce: numbering restarted", output_)) return;
  reaction.tick = tick_;
  reaction.force = force.force.norm();
}

void Session::consume_seat(ParticipantId id, Seat& seat, ConsumedInput& out) {
  const Participant* member = roster_.find(id);
  PROSECTOR_ASSERT(member != nullptr && (!seat.fresh || seat.input.has_value()));
  if (seat.fresh) seat.heard_tick = tick_;
  hands_.consume(*member, seat, tick_, out.input, output_);
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
  requests_.consume(seat, out.input);
}

void Session::finish_tick(std::span<const HandState> hands, const StepReport& report) {
  pacing_.finish_tick();
  requests_.finish_tick(report, roster_, output_);
  for (const PanelRefusal& refused : report.panel_refusals)
    if (roster_.find(refused.participant) != nullptr) output_.tell(refused.participant, refused.why);
  for (const LetGo& let_go : report.let_go) take(let_go);
  for (const ReleasedHolds::Lost& lost : hands_.finish_tick(hands, tick_))
    if (roster_.find(lost.hand.participant) != nullptr)
      output_.tell(lost.hand.participant, fmt::format("another hand took the {}", rules_.name_of(lost.body)));
  for (auto& [id, seat] : seats_) finish_regrasps(id, seat, hands, rules_, output_);
  for (auto& [id, seat] : seats_) answer_grasps(id, seat, hands, report, output_);
}

/// Processes a hand's loss of its hold in the step.
void Session::take(const LetGo& let_go) {
  const Participant* member = roster_.find(let_go.participant);
  const Seat* seat = member != nullptr ? &seats_.at(let_go.participant) : nullptr;
  hands_.note_loss(let_go, seat, tick_);
  if (member == nullptr) return;
  output_.log({SessionEvent::Kind::let_go, let_go.participant, member->presence.name, let_go.why});
  tell_of_loss(let_go, *seat, rules_, output_);
}

const HandInput* Session::newest_input(ParticipantId id) const {
  const auto it = seats_.find(id);
  return it == seats_.end() || !it->second.input ? nullptr : &*it->second.input;
}

}  // namespace prosector
