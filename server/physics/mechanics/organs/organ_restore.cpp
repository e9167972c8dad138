// Reconstruction of an organ by replaying its log from the uncut organ.

#include <string>

#include "common/assert.h"
#include "common/error.h"
#include "server/physics/mechanics/cutting/touched.h"
#include "server/physics/mechanics/organs/organ.h"

namespace prosector::organs {

Organ::Mark Organ::mark() const {
  return {log_.size(), grouping_.marks()};
}

void Organ::back_to(const Mark& mark, std::size_t bodies) {
  PROSECTOR_ASSERT(!pieces().empty() && mark.changes <= log_.size());
  Organ before(pieces().front().body, whole_, complex_.density(), held_);
  log_.resize(mark.changes);
  before.restore(std::move(log_), mark.pieces, bodies);
  *this = std::move(before);
}

void Organ::restore(OrganLog log, const PieceMarks& pieces, std::size_t bodies) {
  PROSECTOR_ASSERT(log_.empty());
  const auto require = [](bool good, const char* problem) {
    if (!good) throw InputError(std::string("an organ's log: ") + problem);
  };
  for (OrganChange& change : log) {
    change.touched.clear();
    change.taken_back = false;
    if (change.cause == TopologyCause::rewind) {
      require(change.stroke <= log_.size(), "a rewind to a nonexistent revision");
      require(change.ops.empty(), "a rewind with a cut");
      redo(std::move(change));
      skin_.update(complex_);
      continue;
    }
    for (const cutting::TopologyOp& op : change.ops) complex_.apply(op);
    if (change.cause == TopologyCause::undo) {
      const std::vector<OrganChange*> stroke = stroke_of(log_, change.author);
      require(!stroke.empty() && stroke.front()->stroke == change.stroke,
              "the list of topology changes is damaged: an undo refers to a cut that does not exist");
      take_back(stroke);
    } else {
      require(change.cause == TopologyCause::cut, "an invalid topology change");
      change.touched = cutting::touched_by(complex_, change.ops);
      grouping_.note_touched(complex_, change.touched);
    }
    skin_.update(complex_);
    log_.push_back(std::move(change));
  }
  grouping_.restore(pieces, complex_, bodies, log_.size());
}

}  // namespace prosector::organs
