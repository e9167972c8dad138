#pragma once
// The ladder: which models there are, on which meshes, and which integrators go with them. Stated once; what
// checks, tests and measures rungs goes by these tables.

#include <string>
#include <vector>

#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector {

enum class MeshKind { tets, sheet, rope };
MeshKind mesh_kind(const Anatomy& anatomy);

/// `model` in a scene file.
struct ModelRow {
  std::string name;
  std::string help;
  bool tets, fabric;    // meshes that it makes sense on; fabric: sheets and ropes
  bool position_based;  // integrates by itself, as implicit Euler would
};
/// Returns the rows of all models: every law on tetrahedra, mass_spring and xpbd.
const std::vector<ModelRow>& models();

/// Returns the values of `integrator` in a scene file that go with the model. These are all of integrators()
/// and explicit_integrators(), or for a position-based model the one that it approximates.
std::vector<std::string> integrators_for(const ModelRow& model);

/// Returns the description's rung for people: model, element, integrator, solver and how much is spent on a
/// step.
std::string in_words(const SoftDesc& desc);

/// Throws InputError that names what is allowed unless the description's model, mesh and integrator go
/// together.
void check_rung(const SoftDesc& desc, const Anatomy& anatomy);

}  // namespace prosector
