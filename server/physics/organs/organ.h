#pragma once
// A soft body of the scene as it has been cut: its tetrahedra, or a sheet's triangles, with all that hangs on
// them. It has the pieces that these fall into (organ_pieces.h) and the log of what was done (organ_log.h).
// The geometry of its pieces is in organ_geometry.h.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/byte_stream.h"
#include "common/messages.h"
#include "common/refusal.h"
#include "server/physics/cutting/mesh_cut.h"
#include "server/physics/cutting/skin.h"
#include "server/physics/cutting/tet_complex.h"
#include "server/physics/organs/organ_log.h"
#include "server/physics/organs/organ_pieces.h"

namespace prosector {

class Organ {
 public:
  /// Takes soft body `body`, which was never cut: tetrahedra, with or without nodes on their edges, or a
  /// sheet. `density`: kg/m³. `held`: by node of a sheet, what is tied to its place; empty: nothing.
  Organ(std::size_t body, const Anatomy& anatomy, double density, std::vector<std::uint8_t> held = {});

  const Anatomy& whole() const { return whole_; }  // as compiled, without nodes on edges
  const std::vector<std::uint8_t>& held() const { return held_; }
  const TetComplex& complex() const { return complex_; }
  const Skin& skin() const { return skin_; }
  const OrganLog& log() const { return log_; }
  const OrganPieces& grouping() const { return grouping_; }
  const std::vector<OrganPiece>& pieces() const { return grouping_.all(); }
  const OrganPiece& piece(std::size_t body) const { return grouping_.piece(body); }

  /// Cuts for one tick of a blade's stroke, see mesh_cut.h. `positions`: of every node, by id, m. Without
  /// operations in the result nothing changed.
  CutResult cut(std::span<const Vec3> positions, std::span<const Vec3> edge, BladeStroke& blade,
                ParticipantId author, std::uint64_t stroke);
  /// Takes back the author's last stroke, or returns why not.
  Refusal undo(ParticipantId author);
  /// Returns whether `then` is an earlier state of this organ: the log begins with `then`'s.
  bool has_past(const Organ& then) const;
  /// Makes everything as in `then`, for which has_past() must hold. Cuts made since are taken back, those
  /// undone since are made again, under the ids that they had. Bodies that came since stay, as pieces without
  /// tetrahedra.
  void rewind(const Organ& then, ParticipantId author);

  /// Finds the pieces anew after changes, see OrganPieces::regroup().
  Regrouped regroup(std::size_t next_body);
  /// Takes the one piece that was cut along, in place of regroup(). `edit`: cut_in_one_piece().
  void follow(const PieceEdit& edit);

  /// A place in the log, and the pieces there, to go back to where what followed could not take effect.
  struct Mark {
    std::size_t changes = 0;
    PieceMarks pieces;
  };
  Mark mark() const;
  /// Goes back as if nothing had been done since: the log is cut off there. `bodies`: how many soft bodies
  /// there are.
  void back_to(const Mark& mark, std::size_t bodies);

  void save(ByteWriter& out) const;
  /// Takes the uncut organ through a saved log. Throws InputError for what doesn't fit; `bodies`: how many
  /// soft bodies there are.
  void load(ByteReader& in, std::size_t bodies);

 private:
  TetComplex uncut(double density) const;
  void take_back(const std::vector<OrganChange*>& newest_first);
  void redo(OrganChange change);
  void go_back(std::size_t length);

  Anatomy whole_;
  std::vector<std::uint8_t> held_;
  TetComplex complex_;
  Skin skin_;
  TetTree tree_;  // cache
  OrganLog log_;
  OrganPieces grouping_;
};

}  // namespace prosector
