#include "server/physics/world/tissue.h"

#include "common/assert.h"
#include "server/physics/mechanics/contact/flat_elements.h"

namespace prosector {

Tissue::Tissue(std::size_t own_index, std::unique_ptr<soft::SoftBody> own_solver,
               const contact::SoftCollision& how)
    : index(own_index),
      solver(std::move(own_solver)),
      collision(how),
      state(solver->initial_state()),
      equilibrium(state.motion.x),
      surface(solver->anatomy()) {}

Tissue::Tissue(std::size_t own_index, std::unique_ptr<soft::SoftBody> own_solver,
               const contact::SoftCollision& how, contact::TissueSurface own_surface)
    : index(own_index),
      solver(std::move(own_solver)),
      collision(how),
      state(solver->initial_state()),
      equilibrium(state.motion.x),
      surface(std::move(own_surface)) {}

double Tissue::contact_stiffness(std::size_t vertex) const {
  PROSECTOR_ASSERT(vertex < solver->surface_area().size());
  const soft::SoftBody& body = *solver;
  return collision.stiffness_factor * body.desc().material.youngs_modulus * body.surface_area()[vertex] /
         body.desc().geometry.surface_cell;
}

contact::ContactSide Tissue::side(std::uint32_t vertex) const {
  PROSECTOR_ASSERT(vertex < anatomy().embedding.rows.size());
  contact::ContactSide out;
  out.kind = contact::ContactSide::Kind::soft;
  out.body = index;
  out.add(anatomy().embedding.rows[vertex], 1);
  return out;
}

Vec3 Tissue::middle() const {
  PROSECTOR_ASSERT(state.motion.x.size() == 3 * solver->nodes());
  const VecX& mass = solver->node_mass();
  return state.motion.x.reshaped(3, mass.size()) * mass / mass.sum();
}

double Tissue::reach(double h) const {
  PROSECTOR_ASSERT(h > 0);
  return h * state.motion.v.lpNorm<Eigen::Infinity>();
}

double Tissue::inner_reach(double h) const {
  PROSECTOR_ASSERT(h > 0 && state.motion.v.size() == 3 * solver->nodes());
  const auto v = state.motion.v.reshaped(3, solver->nodes());
  const Vec3 mean = v.rowwise().mean();
  return 2 * h * (v.colwise() - mean).cwiseAbs().maxCoeff();
}

collision::Aabb Tissue::outer_box() const {
  if (surface.proxy()) return surface.proxy()->box();
  return collision::Aabb{surface.vertices().lo(), surface.vertices().hi()}.grown(half_thickness());
}

contact::SoftSkin Tissue::skin() {
  const collision::TriangleSurface* faces = surface.moved_faces();
  return {&surface.vertices(), faces, half_thickness(), desc().geometry.surface_cell};
}

const std::vector<char>& Tissue::inside_out() {
  PROSECTOR_ASSERT(fits_its_mesh());
  if (knows_inside_out_) return inside_out_;
  knows_inside_out_ = true;
  inside_out_.clear();
  std::vector<char> nodes;
  if (!contact::mark_inverted(solver->linear_tets(), state.motion.x, nodes)) return inside_out_;
  for (const SparseMap::Row& row : anatomy().embedding.rows) {
    double share = 0;
    for (std::size_t k = 0; k < row.node.size(); ++k) share += nodes[row.node[k]] ? row.weight[k] : 0;
    inside_out_.push_back(share > 0.5);
  }
  return inside_out_;
}

/// Returns whether state and surface match the solver's mesh in size.
bool Tissue::fits_its_mesh() const {
  const Eigen::Index size = 3 * solver->nodes();
  return state.motion.x.size() == size && state.motion.v.size() == size && equilibrium.size() == size &&
         anatomy().embedding.rows.size() == anatomy().surface.positions.size();
}

void Tissue::begin_tick() {
  PROSECTOR_ASSERT(fits_its_mesh());
  surface.begin_tick();
  knows_inside_out_ = false;
}

void Tissue::follow_nodes() {
  place_surface();
  begin_tick();
}

void Tissue::wake() {
  state.asleep = false;
  state.quiet_ticks = 0;
}

void Tissue::freeze() {
  PROSECTOR_ASSERT(fits_its_mesh());
  state.asleep = true;
  stop(state);
}

void stop(soft::SoftBodyState& state) {
  state.motion.v.setZero();
  state.warm_start.setZero();
  state.motion.has_history = false;
}

}  // namespace prosector
