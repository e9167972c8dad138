#pragma once
// What a journal tells of a session without being run: who was there when, where their eyes were, what
// happened. Made in one pass, which proves every tick's seal.

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "server/session/journal_reader.h"
#include "server/session/roster.h"

namespace prosector {

class RecordingIndex {
 public:
  /// Reads the journal to its end. `progress` hears of each tick; may be empty. Throws InputError when a tick
  /// is missing or damaged, or there is none.
  RecordingIndex(const JournalReader& journal, const std::function<void(std::uint64_t tick)>& progress);

  std::uint64_t last_tick() const { return last_tick_; }
  /// Returns what clients are told: marks of one kind and person that are closer than can be seen are one.
  Recording recording() const;
  /// Returns who took part or watched at the end of `tick`, with the colours that they had.
  Roster people_at(std::uint64_t tick) const;
  /// Returns where a person's eyes were at the end of `tick`, m, world frame; nullopt: not known.
  std::optional<Vec3> head_at(ParticipantId who, std::uint64_t tick) const;
  /// Returns the first revision of a piece that was cut off; null: no such piece.
  const TopologyRevision* beginning_of(BodyId piece) const;

 private:
  struct Coming {  // or going
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
