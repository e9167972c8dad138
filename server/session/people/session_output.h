#pragma once
// Output of a session between two ticks: messages to clients, entries of its log, and counts of commands and
// dropped messages.

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "common/refusal.h"
#include "idl/bus.h"
#include "server/session/people/command_count.h"

namespace prosector {

/// A message that the server publishes to clients, or the end (disposal) of the message's DDS instance.
struct Outgoing {
  Message message;
  bool dispose = false;  // dispose of the instance instead
};

/// An entry of the session's log, such as a join, a refusal or a changed role.
struct SessionEvent {
  enum class Kind : std::uint8_t {
    joined,
    refused,
    left,
    lost,
    hand_timeout,
    role,
    let_go,
    broke,
    rewound,
    pace,
    effort,
    accuracy,
    hand_stalled
  } kind;
  ParticipantId participant = 0;
  std::string name;
  std::string detail;  // by kind: the role, the reason, the hand, or the target
};

class SessionOutput {
 public:
  /// Queues a message to all clients.
  void send(Outgoing message) { outgoing_.push_back(std::move(message)); }
  /// Queues the answer to a command, and counts the command. Drops it if too many messages are queued.
  void answer(const Command& command, const Refusal& refusal);
  /// Queues a message with text `words` for a participant. It is not the answer to a command. Drops it if too
  /// many messages are queued.
  void tell(ParticipantId participant, const std::string& words);

  void log(SessionEvent event) { events_.push_back(std::move(event)); }
  /// Logs an event that a sender can cause any number of times in a tick. Drops it if the log is full.
  void log_if_room(SessionEvent event);
  /// Counts a received or queued message that was dropped, by reason.
  void drop(const char* reason);

  /// Returns, in order, the messages that were queued since the last call.
  std::vector<Outgoing> take_outgoing() { return std::exchange(outgoing_, {}); }
  /// Returns, in order, the events that were logged since the last call.
  std::vector<SessionEvent> take_events() { return std::exchange(events_, {}); }
  /// Returns the number of messages that were dropped, by reason.
  const std::map<std::string, std::uint64_t>& dropped() const { return dropped_; }
  std::uint64_t dropped_total() const { return dropped_total_; }
  /// Returns the numbers of commands that were granted and refused, by kind of command.
  const CommandCounts& commands() const { return commands_; }

 private:
  std::vector<Outgoing> outgoing_;
  std::vector<SessionEvent> events_;
  std::map<std::string, std::uint64_t> dropped_;
  std::uint64_t dropped_total_ = 0;
  CommandCounts commands_{};
};

}  // namespace prosector
