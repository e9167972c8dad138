#include "server/session/recording/recording_index.h"

#include <algorithm>

#include "common/assert.h"
#include "common/error.h"
#include "common/role_words.h"

namespace prosector {
namespace {

constexpr std::uint64_t least_marks_apart = 60;  // ticks between marks of one kind and person

/// Removes the member with that name: a new one with the same name has replaced it, for instance after a
/// crash.
void make_room(Roster& roster, const std::string& name) {
  for (const auto& [id, member] : roster.members())
    if (member.presence.name == name) {
      roster.remove(id);
      return;
    }
}

void apply(const SessionEvent& event, Roster& roster) {
  const std::optional<Role> role = role_of(event.detail);
  if (event.kind == SessionEvent::Kind::joined) {
    make_room(roster, event.name);
    Presence presence;
    presence.participant = event.participant;
    presence.name = event.name;
    presence.role = role.value_or(Role::dissector);
    roster.admit(presence, 0);
  } else if (event.kind == SessionEvent::Kind::role) {
    if (Participant* member = roster.find(event.participant)) member->role = role.value_or(member->role);
  } else {
    roster.remove(event.participant);
  }
}

}  // namespace

RecordingIndex::RecordingIndex(const JournalReader& journal,
                               const std::function<void(std::uint64_t tick)>& progress) {
  journal.for_each_tick(journal.header().begins_at, [&](const JournalTick& tick) {
    take(tick);
    if (progress) progress(tick.tick);
    return true;
  });
  if (last_tick_ == 0) throw InputError("the journal has no ticks: nothing was recorded");
}

void RecordingIndex::take(const JournalTick& tick) {
  PROSECTOR_ASSERT(tick.tick > last_tick_);
  last_tick_ = tick.tick;
  take_people(tick);
  take_topology(tick);
  for (const HandEvent& event : tick.input.input.events)
    if (event.kind == HandEvent::Kind::reset_body)
      mark(tick.tick, MarkKind::reset, name_of(event.participant));
  for (const panel::HeadPlace& head : tick.input.input.heads)
    heads_[head.participant].push_back({tick.tick, head.at});
}

void RecordingIndex::take_people(const JournalTick& tick) {
  for (const SessionEvent& event : tick.events) {
    const bool joins = event.kind == SessionEvent::Kind::joined;
    const bool leaves = event.kind == SessionEvent::Kind::left || event.kind == SessionEvent::Kind::lost;
    if (joins) names_[event.participant] = event.name;
    if (joins || leaves || event.kind == SessionEvent::Kind::role) people_.push_back({tick.tick, event});
    if (joins) mark(tick.tick, MarkKind::joined, event.name);
    if (leaves) mark(tick.tick, MarkKind::left, event.name);
  }
}

void RecordingIndex::take_topology(const JournalTick& tick) {
  for (const TopologyRevision& revision : tick.topology) {
    if (revision.piece_of >= 0) pieces_.try_emplace(revision.body, revision);
    const std::string who = name_of(revision.author);
    if (revision.cause == TopologyCause::cut) mark(tick.tick, MarkKind::cut, who);
    if (revision.cause == TopologyCause::undo) mark(tick.tick, MarkKind::taken_back, who);
    if (revision.cause == TopologyCause::rewind) mark(tick.tick, MarkKind::reset, who);
  }
}

/// Adds a mark, unless there is an equal one shortly before it: a stroke makes a revision in each tick.
void RecordingIndex::mark(std::uint64_t tick, MarkKind kind, const std::string& who) {
  PROSECTOR_ASSERT(marks_.empty() || marks_.back().tick <= tick);
  for (auto before = marks_.rbegin(); before != marks_.rend(); ++before) {
    if (tick - before->tick >= least_marks_apart) break;
    if (before->kind == kind && before->who == who) return;
  }
  marks_.push_back({tick, kind, who});
}

Recording RecordingIndex::recording() const {
  Recording out;
  out.last_tick = last_tick_;
  const std::size_t each = marks_.size() / max_recording_marks + 1;
  for (std::size_t k = 0; k < marks_.size(); k += each) out.marks.push_back(marks_[k]);
  return out;
}

Roster RecordingIndex::people_at(std::uint64_t tick) const {
  Roster out{SessionRules{}};
  for (const Coming& coming : people_)
    if (coming.tick <= tick) apply(coming.event, out);
  return out;
}

std::optional<Vec3> RecordingIndex::head_at(ParticipantId who, std::uint64_t tick) const {
  const auto found = heads_.find(who);
  if (found == heads_.end()) return std::nullopt;
  const std::vector<HeadAt>& heads = found->second;
  const auto after = std::ranges::upper_bound(heads, tick, {}, &HeadAt::tick);
  return after == heads.begin() ? std::nullopt : std::optional(std::prev(after)->at);
}

const TopologyRevision* RecordingIndex::beginning_of(BodyId piece) const {
  const auto found = pieces_.find(piece);
  return found == pieces_.end() ? nullptr : &found->second;
}

std::string RecordingIndex::name_of(ParticipantId who) const {
  const auto found = names_.find(who);
  return found == names_.end() ? std::string() : found->second;
}

}  // namespace prosector
