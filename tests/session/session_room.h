#pragma once
// A session by itself, and what people send to it.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "server/session/people/session.h"

namespace prosector::test {

inline SessionRules rules() {
  SessionRules r;
  r.session = "test";
  r.capacity = 4;
  r.observers = 2;
  r.input_timeout = 5;
  r.presence_timeout = 10;
  r.death_timeout = 8;
  r.bodies = 3;
  return r;
}

inline Presence presence(ParticipantId id, const std::string& name, Role role = Role::dissector) {
  Presence p;
  p.participant = id;
  p.name = name;
  p.role = role;
  return p;
}

inline Command command(ParticipantId id, const CommandBody& body, std::uint64_t sequence = 1) {
  return {id, sequence, body};
}

inline HandInput input(ParticipantId id, std::uint64_t sequence, bool tracked = true) {
  HandInput i;
  i.participant = id;
  i.sequence = sequence;
  i.hands[right_hand].tracked = tracked;
  i.hands[right_hand].pose.p = {0.1, 0.2, static_cast<double>(sequence)};
  return i;
}

inline Received from(std::uint64_t writer, Message message, Liveness liveness = Liveness::alive) {
  Received r;
  r.message = std::move(message);
  r.writer = writer;
  r.liveness = liveness;
  return r;
}

/// A session and its tick.
struct Room {
  Session session{rules()};
  std::uint64_t tick = 0;
  std::vector<CommandResult> results;
  std::vector<RosterEntry> gone;

  ConsumedInput feed(const std::vector<Received>& received) {
    ConsumedInput out = session.consume(received, ++tick);
    session.finish_tick({});
    for (const Outgoing& o : session.output().take_outgoing()) {
      if (const auto* r = std::get_if<CommandResult>(&o.message)) results.push_back(*r);
      if (const auto* r = std::get_if<RosterEntry>(&o.message); r != nullptr && o.dispose) gone.push_back(*r);
    }
    return out;
  }
  CommandResult join(const Presence& p, std::uint64_t writer) {
    feed({from(writer, p), from(writer, command(p.participant, Join{}))});
    return results.back();
  }
};

}  // namespace prosector::test
