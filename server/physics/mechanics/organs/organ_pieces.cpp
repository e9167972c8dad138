#include "server/physics/mechanics/organs/organ_pieces.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "common/assert.h"
#include "common/error.h"
#include "server/physics/mechanics/cutting/pieces.h"

namespace prosector::organs {
namespace {

constexpr std::size_t no_body = ~std::size_t{0};

}  // namespace

/// Connected tetrahedra.
struct OrganPieces::Component {
  std::vector<cutting::TetId> tets;
  std::size_t owner = no_body;
  double volume = 0;  // m³
};

OrganPieces::OrganPieces(const cutting::TetComplex& complex, std::size_t body)
    : owner_(complex.tet_end(), body) {
  pieces_.push_back({body, piece_mesh(complex, cutting::tet_ids(complex))});
}

const OrganPiece& OrganPieces::piece(std::size_t body) const {
  PROSECTOR_ASSERT(std::ranges::find(pieces_, body, &OrganPiece::body) != pieces_.end());
  return *std::find_if(pieces_.begin(), pieces_.end(),
                       [&](const OrganPiece& piece) { return piece.body == body; });
}

bool OrganPieces::has(std::size_t body) const {
  return std::any_of(pieces_.begin(), pieces_.end(),
                     [&](const OrganPiece& piece) { return piece.body == body && piece.whole(); });
}

PieceMarks OrganPieces::marks() const {
  PieceMarks out;
  for (const OrganPiece& piece : pieces_) {
    std::optional<cutting::TetId> first;
    if (piece.whole()) first = *std::min_element(piece.mesh.tets.begin(), piece.mesh.tets.end());
    out.emplace_back(piece.body, first);
  }
  return out;
}

void OrganPieces::note_touched(const cutting::TetComplex& complex, std::span<const cutting::TetId> tets) {
  const auto first = static_cast<cutting::TetId>(owner_.size());
  owner_.resize(std::max(owner_.size(), complex.tet_end()), no_body);
  for (cutting::TetId tet = first; tet < owner_.size(); ++tet) {  // parents precede children
    const cutting::TetId parent = complex.lineage(tet).parent;
    if (parent == cutting::TetComplex::none)
      throw InputError(
          "the log of cuts is damaged: it skips the id of a tetrahedron that no edge split created");
    owner_[tet] = owner_[parent];
  }
  for (const cutting::TetId tet : tets) changes_.bodies.insert(owner_[tet]);
  changes_.touched.insert(changes_.touched.end(), tets.begin(), tets.end());
}

void OrganPieces::note_skin(const cutting::Skin::Change& skin) {
  changes_.skin.insert(changes_.skin.end(), skin.slots.begin(), skin.slots.end());
}

void OrganPieces::note_from(std::size_t log_entries) {
  changes_.bodies.clear();
  changes_.touched.clear();
  changes_.skin.clear();
  changes_.log_from = log_entries;
}

void OrganPieces::note_joined(const cutting::TetComplex& complex, const cutting::SplitEdge& split) {
  PROSECTOR_ASSERT(split.first + 2 * std::size_t{split.count} <= owner_.size());
  for (cutting::TetId child = split.first; child < split.first + 2 * split.count; child += 2)
    owner_[complex.lineage(child).parent] = std::min(owner_[child], owner_[child + 1]);
}

/// Finds connected components; a component with several bodies gets the lowest of them.
std::vector<OrganPieces::Component> OrganPieces::components(const cutting::TetComplex& complex) {
  PROSECTOR_ASSERT(owner_.size() >= complex.tet_end());
  std::vector<Component> found;
  for (std::vector<cutting::TetId>& tets : cutting::pieces(complex)) {
    Component& c = found.emplace_back();
    for (const cutting::TetId tet : tets) c.owner = std::min(c.owner, owner_[tet]);
    for (const cutting::TetId tet : tets) {
      c.volume += complex.volume(tet);
      if (owner_[tet] == c.owner) continue;
      changes_.bodies.insert({owner_[tet], c.owner});  // they were joined
      owner_[tet] = c.owner;
    }
    c.tets = std::move(tets);
  }
  return found;
}

/// Keeps each body's index for its largest component; the others become bodies from `next_body` on.
void OrganPieces::name_new(std::vector<Component>& found, std::size_t next_body) {
  PROSECTOR_ASSERT(!pieces_.empty() && pieces_.back().body < next_body);
  std::map<std::size_t, std::size_t> largest;  // of each body's components
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto [at, is_new] = largest.try_emplace(found[i].owner, i);
    if (!is_new && found[i].volume > found[at->second].volume) at->second = i;
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (largest.at(found[i].owner) == i) continue;
    found[i].owner = next_body++;
    for (const cutting::TetId tet : found[i].tets) owner_[tet] = found[i].owner;
    changes_.bodies.insert(found[i].owner);
  }
}

OrganPiece& OrganPieces::find_or_add(std::size_t body) {
  auto at = std::find_if(pieces_.begin(), pieces_.end(),
                         [&](const OrganPiece& piece) { return piece.body == body; });
  if (at == pieces_.end()) at = pieces_.insert(at, OrganPiece{body, {}});
  return *at;
}

Regrouped OrganPieces::regroup(const cutting::TetComplex& complex, std::size_t next_body,
                               std::size_t log_entries) {
  std::vector<Component> found = components(complex);
  name_new(found, next_body);
  Regrouped out;
  out.bodies.assign(changes_.bodies.begin(), changes_.bodies.end());
  for (OrganPiece& piece : pieces_)
    if (changes_.bodies.contains(piece.body) && piece.whole())
      out.before.push_back(std::exchange(piece, {piece.body, {}}));
  for (const Component& c : found)
    if (changes_.bodies.contains(c.owner)) find_or_add(c.owner).mesh = piece_mesh(complex, c.tets);
  PROSECTOR_ASSERT(std::ranges::is_sorted(pieces_, {}, &OrganPiece::body));
  out.touched = std::move(changes_.touched);
  out.skin_changed = std::move(changes_.skin);
  note_from(log_entries);
  return out;
}

void OrganPieces::follow(const cutting::TetComplex& complex, const PieceEdit& edit, std::size_t log_entries) {
  apply(complex, edit, find_or_add(edit.body).mesh);
  note_from(log_entries);
}

void OrganPieces::go_back_to(const OrganPieces& then, std::size_t log_entries) {
  for (OrganPiece& piece : pieces_) piece.mesh = {};
  for (const OrganPiece& piece : then.pieces_) {
    for (const cutting::TetId tet : piece.mesh.tets) owner_[tet] = piece.body;
    find_or_add(piece.body).mesh = piece.mesh;
  }
  note_from(log_entries);
}

void OrganPieces::restore(const PieceMarks& marks, const cutting::TetComplex& complex, std::size_t bodies,
                          std::size_t log_entries) {
  const auto require = [](bool good, const char* problem) {
    if (!good) throw InputError(std::string("pieces: ") + problem);
  };
  const std::vector<std::vector<cutting::TetId>> found = cutting::pieces(complex);
  require(marks.size() <= bodies, "more pieces than bodies");
  pieces_.clear();
  note_from(log_entries);
  std::size_t used = 0;
  for (const auto& [body, first] : marks) {
    require(body < bodies && (pieces_.empty() || pieces_.back().body < body), "a piece out of order");
    OrganPiece& piece = pieces_.emplace_back();
    piece.body = body;
    if (!first) continue;
    const auto at = std::find_if(
        found.begin(), found.end(),
        [&, id = *first](const std::vector<cutting::TetId>& tets) { return tets.front() == id; });
    require(at != found.end(), "a nonexistent piece");
    piece.mesh = piece_mesh(complex, *at);
    for (const cutting::TetId tet : *at) owner_[tet] = piece.body;
    ++used;
  }
  require(used == found.size(), "the list of pieces is damaged: a piece of the cut organ is missing in it");
}

}  // namespace prosector::organs
