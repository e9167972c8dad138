// Going back in an organ's log, which only grows.

#include <utility>

#include "common/assert.h"
#include "server/physics/mechanics/organs/organ.h"

namespace prosector::organs {

bool Organ::has_past(const Organ& then) const {
  return begins_with(log_, then.log_);
}

void Organ::rewind(const Organ& then, ParticipantId author) {
  PROSECTOR_ASSERT(has_past(then));
  OrganChange entry;
  entry.cause = TopologyCause::rewind;
  entry.author = author;
  entry.stroke = then.log_.size();
  redo(std::move(entry));
  skin_.update(complex_);
  grouping_.go_back_to(then.grouping_, log_.size());
}

/// Appends an earlier log entry and applies it to the tetrahedra. The caller updates caches.
void Organ::redo(OrganChange change) {
  change.taken_back = false;
  if (change.cause == TopologyCause::cut)
    for (const cutting::TopologyOp& op : change.ops) complex_.apply(op);
  else if (change.cause == TopologyCause::undo)
    take_back(stroke_of(log_, change.author));
  else
    go_back(change.stroke);
  log_.push_back(std::move(change));
}

/// Restores the tetrahedra and the log's entries in force as they were when the log had `length` entries.
void Organ::go_back(std::size_t length) {
  PROSECTOR_ASSERT(length <= log_.size());
  const cutting::TetComplex later = std::exchange(complex_, uncut(complex_.density()));
  OrganLog log;
  log.swap(log_);
  for (std::size_t i = 0; i < length; ++i) redo(std::move(log[i]));
  for (std::size_t i = length; i < log.size(); ++i) {
    log[i].taken_back = true;
    log_.push_back(std::move(log[i]));
  }
  complex_.continue_from(later);
}

}  // namespace prosector::organs
