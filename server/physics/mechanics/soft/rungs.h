#pragma once
// Tables of model configurations (rungs): the models, the meshes they support, and the integrators they can
// use. Checks, tests and measurements of rungs use these tables.

#include <string>
#include <vector>

#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector {

enum class MeshKind { tets, sheet, rope };
MeshKind mesh_kind(const Anatomy& anatomy);

/// A value of `model` in a scene file.
struct ModelRow {
  std::string name;
  std::string help;
  bool tets, fabric;    // supported meshes; fabric: sheets and ropes
  bool position_based;  // has its own integration, which approximates implicit Euler
};
/// Returns the rows of all models: each material law on tetrahedra, mass_spring and xpbd.
const std::vector<ModelRow>& models();

/// Returns the values of `integrator` in a scene file that the model supports. These are all of integrators()
/// and explicit_integrators(); for a position-based model, only the integrator that it approximates.
std::vector<std::string> integrators_for(const ModelRow& model);

/// Returns a text that describes the configuration: model, element, integrator, solver and effort per step.
std::string in_words(const SoftDesc& desc);

/// Throws InputError that names the allowed values if model, mesh and integrator of the description are not
/// compatible.
void check_rung(const SoftDesc& desc, const Anatomy& anatomy);

}  // namespace prosector
