#pragma once
// Who is in the session: the rules of joining, in one place.

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <string>

#include "common/messages.h"
#include "common/refusal.h"

namespace prosector {

/// What a session lets in. Times in ticks: a replay must not depend on a clock.
struct SessionRules {
  std::string session;
  int capacity = 64;                     // people, observers included
  int observers = 16;                    // of them observers, at most
  std::uint64_t input_timeout = 30;      // ticks after which a hand that its client doesn't see is let go
  std::uint64_t stall_timeout = 300;     // ticks after which the hands of a silent client are let go
  std::uint64_t regrasp_timeout = 1800;  // ticks for which a hand may have back what a stall made it lose
  std::uint64_t presence_timeout = 120;  // ticks that a join waits for its Presence
  std::uint64_t death_timeout = 90;      // ticks after which a member that died is known to be gone
  std::vector<std::string> names;        // by body, as messages to users have them
  std::vector<bool> parts;               // by body, whether it is a part of the anatomy
  std::size_t bodies = 0;                // BodyId below this exist
  std::size_t rigid_bodies = 0;          // those come first
  bool recording = false;                // a recorded session is watched: nobody takes part
  bool remodels = false;                 // bodies can be modelled in another way while it runs
};

struct Participant {
  Presence presence;           // as it came: with the role that was asked for
  Role role = Role::observer;  // that it has now: the host hands them out
  std::uint64_t writer = 0;    // the remote process; samples of another in this name are refused
  std::uint32_t color = 0;     // row of the colour table
};

class Roster {
 public:
  explicit Roster(const SessionRules& rules) : rules_(rules) {}

  /// Returns why `presence` may not join now.
  Refusal refusal(const Presence& presence) const;
  /// Tells whether only another member is in the way, by its name or as the host: should that one be dead,
  /// the next moments tell.
  bool in_anothers_place(const Presence& presence) const;
  /// Returns why a member may not become that. Who may say so is the session's matter.
  Refusal role_refusal(const Participant& subject, Role role) const;
  const Participant& admit(const Presence& presence, std::uint64_t writer);
  void remove(ParticipantId id) { members_.erase(id); }

  Participant* find(ParticipantId id);
  const std::map<ParticipantId, Participant>& members() const { return members_; }
  std::uint32_t participants() const;  // who takes part: not the observers
  std::uint32_t observers() const;

  static RosterEntry entry(const Participant& participant);

 private:
  SessionRules rules_;
  std::map<ParticipantId, Participant> members_;
};

}  // namespace prosector
