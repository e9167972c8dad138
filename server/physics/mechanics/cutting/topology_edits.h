#pragma once
// Elementary topology changes of a complex, each with its inverse. For an invalid operation, an edit throws
// InputError and changes nothing.

#include <array>
#include <vector>

#include "server/physics/mechanics/cutting/node_masses.h"
#include "server/physics/mechanics/cutting/tet_tables.h"

namespace prosector {

/// Scratch memory of edge splits, reused to avoid allocations.
struct EdgeScratch {
  std::vector<TetId> around;
  std::vector<std::array<double, 2>> halves;  // m³, per tetrahedron: the half with a, the half with b
};

/// The tables that edits change.
struct EditedTables {
  TetTables& tables;
  NodeMasses& masses;
  EdgeScratch& scratch;
};

void apply(const SplitEdge& op, EditedTables edited);
void apply(const SlitFaces& op, EditedTables edited);
void apply(const PartNode& op, EditedTables edited);

/// Undoes an operation, which must be the last in force. The tables get their previous values, except that
/// ids stay used.
void take_back(const SplitEdge& op, EditedTables edited);
void take_back(const SlitFaces& op, EditedTables edited);
void take_back(const PartNode& op, EditedTables edited);

}  // namespace prosector
