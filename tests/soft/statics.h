#pragma once
// Equilibria of small strain and large, with prescribed components of displacement and tractions: what
// closed forms of elasticity are compared with.

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "server/physics/mechanics/soft/elements/elastic_model.h"

namespace prosector {

/// x_i of component c of the node at rest position p, if it is prescribed.
using Prescribed = std::function<std::optional<double>(const Vec3& p, int c)>;
/// N/m² at p of the surface whose outward normal is n.
using Traction = std::function<Vec3(const Vec3& p, const Vec3& n)>;

struct Specimen {
  std::string element;
  std::unique_ptr<soft::ElasticModel> model;
  TetMesh mesh;  // with its elements' nodes
};

Specimen make_specimen(const std::string& model, const std::string& element, double E, double nu,
                       TetMesh mesh);

/// Index of the node at p, to within a hair of the mesh's size; fails the test if there is none.
Eigen::Index node_at(const TetMesh& mesh, const Vec3& p);

/// Work-equivalent forces of a traction on the whole surface, 3n; exact where it is a quadratic polynomial.
VecX forces_of(const Specimen& specimen, const Traction& traction);

/// Minimises W(x) − load·x by Newton from rest.
VecX equilibrium(soft::ElasticModel& model, const Prescribed& prescribed, const VecX& load);

/// The same where nothing is prescribed: the load must be in balance, and six components of three nodes,
/// which then carry nothing, keep the body in place.
VecX free_equilibrium(const Specimen& specimen, const VecX& load);

/// Hz: the lowest frequency at rest with lumped mass (kg/m³) and held components, by inverse iteration from
/// `mode`.
double lowest_frequency(soft::ElasticModel& model, double density,
                        const std::function<bool(const Vec3& p, int c)>& held, VecX mode);

}  // namespace prosector
