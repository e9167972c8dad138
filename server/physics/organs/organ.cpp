#include "server/physics/organs/organ.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "common/error.h"
#include "server/physics/cutting/pieces.h"
#include "server/physics/cutting/touched.h"
#include "server/physics/organs/sheet_parts.h"
#include "server/physics/organs/surface_follow.h"
#include "server/physics/parallel.h"

namespace prosector {
namespace {

constexpr std::size_t nobody = ~std::size_t{0};
// Of the tetrahedra: where more are split, so much of the skin is near that all of it is looked at,
// meanwhile.
constexpr double much_share = 0.1;

bool meet(const std::vector<TetId>& a, const std::vector<TetId>& b) {
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
    if (*i == *j) return true;
    *i < *j ? ++i : ++j;
  }
  return false;
}

}  // namespace

Organ::Organ(std::size_t body, const Anatomy& anatomy, double density, std::vector<std::uint8_t> held)
    : whole_(without_edge_nodes(anatomy)),
      held_(std::move(held)),
      complex_(uncut(density)),
      skin_(complex_, std::make_shared<const OuterShape>(complex_, whole_.surface)),
      tree_(complex_),
      owner_(complex_.tet_end(), body) {
  pieces_.push_back({body, piece_mesh(complex_, complex_.tet_ids())});
}

TetComplex Organ::uncut(double density) const {
  return whole_.quads.empty() ? TetComplex(whole_.tets, density)
                              : TetComplex::of_sheet(whole_, density, held_);
}

bool Organ::has(std::size_t body) const {
  return std::any_of(pieces_.begin(), pieces_.end(),
                     [&](const OrganPiece& piece) { return piece.body == body && piece.whole(); });
}

CutResult Organ::cut(std::span<const Vec3> positions, std::span<const Vec3> edge, BladeStroke& blade,
                     ParticipantId author, std::uint64_t stroke) {
  CutResult result = prosector::cut(complex_, tree_, positions, edge, blade);
  if (!result.ops.empty()) {
    OrganChange& change = log_.emplace_back();
    change.author = author;
    change.stroke = stroke;
    change.ops = result.ops;
    const bool much =
        much_share * static_cast<double>(complex_.tets()) < static_cast<double>(result.split_tets);
    Skin::Change skin;
    parallel_both([&] { change.touched = touched_by(complex_, change.ops); },
                  [&] {
                    if (much) skin = skin_.update(complex_);
                  });
    note_touched(change.touched);
    if (!much) skin = skin_.follow(complex_, change.touched);
    note_changed(skin);
  }
  return result;
}

std::vector<OrganChange*> Organ::stroke_of(ParticipantId author) {
  std::vector<OrganChange*> out;
  for (auto change = log_.rbegin(); change != log_.rend(); ++change) {
    if (change->cause != TopologyCause::cut || change->taken_back || change->author != author) continue;
    if (!out.empty() && out.front()->stroke != change->stroke) break;
    out.push_back(&*change);
  }
  return out;
}

std::optional<std::uint64_t> Organ::last_stroke(ParticipantId author) const {
  for (auto change = log_.rbegin(); change != log_.rend(); ++change)
    if (change->cause == TopologyCause::cut && !change->taken_back && change->author == author)
      return change->stroke;
  return std::nullopt;
}

std::string Organ::undo(ParticipantId author) {
  const std::vector<OrganChange*> stroke = stroke_of(author);
  if (stroke.empty()) return "there is no cut of yours to undo";
  for (const OrganChange* change : stroke)
    for (const OrganChange& later : log_) {
      if (&later <= change || later.cause != TopologyCause::cut || later.taken_back) continue;
      if (later.stroke == change->stroke && later.author == author) continue;
      if (meet(change->touched, later.touched))
        return fmt::format("cut {} depends on it: that has to be undone first", later.stroke);
    }
  const TetComplex before = complex_;
  try {
    take_back(stroke);
  } catch (const InputError& error) {  // something hangs on it that touched() doesn't tell: nothing is undone
    complex_ = before;
    for (OrganChange* change : stroke) change->taken_back = false;
    note_from_here();
    return error.what();
  }
  OrganChange entry;
  entry.cause = TopologyCause::undo;
  entry.author = author;
  entry.stroke = stroke.front()->stroke;
  std::vector<TetId> touched;
  for (const OrganChange* change : stroke)
    touched.insert(touched.end(), change->touched.begin(), change->touched.end());
  note_changed(skin_.follow(complex_, touched));
  log_.push_back(std::move(entry));
  return {};
}

void Organ::take_back(const std::vector<OrganChange*>& newest_first) {
  for (OrganChange* change : newest_first) {
    for (auto op = change->ops.rbegin(); op != change->ops.rend(); ++op) {
      complex_.take_back(*op);
      if (const auto* split = std::get_if<SplitEdge>(&*op))
        for (TetId child = split->first; child < split->first + 2 * split->count; child += 2)
          owner_[complex_.parent(child)] = std::min(owner_[child], owner_[child + 1]);
    }
    change->taken_back = true;
    note_touched(change->touched);
  }
}

/// The bodies of these tetrahedra are made anew at the next regroup().
void Organ::note_touched(const std::vector<TetId>& tets) {
  const auto first = static_cast<TetId>(owner_.size());
  owner_.resize(std::max(owner_.size(), complex_.tet_end()), nobody);
  for (TetId tet = first; tet < owner_.size(); ++tet)  // children after their parents
    owner_[tet] = owner_[complex_.parent(tet)];
  for (const TetId tet : tets) changed_.insert(owner_[tet]);
  touched_.insert(touched_.end(), tets.begin(), tets.end());
}

void Organ::note_changed(const Skin::Change& skin) {
  skin_changed_.insert(skin_changed_.end(), skin.slots.begin(), skin.slots.end());
}

void Organ::note_from_here() {
  changed_.clear();
  touched_.clear();
  skin_changed_.clear();
  grouped_ = log_.size();
}

Organ::Regrouped Organ::regroup(std::size_t next_body) {
  struct Component {
    std::vector<TetId> tets;
    std::size_t owner = nobody;
    double volume = 0;
  };
  std::vector<Component> found;
  for (std::vector<TetId>& tets : prosector::pieces(complex_)) {
    Component& c = found.emplace_back();
    for (const TetId tet : tets) c.owner = std::min(c.owner, owner_[tet]);
    for (const TetId tet : tets) {
      c.volume += complex_.volume(tet);
      if (owner_[tet] == c.owner) continue;
      changed_.insert({owner_[tet], c.owner});  // they were joined
      owner_[tet] = c.owner;
    }
    c.tets = std::move(tets);
  }
  std::map<std::size_t, std::size_t> largest;  // of each body's components
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto [at, is_new] = largest.try_emplace(found[i].owner, i);
    if (!is_new && found[i].volume > found[at->second].volume) at->second = i;
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (largest.at(found[i].owner) == i) continue;
    found[i].owner = next_body++;
    for (const TetId tet : found[i].tets) owner_[tet] = found[i].owner;
    changed_.insert(found[i].owner);
  }
  Regrouped out;
  out.bodies.assign(changed_.begin(), changed_.end());
  for (OrganPiece& piece : pieces_)
    if (changed_.contains(piece.body) && piece.whole())
      out.before.push_back(std::exchange(piece, {piece.body, {}}));
  for (Component& c : found) {
    if (!changed_.contains(c.owner)) continue;
    auto at = std::find_if(pieces_.begin(), pieces_.end(),
                           [&](const OrganPiece& piece) { return piece.body == c.owner; });
    if (at == pieces_.end()) at = pieces_.insert(at, OrganPiece{c.owner, {}});
    at->mesh = piece_mesh(complex_, c.tets);
  }
  out.touched = std::move(touched_);
  out.skin_changed = std::move(skin_changed_);
  note_from_here();
  return out;
}

std::optional<PieceEdit> Organ::cut_in_one_piece() const {
  if (changed_.size() != 1) return std::nullopt;
  std::vector<TetId> slit;
  for (std::size_t i = grouped_; i < log_.size(); ++i) {
    if (log_[i].cause != TopologyCause::cut) return std::nullopt;
    for (const TopologyOp& op : log_[i].ops)
      if (const auto* faces = std::get_if<SlitFaces>(&op))
        for (const auto& [a, b] : faces->faces) slit.insert(slit.end(), {a, b});
  }
  if (!hang_together(complex_, slit)) return std::nullopt;
  const PieceMesh& before = piece(*changed_.begin()).mesh;
  PieceEdit edit = edit_of(complex_, before, touched_);
  if (complex_.is_sheet())
    edit.touched = touched_corners(complex_, before.nodes, edit.mesh.nodes, whole_, touched_);
  edit.body = *changed_.begin();
  return edit;
}

void Organ::follow(const PieceEdit& edit) {
  const auto piece =
      std::find_if(pieces_.begin(), pieces_.end(), [&](const OrganPiece& p) { return p.body == edit.body; });
  apply(complex_, edit, piece->mesh);
  note_from_here();
}

const OrganPiece& Organ::piece(std::size_t body) const {
  return *std::find_if(pieces_.begin(), pieces_.end(),
                       [&](const OrganPiece& piece) { return piece.body == body; });
}

std::optional<PieceEdit> Organ::edit_since(const Regrouped& then, const OrganPiece& piece) const {
  const auto before = std::find_if(then.before.begin(), then.before.end(),
                                   [&](const OrganPiece& old) { return old.body == piece.body; });
  if (!piece.whole() || before == then.before.end()) return std::nullopt;
  // As compiled, it may have nodes that no tetrahedron has.
  const TetMesh& mesh = piece.mesh.mesh;
  const bool numbered_alike = whole_.tets.positions.size() == mesh.positions.size() &&
                              (complex_.is_sheet() || whole_.tets.tets == mesh.tets);
  if (is_uncut() && !numbered_alike) return std::nullopt;
  PieceEdit edit = edit_between(before->mesh, piece.mesh);
  edit.body = piece.body;
  if (complex_.is_sheet())
    edit.touched = touched_corners(complex_, piece.mesh.nodes, edit.mesh.nodes, whole_, then.touched);
  return edit;
}

bool Organ::is_uncut() const {
  return std::all_of(log_.begin(), log_.end(), [](const OrganChange& change) {
    return change.cause != TopologyCause::cut || change.taken_back;
  });
}

Anatomy Organ::anatomy(const OrganPiece& piece, Numbering& numbering) const {
  numbering = {};
  if (!piece.whole()) return remnant(whole_);
  if (is_uncut()) return whole_;
  if (complex_.is_sheet()) return sheet_piece(complex_, piece.mesh, whole_, numbering);
  PieceSurface skin = surface(piece);
  numbering = std::move(skin.numbering);
  return {piece.mesh.mesh, std::move(skin.surface), std::move(skin.embedding)};
}

PieceSurface Organ::surface(const OrganPiece& piece) const {
  if (is_uncut()) return {whole_.surface, whole_.embedding, {}};
  return skinned(complex_, skin_, piece.mesh, static_cast<std::uint32_t>(whole_.surface.positions.size()),
                 static_cast<std::uint32_t>(whole_.surface.triangles.size()));
}

SurfaceEdit Organ::surface_edit(const PieceEdit& edit, const TriangleMesh& surface,
                                const Numbering& numbering) const {
  std::vector<NodeId> nodes = piece(edit.body).mesh.nodes;
  nodes.insert(nodes.end(), edit.nodes.begin(), edit.nodes.end());
  return surface_edit(edit.body, nodes, skin_changed_, surface, numbering);
}

std::optional<SurfaceEdit> Organ::surface_edit_since(const Regrouped& then, const OrganPiece& piece,
                                                     const TriangleMesh& surface,
                                                     const Numbering& numbering) const {
  if (complex_.is_sheet() || numbering.triangles.empty() || is_uncut()) return std::nullopt;
  // What went with another piece, or came with it, has the corners that it had.
  std::vector<std::uint32_t> slots = then.skin_changed;
  const auto first = static_cast<std::uint32_t>(whole_.surface.triangles.size());
  auto had = numbering.triangles.begin();
  for (std::uint32_t slot = 0; slot < skin_.triangles().size(); ++slot) {
    const bool was_its = had != numbering.triangles.end() && *had == first + slot;
    if (was_its) ++had;
    const bool is_its = !skin_.triangles()[slot].gone() && owner_[skin_.tet(slot)] == piece.body;
    if (was_its != is_its) slots.push_back(slot);
  }
  return surface_edit(piece.body, piece.mesh.nodes, std::move(slots), surface, numbering);
}

SurfaceEdit Organ::surface_edit(std::size_t body, std::span<const NodeId> nodes,
                                std::vector<std::uint32_t> slots, const TriangleMesh& surface,
                                const Numbering& numbering) const {
  return edit_of_surface(
      complex_, skin_, nodes, [&](TetId tet) { return owner_[tet] == body; }, std::move(slots), surface,
      numbering, static_cast<std::uint32_t>(whole_.surface.positions.size()),
      static_cast<std::uint32_t>(whole_.surface.triangles.size()));
}

}  // namespace prosector
