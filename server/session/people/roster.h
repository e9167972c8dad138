#pragma once
// Members of the session, and the rules of joining.

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <string>

#include "common/ids.h"
#include "common/refusal.h"
#include "common/session_messages.h"

namespace prosector {

/// Limits and timeouts of a session, and properties of its bodies. Times are in ticks, because a replay must
/// not depend on a clock.
struct SessionRules {
  std::string session;
  int capacity = 64;                     // members, observers included
  int observers = 16;                    // most observers among them
  std::uint64_t input_timeout = 30;      // ticks after which a hand that its client doesn't track vanishes
  std::uint64_t stall_timeout = 300;     // ticks after which the hands of a silent client vanish
  std::uint64_t regrasp_timeout = 1800;  // ticks for which a hand may grasp again what it lost in a stall
  std::uint64_t presence_timeout = 120;  // ticks that a join waits for its Presence
  std::uint64_t death_timeout = 90;      // ticks after which a member that crashed is known to be gone
  std::vector<std::string> names;        // by body, as used in messages to users
  std::vector<bool> parts;               // by body, whether it is a part of the anatomy
  std::size_t bodies = 0;                // ids below this exist
  std::size_t rigid_bodies = 0;          // ids below this are rigid bodies
  bool recording = false;                // a recorded session is played: nobody participates
  bool remodels = false;                 // models of bodies can be changed while it runs

  /// Returns the name of a body for messages to users; a body without a name: its number.
  std::string name_of(BodyId body) const;
};

struct Participant {
  Presence presence;           // as it joined: with the role that it requested
  Role role = Role::observer;  // present role: the host assigns roles
  std::uint64_t writer = 0;    // the remote process; samples of others in its name are refused
  std::uint32_t color = 0;     // row of the colour table
};

class Roster {
 public:
  explicit Roster(const SessionRules& rules) : rules_(rules) {}

  /// Returns the reason why the sender of `presence` may not join the session now. Empty if it may.
  Refusal refusal(const Presence& presence) const;
  /// Returns whether another member prevents this join, because it has the same name or both are to be the
  /// host. If that member's client has crashed, the session finds out shortly.
  bool in_anothers_place(const Presence& presence) const;
  /// Returns the reason why the member `subject` may not get that role. Empty if it may. The session checks
  /// separately whether the sender of the request may assign roles.
  Refusal role_refusal(const Participant& subject, Role role) const;
  const Participant& admit(const Presence& presence, std::uint64_t writer);
  void remove(ParticipantId id) { members_.erase(id); }

  Participant* find(ParticipantId id);
  const std::map<ParticipantId, Participant>& members() const { return members_; }
  std::uint32_t participants() const;  // members that are not observers
  std::uint32_t observers() const;

  static RosterEntry entry(const Participant& participant);

 private:
  SessionRules rules_;
  std::map<ParticipantId, Participant> members_;
};

}  // namespace prosector
