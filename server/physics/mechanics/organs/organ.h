#pragma once
// A soft body of the scene with its cuts: its tetrahedra, or a sheet's triangles, and everything derived from
// them. It has connected pieces (organ_pieces.h) and a log of all changes (organ_log.h). The geometry of its
// pieces is in organ_geometry.h.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/ids.h"
#include "common/math.h"
#include "common/refusal.h"
#include "server/physics/mechanics/cutting/mesh_cut.h"
#include "server/physics/mechanics/cutting/skin.h"
#include "server/physics/mechanics/cutting/tet_complex.h"
#include "server/physics/mechanics/organs/organ_log.h"
#include "server/physics/mechanics/organs/organ_pieces.h"

namespace prosector {

/// An organ: mesh complex, skin, log and pieces of a soft body.
class Organ {
 public:
  /// Initialises from soft body `body`, which was never cut: tetrahedra, with or without edge nodes, or a
  /// sheet. `density`: kg/m³. `held`: by node of a sheet, whether an attachment holds the node; empty: none.
  Organ(std::size_t body, const Anatomy& anatomy, double density, std::vector<std::uint8_t> held = {});

  const Anatomy& whole() const { return whole_; }  // as compiled, without edge nodes
  const std::vector<std::uint8_t>& held() const { return held_; }
  const TetComplex& complex() const { return complex_; }
  const Skin& skin() const { return skin_; }
  const OrganLog& log() const { return log_; }
  const OrganPieces& grouping() const { return grouping_; }
  const std::vector<OrganPiece>& pieces() const { return grouping_.all(); }
  const OrganPiece& piece(std::size_t body) const { return grouping_.piece(body); }

  /// Cuts for one tick of a blade's stroke, see mesh_cut.h. `positions`: of every node, by id, m. Nothing
  /// changed if the result has no operations.
  CutResult cut(std::span<const Vec3> positions, std::span<const Vec3> edge, BladeStroke& blade,
                ParticipantId author, std::uint64_t stroke);
  /// Undoes the author's last stroke, or returns the reason why not.
  Refusal undo(ParticipantId author);
  /// Returns whether `then` is an earlier state of this organ: its log is a prefix of this log.
  bool has_past(const Organ& then) const;
  /// Restores the state of `then`, for which has_past() must hold. Later cuts are undone; cuts that were
  /// undone later are redone with their ids. Bodies that were created later remain, as pieces without
  /// tetrahedra.
  void rewind(const Organ& then, ParticipantId author);

  /// Recomputes the pieces after changes, see OrganPieces::regroup().
  Regrouped regroup(std::size_t next_body);
  /// Updates the only changed piece incrementally, instead of regroup(). `edit`: from cut_in_one_piece().
  void follow(const PieceEdit& edit);

  /// A position in the log with the pieces there, to go back to if the following changes can't be applied.
  struct Mark {
    std::size_t changes = 0;
    PieceMarks pieces;
  };
  Mark mark() const;
  /// Goes back to the mark and truncates the log there. `bodies`: number of soft bodies.
  void back_to(const Mark& mark, std::size_t bodies);

  /// Applies another organ's log to this uncut organ and sets the pieces of that state. Throws InputError for
  /// inconsistent input. `bodies`: number of soft bodies.
  void restore(OrganLog log, const PieceMarks& pieces, std::size_t bodies);

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
