#pragma once
// Elementary topology changes of a complex, each with its inverse. For an invalid operation, an edit throws
// InputError and changes nothing.

#include <array>
#include <vector>

#include "server/physics/mechanics/cutting/node_masses.h"
#include "server/physics/mechanics/cutting/tet_tables.h"

namespace prosector::cutting {

/// Scratch memory of edge splits: the tetrahedra around the edge, and the volumes of their halves. It is
/// reused to avoid allocations.
struct EdgeScratch {
  std::vector<TetId> around;
  std::vector<std::array<double, 2>> halves;  // m³, per tetrahedron: the half with a, the half with b
};

/// References to the data that topology changes modify: the mesh tables, the node masses, and scratch memory.
struct EditedTables {
  TetTables& tables;
  NodeMasses& masses;
  EdgeScratch& scratch;
};

void apply(const SplitEdge& op, EditedTables edited);
void apply(const SlitFaces& op, EditedTables edited);
void apply(const PartNode& op, EditedTables edited);

/// Undoes a topology change, which must be the last one that was not undone. The tables get their previous
/// values, except that ids stay used. Throws InputError, and changes nothing, if the change does not match
/// the tables.
void take_back(const SplitEdge& op, EditedTables edited);
void take_back(const SlitFaces& op, EditedTables edited);
void take_back(const PartNode& op, EditedTables edited);

}  // namespace prosector::cutting
