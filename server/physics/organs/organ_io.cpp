// An organ's log as bytes. Reading it goes through it once more, from the uncut organ on.

#include <algorithm>

#include "server/physics/cutting/pieces.h"
#include "server/physics/cutting/touched.h"
#include "server/physics/organs/organ.h"
#include "server/physics/organs/organ_parts.h"
#include "server/physics/organs/topology_op_io.h"

namespace prosector {
namespace {

constexpr std::size_t most_changes = 10'000'000;
constexpr std::size_t most_ops = 10'000'000;  // of one

}  // namespace

void Organ::save(ByteWriter& out) const {
  save_changes(out, log_.size());
  save_pieces(out, mark());
}

void Organ::save_changes(ByteWriter& out, std::size_t count) const {
  out.add(static_cast<std::uint64_t>(count));
  for (const OrganChange& change : std::span(log_).first(count)) {
    out.add(change.cause);
    out.add(change.author);
    out.add(change.stroke);
    out.add(static_cast<std::uint64_t>(change.ops.size()));
    for (const TopologyOp& op : change.ops) add(out, op);
  }
}

void Organ::save_pieces(ByteWriter& out, const Mark& mark) {
  out.add(static_cast<std::uint64_t>(mark.pieces.size()));
  for (const auto& [body, first] : mark.pieces) {
    out.add(static_cast<std::uint64_t>(body));
    out.add(static_cast<std::uint8_t>(first.has_value()));
    if (first) out.add(*first);
  }
}

Organ::Mark Organ::mark() const {
  Mark out;
  out.changes = log_.size();
  for (const OrganPiece& piece : pieces_)
    out.pieces.emplace_back(piece.body, piece.whole() ? std::optional(*std::min_element(
                                                            piece.mesh.tets.begin(), piece.mesh.tets.end()))
                                                      : std::nullopt);
  return out;
}

void Organ::back_to(const Mark& mark, std::size_t bodies) {
  ByteWriter bytes;
  save_changes(bytes, mark.changes);
  save_pieces(bytes, mark);
  Organ before(pieces_.front().body, whole_, complex_.density(), held_);
  ByteReader in(bytes.bytes(), "an organ's log");
  before.load(in, bodies);
  *this = std::move(before);
}

void Organ::load(ByteReader& in, std::size_t bodies) {
  for (std::size_t left = in.count(most_changes); left > 0; --left) {
    OrganChange change;
    change.cause = in.number<TopologyCause>();
    change.author = in.number<ParticipantId>();
    change.stroke = in.number<std::uint64_t>();
    if (change.cause == TopologyCause::rewind) {
      in.require(change.stroke <= log_.size(), "a rewind to what isn't there");
      redo(std::move(change));
      in.require(in.count(most_ops) == 0, "a rewind that cuts");
      skin_.update(complex_);
      continue;
    }
    for (std::size_t ops = in.count(most_ops); ops > 0; --ops) {
      change.ops.push_back(read_op(in));
      complex_.apply(change.ops.back());
    }
    if (change.cause == TopologyCause::undo) {
      const std::vector<OrganChange*> stroke = stroke_of(change.author);
      in.require(!stroke.empty() && stroke.front()->stroke == change.stroke, "an undo of what isn't there");
      take_back(stroke);
    } else {
      in.require(change.cause == TopologyCause::cut, "a change of a topology that is none");
      change.touched = touched_by(complex_, change.ops);
      note_touched(change.touched);
    }
    skin_.update(complex_);
    log_.push_back(std::move(change));
  }
  const std::vector<std::vector<TetId>> found = prosector::pieces(complex_);
  pieces_.clear();
  note_from_here();
  std::size_t used = 0;
  for (std::size_t left = in.count(bodies); left > 0; --left) {
    OrganPiece& piece = pieces_.emplace_back();
    piece.body = in.count(bodies);
    in.require(piece.body < bodies && (pieces_.size() < 2 || pieces_[pieces_.size() - 2].body < piece.body),
               "a piece out of order");
    if (!in.flag()) continue;
    const auto first = in.number<TetId>();
    const auto at = std::find_if(found.begin(), found.end(),
                                 [&](const std::vector<TetId>& tets) { return tets.front() == first; });
    in.require(at != found.end(), "a piece that isn't there");
    piece.mesh = piece_mesh(complex_, *at);
    for (const TetId tet : *at) owner_[tet] = piece.body;
    ++used;
  }
  in.require(used == found.size(), "pieces that are no bodies");
}

}  // namespace prosector
