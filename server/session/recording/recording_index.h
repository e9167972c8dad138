#pragma once
// Index of a journal, which does not need to be run: participants, positions of their eyes, and events over
// time. Made in one pass, which verifies every tick's seal.

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "server/session/journal/journal_reader.h"
#include "server/session/people/roster.h"

namespace prosector {

class RecordingIndex {
 public:
  /// Reads the journal from its first to its last tick and indexes it. `progress` is called with each tick;
  /// it may be empty. Throws InputError if a tick is missing or damaged, or the journal has no tick.
  RecordingIndex(const JournalReader& journal, const std::function<void(std::uint64_t tick)>& progress);

  std::uint64_t last_tick() const { return last_tick_; }
  /// Returns the description of the recording that is sent to clients. It has at most max_recording_marks
  /// marks (events on the timeline).
  Recording recording() const;
  /// Returns the recorded participants and observers that are in the session at the end of `tick`, with their
  /// colours.
  Roster people_at(std::uint64_t tick) const;
  /// Returns the recorded position of a participant's eyes at the end of `tick`, m, world frame. Returns
  /// nullopt if it is not known.
  std::optional<Vec3> head_at(ParticipantId who, std::uint64_t tick) const;
  /// Returns the first topology revision of a piece that was cut off in the recording. Null if there is no
  /// such piece.
  const TopologyRevision* beginning_of(BodyId piece) const;

 private:
  struct Coming {  // a join, a leave, or a change of role
    std::uint64_t tick = 0;
    SessionEvent event;
  };
  struct HeadAt {
    std::uint64_t tick = 0;
    Vec3 at = Vec3::Zero();  // m, world frame
  };
  std::uint64_t last_tick_ = 0;
  std::vector<Coming> people_;
  std::map<ParticipantId, std::string> names_;
  std::map<ParticipantId, std::vector<HeadAt>> heads_;
  std::map<BodyId, TopologyRevision> pieces_;
  std::vector<RecordingMark> marks_;

  void take(const JournalTick& tick);
  void take_people(const JournalTick& tick);
  void take_topology(const JournalTick& tick);
  void mark(std::uint64_t tick, MarkKind kind, const std::string& who);
  std::string name_of(ParticipantId who) const;
};

}  // namespace prosector
