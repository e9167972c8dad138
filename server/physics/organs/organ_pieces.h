#pragma once
// The pieces that an organ falls into, each of which is a body of its own, and what changed in them since
// they were last grouped.

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "common/byte_stream.h"
#include "server/physics/cutting/skin.h"
#include "server/physics/cutting/tet_complex.h"
#include "server/physics/organs/organ_parts.h"

namespace prosector {

/// A piece of an organ: one of the simulation's soft bodies.
struct OrganPiece {
  std::size_t body = 0;  // index among the soft bodies
  PieceMesh mesh;        // no tetrahedra: it was joined to another again
  bool whole() const { return !mesh.tets.empty(); }
};

/// By piece: its body, and its first tetrahedron; none of one that was joined to another.
using PieceMarks = std::vector<std::pair<std::size_t, std::optional<TetId>>>;

/// What changed since pieces were last grouped.
struct PieceChanges {
  std::set<std::size_t> bodies;
  std::vector<TetId> touched;
  std::vector<std::uint32_t> skin;  // slots of its triangles
  std::size_t log_from = 0;         // entries that the organ's log had then
};

/// What grouping pieces anew led to.
struct Regrouped {
  std::vector<OrganPiece> before;           // the pieces that changed, as they were
  std::vector<std::size_t> bodies;          // that changed, came or went; ascending
  std::vector<TetId> touched;               // by the changes
  std::vector<std::uint32_t> skin_changed;  // slots of its triangles
};

class OrganPieces {
 public:
  /// Takes the whole complex as one piece, which is this body.
  OrganPieces(const TetComplex& complex, std::size_t body);

  const std::vector<OrganPiece>& all() const { return pieces_; }  // by body, ascending
  const OrganPiece& piece(std::size_t body) const;                // which must be or have been one
  bool has(std::size_t body) const;                               // as a piece that is still one
  /// Returns the body that the tetrahedron is, or was, part of.
  std::size_t owner(TetId tet) const { return owner_[tet]; }
  const PieceChanges& changes() const { return changes_; }
  PieceMarks marks() const;

  /// Gives new tetrahedra to the bodies of those that they came from. Notes the bodies of `tets` as changed.
  void note_touched(const TetComplex& complex, std::span<const TetId> tets);
  void note_skin(const Skin::Change& skin);
  /// Notes that nothing changed since the log had so many entries.
  void note_from(std::size_t log_entries);
  /// Gives tetrahedra that are whole again to the body of their halves; the lower where these differ.
  void note_joined(const TetComplex& complex, const SplitEdge& split);

  /// Finds the pieces anew after changes: of a body that fell apart the largest piece stays it; the others
  /// get body indices from `next_body` on. `log_entries`: how many the log has.
  Regrouped regroup(const TetComplex& complex, std::size_t next_body, std::size_t log_entries);
  /// Takes the one piece that an edit was made in along with it, in place of regroup().
  void follow(const TetComplex& complex, const PieceEdit& edit, std::size_t log_entries);
  /// Makes the pieces those of an earlier state; bodies that came since stay, without tetrahedra.
  void go_back_to(const OrganPieces& then, std::size_t log_entries);

  /// Reads pieces of the complex as it is. Throws InputError for what doesn't fit; `bodies`: how many soft
  /// bodies there are.
  void load(ByteReader& in, const TetComplex& complex, std::size_t bodies, std::size_t log_entries);

 private:
  struct Component;
  std::vector<Component> components(const TetComplex& complex);
  void name_new(std::vector<Component>& found, std::size_t next_body);
  OrganPiece& find_or_add(std::size_t body);

  std::vector<std::size_t> owner_;  // by tetrahedron
  std::vector<OrganPiece> pieces_;
  PieceChanges changes_;
};

void save(ByteWriter& out, const PieceMarks& marks);

}  // namespace prosector
