#pragma once
// The connected pieces of an organ, each a soft body, and their changes since the last grouping.

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "server/physics/mechanics/cutting/skin.h"
#include "server/physics/mechanics/cutting/tet_complex.h"
#include "server/physics/mechanics/organs/organ_parts.h"

namespace prosector {

/// A piece of an organ: one of the simulation's soft bodies.
struct OrganPiece {
  std::size_t body = 0;  // index among the soft bodies
  PieceMesh mesh;        // empty if the piece was joined to another
  bool whole() const { return !mesh.tets.empty(); }
};

/// By piece: its body, and its first tetrahedron; none if the piece was joined to another.
using PieceMarks = std::vector<std::pair<std::size_t, std::optional<TetId>>>;

/// Changes since the last grouping of pieces.
struct PieceChanges {
  std::set<std::size_t> bodies;
  std::vector<TetId> touched;
  std::vector<std::uint32_t> skin;  // slots of its triangles
  std::size_t log_from = 0;         // length of the organ's log at that time
};

/// Result of a regrouping.
struct Regrouped {
  std::vector<OrganPiece> before;           // the changed pieces, in their state before
  std::vector<std::size_t> bodies;          // bodies that changed, appeared or vanished; ascending
  std::vector<TetId> touched;               // by the changes
  std::vector<std::uint32_t> skin_changed;  // slots of its triangles
};

/// Assignment of an organ's tetrahedra to pieces.
class OrganPieces {
 public:
  /// Initialises with the whole complex as one piece, which is this body.
  OrganPieces(const TetComplex& complex, std::size_t body);

  const std::vector<OrganPiece>& all() const { return pieces_; }  // by body, ascending
  const OrganPiece& piece(std::size_t body) const;                // must be or have been a piece
  bool has(std::size_t body) const;                               // as a piece with tetrahedra
  /// Returns the body to which the tetrahedron belongs or belonged.
  std::size_t owner(TetId tet) const { return owner_[tet]; }
  const PieceChanges& changes() const { return changes_; }
  PieceMarks marks() const;

  /// Assigns new tetrahedra to the bodies of their parents. Records the bodies of `tets` as changed.
  void note_touched(const TetComplex& complex, std::span<const TetId> tets);
  void note_skin(const Skin::Change& skin);
  /// Clears the changes; the log now has this length.
  void note_from(std::size_t log_entries);
  /// Assigns rejoined tetrahedra to the body of their halves; to the lower one if these differ.
  void note_joined(const TetComplex& complex, const SplitEdge& split);

  /// Recomputes the pieces after changes. If a body fell apart, its largest piece keeps the index; the others
  /// get body indices from `next_body` on. `log_entries`: length of the log.
  Regrouped regroup(const TetComplex& complex, std::size_t next_body, std::size_t log_entries);
  /// Updates the piece of an edit incrementally, instead of regroup().
  void follow(const TetComplex& complex, const PieceEdit& edit, std::size_t log_entries);
  /// Restores the pieces of an earlier state. Bodies that were created later remain, without tetrahedra.
  void go_back_to(const OrganPieces& then, std::size_t log_entries);

  /// Sets the pieces from `marks`, for the current complex. Throws InputError for inconsistent input.
  /// `bodies`: number of soft bodies.
  void restore(const PieceMarks& marks, const TetComplex& complex, std::size_t bodies,
               std::size_t log_entries);

 private:
  struct Component;
  std::vector<Component> components(const TetComplex& complex);
  void name_new(std::vector<Component>& found, std::size_t next_body);
  OrganPiece& find_or_add(std::size_t body);

  std::vector<std::size_t> owner_;  // by tetrahedron
  std::vector<OrganPiece> pieces_;
  PieceChanges changes_;
};

}  // namespace prosector
