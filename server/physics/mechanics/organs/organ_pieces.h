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

namespace prosector::organs {

/// Connected piece of a cut organ, which is one of the simulation's soft bodies: the body's index and the
/// piece's mesh. The mesh is empty if the piece was joined to another by an undo.
struct OrganPiece {
  std::size_t body = 0;  // index among the soft bodies
  PieceMesh mesh;        // empty if the piece was joined to another
  bool whole() const { return !mesh.tets.empty(); }
};

/// Saved assignment of an organ's pieces to soft bodies: for each piece its body index and the lowest id of
/// its tetrahedra. The id is none if the piece was joined to another.
using PieceMarks = std::vector<std::pair<std::size_t, std::optional<cutting::TetId>>>;

/// Changes of an organ since its pieces were last computed: soft bodies, tetrahedra and surface triangles
/// that changed. Also stores the length that the organ's log of cuts had at the last computation.
struct PieceChanges {
  std::set<std::size_t> bodies;
  std::vector<cutting::TetId> touched;
  std::vector<std::uint32_t> skin;  // slots of its triangles
  std::size_t log_from = 0;         // length of the organ's log at that time
};

/// Result of recomputing an organ's pieces: the changed pieces in their previous state, and the soft bodies,
/// tetrahedra and surface triangles that changed.
struct Regrouped {
  std::vector<OrganPiece> before;           // the changed pieces, in their state before
  std::vector<std::size_t> bodies;          // bodies that changed, appeared or vanished; ascending
  std::vector<cutting::TetId> touched;      // by the changes
  std::vector<std::uint32_t> skin_changed;  // slots of its triangles
};

/// Assignment of an organ's tetrahedra to its connected pieces, each of which is a soft body, and the record
/// of changes since the last assignment.
class OrganPieces {
 public:
  /// Initialises with all tetrahedra of `complex`, an organ's mesh, as one piece, which is the soft body with
  /// index `body`.
  OrganPieces(const cutting::TetComplex& complex, std::size_t body);

  const std::vector<OrganPiece>& all() const { return pieces_; }  // by body, ascending
  const OrganPiece& piece(std::size_t body) const;                // must be or have been a piece
  bool has(std::size_t body) const;                               // as a piece with tetrahedra
  /// Returns the index of the soft body to which the organ's tetrahedron with id `tet` belongs, or last
  /// belonged if the tetrahedron was split or removed.
  std::size_t owner(cutting::TetId tet) const { return owner_[tet]; }
  const PieceChanges& changes() const { return changes_; }
  PieceMarks marks() const;

  /// Records a cut or an undo that changed the tetrahedra `tets` (ids): their soft bodies count as changed.
  /// Before that, assigns each tetrahedron that the cut created to the body of its parent. Throws InputError
  /// if an id up to the newest tetrahedron was skipped, which only a damaged log of cuts does.
  void note_touched(const cutting::TetComplex& complex, std::span<const cutting::TetId> tets);
  void note_skin(const cutting::Skin::Change& skin);
  /// Clears the recorded changes and stores the current length of the organ's log, `log_entries`, as the
  /// start of the next record.
  void note_from(std::size_t log_entries);
  /// Records that `split` (the bisection of an edge) was undone. Assigns each rejoined tetrahedron to the
  /// soft body of its two halves, or to the lower body index if the halves were in different bodies.
  void note_joined(const cutting::TetComplex& complex, const cutting::SplitEdge& split);

  /// Recomputes the connected pieces after changes of the organ's mesh `complex`, and returns what changed.
  /// If a body fell apart, its piece of largest volume keeps the index; the others get body indices from
  /// `next_body` on. Pieces that were joined become the body with the lowest index. `log_entries`: current
  /// length of the organ's log.
  Regrouped regroup(const cutting::TetComplex& complex, std::size_t next_body, std::size_t log_entries);
  /// Applies `edit` to the mesh of the one piece that changed, and clears the recorded changes. It is the
  /// fast alternative to regroup() for cuts that sever nothing. `log_entries`: current length of the organ's
  /// log.
  void follow(const cutting::TetComplex& complex, const PieceEdit& edit, std::size_t log_entries);
  /// Restores the pieces of the earlier state `then` of the same organ. Soft bodies that were created later
  /// remain as pieces without tetrahedra. `log_entries`: current length of the organ's log.
  void go_back_to(const OrganPieces& then, std::size_t log_entries);

  /// Assigns the connected components of `complex` to soft bodies as saved in `marks`. Throws InputError if
  /// `marks` do not match the components. `bodies`: number of soft bodies in the simulation; `log_entries`:
  /// length of the organ's log.
  void restore(const PieceMarks& marks, const cutting::TetComplex& complex, std::size_t bodies,
               std::size_t log_entries);

 private:
  struct Component;
  std::vector<Component> components(const cutting::TetComplex& complex);
  void name_new(std::vector<Component>& found, std::size_t next_body);
  OrganPiece& find_or_add(std::size_t body);

  std::vector<std::size_t> owner_;  // by tetrahedron
  std::vector<OrganPiece> pieces_;
  PieceChanges changes_;
};

}  // namespace prosector::organs
