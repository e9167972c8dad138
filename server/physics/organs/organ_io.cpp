// An organ's log as bytes. Reading it goes through it once more, from the uncut organ on.

#include "server/physics/cutting/touched.h"
#include "server/physics/organs/organ.h"

namespace prosector {

void Organ::save(ByteWriter& out) const {
  prosector::save(out, log_);
  prosector::save(out, grouping_.marks());
}

Organ::Mark Organ::mark() const {
  return {log_.size(), grouping_.marks()};
}

void Organ::back_to(const Mark& mark, std::size_t bodies) {
  ByteWriter bytes;
  prosector::save(bytes, std::span(log_).first(mark.changes));
  prosector::save(bytes, mark.pieces);
  Organ before(pieces().front().body, whole_, complex_.density(), held_);
  ByteReader in(bytes.bytes(), "an organ's log");
  before.load(in, bodies);
  *this = std::move(before);
}

void Organ::load(ByteReader& in, std::size_t bodies) {
  for (std::size_t left = in.count(most_changes); left > 0; --left) {
    OrganChange change = read_change(in);
    if (change.cause == TopologyCause::rewind) {
      in.require(change.stroke <= log_.size(), "a rewind to what isn't there");
      in.require(change.ops.empty(), "a rewind that cuts");
      redo(std::move(change));
      skin_.update(complex_);
      continue;
    }
    for (const TopologyOp& op : change.ops) complex_.apply(op);
    if (change.cause == TopologyCause::undo) {
      const std::vector<OrganChange*> stroke = stroke_of(log_, change.author);
      in.require(!stroke.empty() && stroke.front()->stroke == change.stroke, "an undo of what isn't there");
      take_back(stroke);
    } else {
      in.require(change.cause == TopologyCause::cut, "a change of a topology that is none");
      change.touched = touched_by(complex_, change.ops);
      grouping_.note_touched(complex_, change.touched);
    }
    skin_.update(complex_);
    log_.push_back(std::move(change));
  }
  grouping_.load(in, complex_, bodies, log_.size());
}

}  // namespace prosector
