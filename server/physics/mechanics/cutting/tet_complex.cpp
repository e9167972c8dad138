#include "server/physics/mechanics/cutting/tet_complex.h"

#include <utility>
#include <variant>

#include "common/anatomy/sheets_and_ropes.h"
#include "common/assert.h"
#include "common/hash.h"

namespace prosector::cutting {

TetComplex::TetComplex(TetTables tables, NodeMasses masses)
    : tables_(std::move(tables)), masses_(std::move(masses)) {
  connect(tables_);
}

TetComplex::TetComplex(const TetMesh& rest, double density)
    : TetComplex(tables_of(rest), NodeMasses(density)) {
  masses_.start(tables_);
}

TetComplex TetComplex::of_sheet(const Anatomy& sheet, double density, std::vector<std::uint8_t> held) {
  PROSECTOR_ASSERT(held.empty() || held.size() == sheet.tets.positions.size());
  TetComplex out(tables_of_sheet(sheet), NodeMasses(density));
  out.masses_.start_sheet(sheet_node_volumes(sheet), std::move(held));
  return out;
}

void TetComplex::apply(const TopologyOp& op) {
  std::visit([&](const auto& o) { cutting::apply(o, EditedTables{tables_, masses_, scratch_}); }, op);
}

void TetComplex::take_back(const TopologyOp& op) {
  std::visit([&](const auto& o) { cutting::take_back(o, EditedTables{tables_, masses_, scratch_}); }, op);
  ++undone_;
}

void TetComplex::continue_from(const TetComplex& later) {
  PROSECTOR_ASSERT(later.sides() == sides());
  PROSECTOR_ASSERT(later.node_end() >= node_end() && later.tet_end() >= tet_end());
  tables_.grow_nodes(later.node_end());
  masses_.grow(later.node_end());
  tables_.grow_tets(later.tet_end());
  undone_ = later.undone_ + 1;
}

std::uint64_t content_hash(const TetComplex& complex) {
  StateHasher hash;
  hash.add(complex.density());
  for (NodeId i = 0; i < complex.node_end(); ++i) {
    if (!complex.has_node(i)) continue;
    hash.add(i);
    hash.add(complex.rest(i).data(), 3);
    hash.add(complex.mass(i));
  }
  for (TetId t = 0; t < complex.tet_end(); ++t) {
    if (!complex.has_tet(t)) continue;
    const TetTables::Tet& tet = complex.tables().tet[t];
    hash.add(t);
    hash.add(std::as_bytes(std::span(tet.corner)));
    hash.add(std::as_bytes(std::span(tet.beyond)));
    hash.add(tet.wall);
  }
  return hash.digest();
}

std::vector<NodeId> node_ids(const TetComplex& complex) {
  std::vector<NodeId> ids;
  ids.reserve(complex.nodes());
  for (NodeId i = 0; i < complex.node_end(); ++i)
    if (complex.has_node(i)) ids.push_back(i);
  PROSECTOR_ASSERT(ids.size() == complex.nodes());
  return ids;
}

std::vector<TetId> tet_ids(const TetComplex& complex) {
  std::vector<TetId> ids;
  ids.reserve(complex.tets());
  for (TetId t = 0; t < complex.tet_end(); ++t)
    if (complex.has_tet(t)) ids.push_back(t);
  PROSECTOR_ASSERT(ids.size() == complex.tets());
  return ids;
}

}  // namespace prosector::cutting
