#pragma once
// What happened in the session since the last look, in words for people.

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

/// What happened, and whether the user did it.
struct Happening {
  std::string text;
  MessageKind kind = MessageKind::news;
  bool operator==(const Happening&) const = default;
};

/// Compares what a replica knows from look to look. What was there at the first look is no news. What the
/// user takes hold of is.
class Happenings {
 public:
  /// Takes whose client this is: that one's deeds are told as "you".
  explicit Happenings(ParticipantId self, Catalogue words = {}) : self_(self), words_(std::move(words)) {}
  /// Takes the id that this user has from now on.
  void rename_self(ParticipantId self) { self_ = self; }

  /// Returns a sentence for everything new about people, time, cuts, pieces that came off, and the
  /// simulation's troubles and their end. `now`: s of a clock that never goes back. A stroke is told once,
  /// however many revisions it makes, and how long and deep it was when it has ended. A trouble that comes
  /// and goes is told once a minute, and its end only where it was told.
  std::vector<Happening> look(const Replica& replica, double now);

 private:
  struct Seen {
    std::uint32_t revision = 0;
    TopologyCause cause = TopologyCause::compiled;
    ParticipantId author = 0;
    double told = 0;  // s
  };

  ParticipantId self_;
  Catalogue words_;
  bool looked_ = false;
  std::map<ParticipantId, RosterEntry> people_;
  std::map<BodyId, Seen> topologies_;
  StrokeGauge strokes_;
  struct Trouble {
    double told = 0, last = 0;  // s: when it became a message; when the server last had it
  };
  std::map<std::string, Trouble> troubles_;  // by kind
  bool told_of_trouble_ = false;             // and not of its end
  std::set<BodyId> held_;                    // by the user
  double pace_ = 1;

  void look_at_people(const Replica& replica, std::vector<Happening>& out);
  void look_at_time(const Replica& replica, std::vector<Happening>& out);
  void look_at_hands(const Replica& replica, std::vector<Happening>& out);
  void look_at_cuts(const Replica& replica, double now, std::vector<Happening>& out);
  void look_at_troubles(const Replica& replica, double now, std::vector<Happening>& out);
  void look_at_strokes(const Replica& replica, double now, std::vector<Happening>& out);
  std::string told_change(const Replica& replica, const TopologyRevision& revision,
                          const std::string& part) const;
  std::string name_of(const Replica& replica, ParticipantId who) const;
  MessageKind kind_of(ParticipantId author) const {
    return author == self_ ? MessageKind::own : MessageKind::news;
  }
};

}  // namespace prosector
