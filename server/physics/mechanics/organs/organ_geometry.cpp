#include "server/physics/mechanics/organs/organ_geometry.h"

#include <algorithm>
#include <utility>

#include "server/physics/mechanics/cutting/pieces.h"
#include "server/physics/mechanics/organs/sheet_parts.h"
#include "server/physics/mechanics/organs/surface_follow.h"

namespace prosector::organs {
namespace {

SurfaceEdit surface_edit(const Organ& organ, std::size_t body, std::span<const cutting::NodeId> nodes,
                         std::vector<std::uint32_t> slots, const TriangleMesh& surface,
                         const Numbering& numbering) {
  const TriangleMesh& compiled = organ.whole().surface;
  return edit_of_surface(
      organ.complex(), organ.skin(), nodes,
      [&](cutting::TetId tet) { return organ.grouping().owner(tet) == body; }, std::move(slots), surface,
      numbering, static_cast<std::uint32_t>(compiled.positions.size()),
      static_cast<std::uint32_t>(compiled.triangles.size()));
}

}  // namespace

Anatomy anatomy_of(const Organ& organ, const OrganPiece& piece, Numbering& numbering) {
  numbering = {};
  if (!piece.whole()) return remnant(organ.whole());
  if (is_uncut(organ.log())) return organ.whole();
  if (organ.complex().is_sheet()) return sheet_piece(organ.complex(), piece.mesh, organ.whole(), numbering);
  PieceSurface skin = surface_of(organ, piece);
  numbering = std::move(skin.numbering);
  return {{piece.mesh.mesh.positions, piece.mesh.mesh.tets, organ.whole().tets.stretch},
          std::move(skin.surface),
          std::move(skin.embedding)};
}

PieceSurface surface_of(const Organ& organ, const OrganPiece& piece) {
  const Anatomy& whole = organ.whole();
  if (is_uncut(organ.log())) return {whole.surface, whole.embedding, {}};
  return skinned(organ.complex(), organ.skin(), piece.mesh,
                 static_cast<std::uint32_t>(whole.surface.positions.size()),
                 static_cast<std::uint32_t>(whole.surface.triangles.size()));
}

std::optional<PieceEdit> cut_in_one_piece(const Organ& organ) {
  const PieceChanges& changes = organ.grouping().changes();
  if (changes.bodies.size() != 1) return std::nullopt;
  std::vector<cutting::TetId> slit;
  for (std::size_t i = changes.log_from; i < organ.log().size(); ++i) {
    if (organ.log()[i].cause != TopologyCause::cut) return std::nullopt;
    for (const cutting::TopologyOp& op : organ.log()[i].ops)
      if (const auto* faces = std::get_if<cutting::SlitFaces>(&op))
        for (const auto& [a, b] : faces->faces) slit.insert(slit.end(), {a, b});
  }
  const cutting::TetComplex& complex = organ.complex();
  if (!cutting::hang_together(complex, slit)) return std::nullopt;
  const PieceMesh& before = organ.piece(*changes.bodies.begin()).mesh;
  PieceEdit edit = edit_of(complex, before, changes.touched);
  if (complex.is_sheet())
    edit.touched = touched_corners(complex, before.nodes, edit.mesh.nodes, organ.whole(), changes.touched);
  edit.body = *changes.bodies.begin();
  return edit;
}

SurfaceEdit surface_edit(const Organ& organ, const PieceEdit& edit, const TriangleMesh& surface,
                         const Numbering& numbering) {
  std::vector<cutting::NodeId> nodes = organ.piece(edit.body).mesh.nodes;
  nodes.insert(nodes.end(), edit.nodes.begin(), edit.nodes.end());
  return surface_edit(organ, edit.body, nodes, organ.grouping().changes().skin, surface, numbering);
}

std::optional<PieceEdit> edit_since(const Organ& organ, const Regrouped& then, const OrganPiece& piece) {
  const auto before = std::find_if(then.before.begin(), then.before.end(),
                                   [&](const OrganPiece& old) { return old.body == piece.body; });
  if (!piece.whole() || before == then.before.end()) return std::nullopt;
  // The compiled mesh may have nodes without tetrahedra.
  const cutting::TetComplex& complex = organ.complex();
  const Anatomy& whole = organ.whole();
  const TetMesh& mesh = piece.mesh.mesh;
  const bool numbered_alike = whole.tets.positions.size() == mesh.positions.size() &&
                              (complex.is_sheet() || whole.tets.tets == mesh.tets);
  if (is_uncut(organ.log()) && !numbered_alike) return std::nullopt;
  PieceEdit edit = edit_between(before->mesh, piece.mesh);
  edit.body = piece.body;
  if (complex.is_sheet())
    edit.touched = touched_corners(complex, piece.mesh.nodes, edit.mesh.nodes, whole, then.touched);
  return edit;
}

std::optional<SurfaceEdit> surface_edit_since(const Organ& organ, const Regrouped& then,
                                              const OrganPiece& piece, const TriangleMesh& surface,
                                              const Numbering& numbering) {
  if (organ.complex().is_sheet() || numbering.triangles.empty() || is_uncut(organ.log())) return std::nullopt;
  // Triangles that left or joined with another piece kept their corners.
  std::vector<std::uint32_t> slots = then.skin_changed;
  const cutting::Skin& skin = organ.skin();
  const auto first = static_cast<std::uint32_t>(organ.whole().surface.triangles.size());
  auto had = numbering.triangles.begin();
  for (std::uint32_t slot = 0; slot < skin.triangles().size(); ++slot) {
    const bool was_its = had != numbering.triangles.end() && *had == first + slot;
    if (was_its) ++had;
    const bool is_its =
        !skin.triangles()[slot].gone() && organ.grouping().owner(skin.tet(slot)) == piece.body;
    if (was_its != is_its) slots.push_back(slot);
  }
  return surface_edit(organ, piece.body, piece.mesh.nodes, std::move(slots), surface, numbering);
}

}  // namespace prosector::organs
