#pragma once
// The elementary changes of a complex, each beside its inverse. An edit throws InputError, and changes
// nothing, for an operation that doesn't fit.

#include <array>
#include <vector>

#include "server/physics/cutting/node_masses.h"
#include "server/physics/cutting/tet_tables.h"

namespace prosector {

/// What splitting an edge works in, so that the next one allocates nothing.
struct EdgeScratch {
  std::vector<TetId> around;
  std::vector<std::array<double, 2>> halves;  // m³: of each the half with a, then that with b
};

/// What edits change.
struct EditedTables {
  TetTables& tables;
  NodeMasses& masses;
  EdgeScratch& scratch;
};

void apply(const SplitEdge& op, EditedTables edited);
void apply(const SlitFaces& op, EditedTables edited);
void apply(const PartNode& op, EditedTables edited);

/// Undoes an operation that is the last of those in force: the tables are then what they were, but that ids
/// stay used.
void take_back(const SplitEdge& op, EditedTables edited);
void take_back(const SlitFaces& op, EditedTables edited);
void take_back(const PartNode& op, EditedTables edited);

}  // namespace prosector
