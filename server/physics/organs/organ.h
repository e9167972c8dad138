#pragma once
// A soft body of the scene as it has been cut: its tetrahedra, or a sheet's triangles, with all that hangs on
// them, the pieces that they fall into, each of which is a body of its own, and the log of what was done.

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "common/messages.h"
#include "server/physics/byte_stream.h"
#include "server/physics/cutting/skin.h"
#include "server/physics/cutting/tet_complex.h"
#include "server/physics/cutting/volume_cut.h"
#include "server/physics/organs/organ_parts.h"
#include "server/physics/surface_edit.h"
#include "server/physics/topology.h"

namespace prosector {

/// One entry of an organ's log: append-only, what is undone stays in it.
struct OrganChange {
  TopologyCause cause = TopologyCause::cut;
  ParticipantId author = 0;
  /// Cuts of one stroke are undone together; of an undo: the stroke undone; of a rewind: how many entries of
  /// the log it went back to.
  std::uint64_t stroke = 0;
  std::vector<TopologyOp> ops;  // of a cut
  std::vector<TetId> touched;   // of a cut: what later cuts must leave alone for it to be undone; ascending
  bool taken_back = false;      // by a later undo or rewind
};

/// A piece of an organ: one of the simulation's soft bodies.
struct OrganPiece {
  std::size_t body = 0;  // index among the soft bodies
  PieceMesh mesh;        // no tetrahedra: it was joined to another again
  bool whole() const { return !mesh.tets.empty(); }
};

class Organ {
 public:
  /// Of soft body `body`, which was never cut: tetrahedra, with or without nodes on their edges, or a sheet.
  /// `held`: by node of a sheet, what is tied to its place; empty: nothing.
  Organ(std::size_t body, const Anatomy& anatomy, double density, std::vector<std::uint8_t> held = {});

  const TetComplex& complex() const { return complex_; }
  const std::vector<OrganPiece>& pieces() const { return pieces_; }
  const std::vector<OrganChange>& log() const { return log_; }
  bool has(std::size_t body) const;  // as a piece that is still one

  /// One tick of a blade's stroke, see volume_cut.h. `positions`: of every node, by id, m. Without operations
  /// in the result nothing changed.
  CutResult cut(std::span<const Vec3> positions, std::span<const Vec3> edge, BladeStroke& blade,
                ParticipantId author, std::uint64_t stroke);
  /// Takes back the author's last stroke. Empty when done, else why not.
  std::string undo(ParticipantId author);
  std::optional<std::uint64_t> last_stroke(ParticipantId author) const;  // that undo() would take back
  /// Everything as in `then`, this organ's own earlier state: cuts made since are taken back, those undone
  /// since are made again, under the ids that they had. Throws InputError, and changes nothing, where the log
  /// doesn't begin with `then`'s. Bodies that came since stay, as pieces without tetrahedra.
  void rewind(const Organ& then, ParticipantId author);

  /// Finds the pieces anew after changes: of a body that fell apart the largest piece stays it; the others
  /// get body indices from `next_body` on.
  struct Regrouped {
    std::vector<OrganPiece> before;           // the pieces that changed, as they were
    std::vector<std::size_t> bodies;          // that changed, came or went; ascending
    std::vector<TetId> touched;               // by the changes
    std::vector<std::uint32_t> skin_changed;  // slots of its triangles
  };
  Regrouped regroup(std::size_t next_body);
  /// From the mesh that anatomy() gave of the body before that regroup() to the one that it gives now; none
  /// of what wasn't or isn't a piece.
  std::optional<PieceEdit> edit_since(const Regrouped& then, const OrganPiece& piece) const;
  /// Likewise from the surface of tetrahedra that it had, and its numbering, to the one that it has now; none
  /// where one of them is the compiled one.
  std::optional<SurfaceEdit> surface_edit_since(const Regrouped& then, const OrganPiece& piece,
                                                const TriangleMesh& surface,
                                                const Numbering& numbering) const;
  const OrganPiece& piece(std::size_t body) const;
  /// Where the changes since the last regroup() are cuts in one piece that nothing came off: what they did to
  /// its mesh.
  std::optional<PieceEdit> cut_in_one_piece() const;
  /// In place of regroup(): takes that piece along.
  void follow(const PieceEdit& edit);

  /// The geometry of a piece: its tetrahedra, and as the surface their skin, walls of cuts as inner, or its
  /// part of the sheet; the compiled mesh while no cut is in force; of what is no piece any more one
  /// tetrahedron or cell without a surface.
  Anatomy anatomy(const OrganPiece& piece, Numbering& numbering) const;
  /// The surface alone.
  PieceSurface surface(const OrganPiece& piece) const;
  /// Before follow(): what the changes since the last regroup() or follow() did to the surface of the piece
  /// that they are in, which had been cut before; `surface` and `numbering`: what it had.
  SurfaceEdit surface_edit(const PieceEdit& edit, const TriangleMesh& surface,
                           const Numbering& numbering) const;
  const Anatomy& whole() const { return whole_; }  // as compiled
  const std::vector<std::uint8_t>& held() const { return held_; }

  /// A place in the log, and the pieces there, to go back to where what followed could not take effect.
  struct Mark {
    std::size_t changes = 0;
    std::vector<std::pair<std::size_t, std::optional<TetId>>> pieces;  // body; its first tetrahedron
  };
  Mark mark() const;
  /// As if nothing had been done since: the log is cut off there. `bodies`: how many soft bodies there are.
  void back_to(const Mark& mark, std::size_t bodies);

  void save(ByteWriter& out) const;
  /// Takes the uncut organ through a saved log. Throws InputError for what doesn't fit; `bodies`: how many
  /// soft bodies there are.
  void load(ByteReader& in, std::size_t bodies);

 private:
  void save_changes(ByteWriter& out, std::size_t count) const;
  static void save_pieces(ByteWriter& out, const Mark& mark);
  std::vector<OrganChange*> stroke_of(ParticipantId author);
  void take_back(const std::vector<OrganChange*>& newest_first);
  void redo(OrganChange change);
  void go_back(std::size_t length);
  void note_touched(const std::vector<TetId>& tets);
  void note_changed(const Skin::Change& skin);
  void note_from_here();
  bool is_uncut() const;  // no cut is in force
  SurfaceEdit surface_edit(std::size_t body, std::span<const NodeId> nodes, std::vector<std::uint32_t> slots,
                           const TriangleMesh& surface, const Numbering& numbering) const;

  TetComplex uncut(double density) const;

  Anatomy whole_;  // as compiled, without nodes on edges
  std::vector<std::uint8_t> held_;
  TetComplex complex_;
  Skin skin_;
  TetTree tree_;                             // cache
  std::vector<std::size_t> owner_;           // by tetrahedron: the body that it is, or was, part of
  std::set<std::size_t> changed_;            // bodies, since the last regroup() or follow()
  std::size_t grouped_ = 0;                  // entries of the log, then
  std::vector<TetId> touched_;               // since then
  std::vector<std::uint32_t> skin_changed_;  // slots of its triangles, since then
  std::vector<OrganChange> log_;
  std::vector<OrganPiece> pieces_;  // by body
};

}  // namespace prosector
