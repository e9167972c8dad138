#pragma once
// Detects changes in the session and describes them to the user.

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "client/language/catalogue.h"
#include "client/replica/replica.h"
#include "client/replica/stroke_figures.h"
#include "client/view/message_lines.h"

namespace prosector {

/// Message to the user about a session event, and whether this user caused it.
struct SessionMessage {
  std::string text;
  MessageKind kind = MessageKind::news;
  bool operator==(const SessionMessage&) const = default;
};

/// Detector of session events, such as cuts and joining or leaving participants, by comparing the replica's
/// state between calls. The state at the first call causes no messages. Grasps are reported only if this
/// client's user makes them.
class SessionEvents {
 public:
  /// Sets the participant id of this client's user, whose actions are described as "you …", and the language
  /// of the messages.
  explicit SessionEvents(ParticipantId self, Catalogue words = {}) : self_(self), words_(std::move(words)) {}
  /// Sets the new participant id of this client's user, for instance after a reconnection.
  void rename_self(ParticipantId self) { self_ = self; }

  /// Returns messages on changes since the last call: participants, time, cuts, pieces cut off, and
  /// simulation problems and their end. `now`: monotonic clock, s. A stroke of a blade is reported once when
  /// it begins, and with length and depth after its end. A recurring problem is reported at most once a
  /// minute, and its end only if the problem was reported.
  std::vector<SessionMessage> look(const Replica& replica, double now);

 private:
  struct Seen {
    std::uint32_t revision = 0;
    TopologyCause cause = TopologyCause::compiled;
    ParticipantId author = 0;
    double reported = 0;  // s, time of the report
  };

  ParticipantId self_;
  Catalogue words_;
  bool looked_ = false;
  std::map<ParticipantId, RosterEntry> people_;
  std::map<BodyId, Seen> topologies_;
  StrokeTracker strokes_;
  struct Problem {
    double reported = 0,
           last = 0;  // s: time of the last message about it; time when the server last reported it
  };
  std::map<std::string, Problem> problems_;  // key: kind of problem
  bool problem_reported_ = false;            // a problem was reported, and its end not yet
  std::set<BodyId> held_;                    // bodies that this user holds
  double pace_ = 1;

  void report_participants(const Replica& replica, std::vector<SessionMessage>& out);
  void report_pace(const Replica& replica, std::vector<SessionMessage>& out);
  void report_grasps(const Replica& replica, std::vector<SessionMessage>& out);
  void report_topology(const Replica& replica, double now, std::vector<SessionMessage>& out);
  void report_problems(const Replica& replica, double now, std::vector<SessionMessage>& out);
  void report_strokes(const Replica& replica, double now, std::vector<SessionMessage>& out);
  std::string change_message(const Replica& replica, const TopologyRevision& revision,
                             const std::string& part) const;
  std::string name_of(const Replica& replica, ParticipantId who) const;
  MessageKind kind_of(ParticipantId author) const {
    return author == self_ ? MessageKind::own : MessageKind::news;
  }
};

}  // namespace prosector
