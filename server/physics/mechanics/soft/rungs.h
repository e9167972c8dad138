#pragma once
// Tables of model configurations (rungs): the models, the meshes they support, and the integrators they can
// use. Checks, tests and measurements of rungs use these tables.

#include <string>
#include <vector>

#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector::soft {

enum class MeshKind { tets, sheet, rope };
MeshKind mesh_kind(const Anatomy& anatomy);

/// Row of the table of soft-body models: a value of `model` in a scene file, its help text, the kinds of mesh
/// that it supports, and whether it is position-based.
struct ModelRow {
  std::string name;
  std::string help;
  bool tets, fabric;    // supported meshes; fabric: sheets and ropes
  bool position_based;  // has its own integration, which approximates implicit Euler
};
/// Returns the table of all soft-body models: mass_spring, xpbd, and each material law for tetrahedra.
const std::vector<ModelRow>& models();

/// Returns the values of `integrator` in a scene file that are allowed with this soft-body model. These are
/// all implicit and explicit integrators. For a position-based model it is only `implicit_euler`, which the
/// model approximates.
std::vector<std::string> integrators_for(const ModelRow& model);

/// Returns a text that describes the body's configuration: model, element, integrator, solver and solver
/// effort per step, or the number of substeps.
std::string in_words(const SoftDesc& desc);

/// Checks that model, element, mesh, integrator and stress relaxation of the description are compatible.
/// Throws InputError that names the allowed values if they are not.
void check_rung(const SoftDesc& desc, const Anatomy& anatomy);

}  // namespace prosector::soft
