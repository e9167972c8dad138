// Going back in an organ's log, which only grows.

#include <algorithm>
#include <utility>

#include "common/error.h"
#include "server/physics/organs/organ.h"

namespace prosector {

void Organ::rewind(const Organ& then, ParticipantId author) {
  const bool begins =
      then.log_.size() <= log_.size() && std::equal(then.log_.begin(), then.log_.end(), log_.begin(),
                                                    [](const OrganChange& a, const OrganChange& b) {
                                                      return a.cause == b.cause && a.author == b.author &&
                                                             a.stroke == b.stroke && a.ops == b.ops;
                                                    });
  if (!begins) throw InputError("cutting: a state to go back to has another past");
  OrganChange entry;
  entry.cause = TopologyCause::rewind;
  entry.author = author;
  entry.stroke = then.log_.size();
  redo(std::move(entry));
  skin_.update(complex_);
  for (OrganPiece& piece : pieces_) piece.mesh = {};
  for (const OrganPiece& piece : then.pieces_) {
    for (const TetId tet : piece.mesh.tets) owner_[tet] = piece.body;
    std::find_if(pieces_.begin(), pieces_.end(), [&](const OrganPiece& p) {
      return p.body == piece.body;
    })->mesh = piece.mesh;
  }
  note_from_here();
}

/// Appends to the log what was logged before, and does it to the tetrahedra; caches are the caller's.
void Organ::redo(OrganChange change) {
  change.taken_back = false;
  if (change.cause == TopologyCause::cut)
    for (const TopologyOp& op : change.ops) complex_.apply(op);
  else if (change.cause == TopologyCause::undo)
    take_back(stroke_of(change.author));
  else
    go_back(change.stroke);
  log_.push_back(std::move(change));
}

/// The tetrahedra, and what of the log is in force, as they were when it had `length` entries.
void Organ::go_back(std::size_t length) {
  const TetComplex later = std::exchange(complex_, uncut(complex_.density()));
  std::vector<OrganChange> log;
  log.swap(log_);
  for (std::size_t i = 0; i < length; ++i) redo(std::move(log[i]));
  for (std::size_t i = length; i < log.size(); ++i) {
    log[i].taken_back = true;
    log_.push_back(std::move(log[i]));
  }
  complex_.continue_from(later);
}

}  // namespace prosector
