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

namespace prosector::organs {

/// Soft body that can be cut: the mesh of all its tetrahedra or sheet triangles, its surface, its connected
/// pieces, and the log of all cuts, undos and rewinds.
class Organ {
 public:
  /// Initialises the organ, with one piece, from the soft body with index `body`, which was never cut.
  /// `anatomy`: its mesh and surface, of tetrahedra with or without edge nodes, or of a sheet. `density`:
  /// kg/m³. `held`: for each node of a sheet, 1 if an attachment fixes it; empty if none is fixed.
  Organ(std::size_t body, const Anatomy& anatomy, double density, std::vector<std::uint8_t> held = {});

  const Anatomy& whole() const { return whole_; }  // as compiled, without edge nodes
  const std::vector<std::uint8_t>& held() const { return held_; }
  const cutting::TetComplex& complex() const { return complex_; }
  const cutting::Skin& skin() const { return skin_; }
  const OrganLog& log() const { return log_; }
  const OrganPieces& grouping() const { return grouping_; }
  const std::vector<OrganPiece>& pieces() const { return grouping_.all(); }
  const OrganPiece& piece(std::size_t body) const { return grouping_.piece(body); }

  /// Cuts the organ along the surface that a blade's edge sweeps in one tick, and appends the cut to the log.
  /// `positions`: node positions (m) by node id; `edge`: points of the edge at the end of the tick (m, world
  /// frame); `blade`: the stroke's state, updated. `stroke`: number of the stroke, by which `author` can undo
  /// it. If the result lists no operations, the organ did not change.
  cutting::CutResult cut(std::span<const Vec3> positions, std::span<const Vec3> edge,
                         cutting::BladeStroke& blade, ParticipantId author, std::uint64_t stroke);
  /// Undoes all cuts of the author's last stroke that is still in force. Returns an empty refusal on success;
  /// otherwise returns the reason, for instance that a later cut depends on it, and changes nothing.
  Refusal undo(ParticipantId author);
  /// Returns whether `then` is an earlier or equal state of this organ: whether the log of changes of `then`
  /// is a prefix of this organ's log.
  bool has_past(const Organ& then) const;
  /// Restores the cuts of the earlier state `then` of this organ and appends a rewind by `author` to the log.
  /// has_past(then) must hold. Later cuts are undone; cuts that were undone later are redone with the same
  /// ids. Soft bodies of pieces that were created later remain, as pieces without tetrahedra.
  void rewind(const Organ& then, ParticipantId author);

  /// Recomputes the organ's connected pieces after cuts or undos, and returns the changes since the last
  /// call. Pieces that fell off become soft bodies with indices from `next_body` on.
  Regrouped regroup(std::size_t next_body);
  /// Updates the mesh of the only changed piece incrementally, which is faster than regroup(). Allowed only
  /// if nothing was severed. `edit`: returned by cut_in_one_piece().
  void follow(const PieceEdit& edit);

  /// Position in the organ's log of changes, with the pieces at that position. back_to() returns there if the
  /// changes that follow can't be applied.
  struct Mark {
    std::size_t changes = 0;
    PieceMarks pieces;
  };
  Mark mark() const;
  /// Restores the organ to the state at `mark` and removes all later entries from its log. `bodies`: number
  /// of soft bodies in the simulation, for checking the mark's body indices.
  void back_to(const Mark& mark, std::size_t bodies);

  /// Replays `log`, the changes of another instance of this organ, on this uncut organ. Then assigns its
  /// pieces to soft bodies as in `pieces`. Throws InputError if the log or the pieces are inconsistent.
  /// `bodies`: number of soft bodies in the simulation.
  void restore(OrganLog log, const PieceMarks& pieces, std::size_t bodies);

 private:
  cutting::TetComplex uncut(double density) const;
  void take_back(const std::vector<OrganChange*>& newest_first);
  void redo(OrganChange change);
  void go_back(std::size_t length);

  Anatomy whole_;
  std::vector<std::uint8_t> held_;
  cutting::TetComplex complex_;
  cutting::Skin skin_;
  cutting::TetTree tree_;  // cache
  OrganLog log_;
  OrganPieces grouping_;
};

}  // namespace prosector::organs
