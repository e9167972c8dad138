#include "server/physics/mechanics/soft/elements/batched_model.h"

#include <cstring>
#include <utility>

#include "server/physics/mechanics/soft/base/node_vectors.h"

namespace prosector::soft {

BatchedModel::BatchedModel(const TetMesh& mesh, Connectivity connectivity,
                           std::unique_ptr<ElementBatches> batches, std::size_t elements_per_chunk)
    : rest_(to_vector(mesh.positions)),
      connectivity_(std::move(connectivity)),
      incidence_(connectivity_),
      batches_(std::move(batches)),
      relaxing_(dynamic_cast<RelaxingBatches*>(batches_.get())),
      elements_per_chunk_(elements_per_chunk),
      sums_(chunk_count(connectivity_.size(), elements_per_chunk)),
      moved_to_(VecX::Zero(rest_.size())) {}

void BatchedModel::follow_elements(const SoftMaterial& material, const TetMesh& mesh, const MeshEdit& edit) {
  rest_ = to_vector(mesh.positions);
  connectivity_.follow(edit);
  incidence_.follow(connectivity_, edit);
  batches_->follow(material, mesh, edit);
  sums_.resize(chunk_count(connectivity_.size(), elements_per_chunk_));
  moved_to_.setZero(rest_.size());
  moved_ = energy_known_ = forces_known_ = false;
}

/// Returns whether the elements are at x already, and records x. Newton's method evaluates energy, gradient
/// and Hessian at the same positions, and the next step starts where the last one ended. If false, the caller
/// must move the elements to x.
bool BatchedModel::take(const double* x) {
  const auto bytes = static_cast<std::size_t>(moved_to_.size()) * sizeof(double);
  if (moved_ && std::memcmp(x, moved_to_.data(), bytes) == 0) return true;
  std::memcpy(moved_to_.data(), x, bytes);
  moved_ = true;
  energy_known_ = forces_known_ = false;
  return false;
}

/// Moves the elements to x. Also computes the energy, which nearly all callers need.
void BatchedModel::move(const double* x) {
  if (take(x)) return;
  for_chunks([&](const ElementChunk& chunk) {
    place(chunk, x);
    sums_[chunk.batch] = energy_of(chunk);
  });
  energy_known_ = true;
}

double BatchedModel::energy(const double* x) {
  move(x);
  if (!energy_known_) for_chunks([&](const ElementChunk& chunk) { sums_[chunk.batch] = energy_of(chunk); });
  energy_known_ = true;
  return ordered_sum(sums_);
}

void BatchedModel::add_gradient(const double* x, double* g) {
  move(x);
  if (!forces_known_) for_chunks([&](const ElementChunk& chunk) { find_forces(chunk); });
  forces_known_ = true;
  incidence_.add(forces(), g);
}

std::span<const Mat3> BatchedModel::tangent(const double* x) {
  move(x);
  reserve_stiffness();
  for_chunks([&](const ElementChunk& chunk) { find_stiffness(chunk, false); });
  return stiffness();
}

std::span<const Mat3> BatchedModel::warped_stiffness(const double* x) {
  move(x);
  reserve_stiffness();
  for_chunks([&](const ElementChunk& chunk) { find_stiffness(chunk, true); });
  return stiffness();
}

void BatchedModel::linearise(const double* x, double share, CorotatedElements& out) {
  reserve(out);
  const bool there = take(x);
  for_chunks([&](const ElementChunk& chunk) {
    if (!there) place(chunk, x);
    if (!energy_known_) sums_[chunk.batch] = energy_of(chunk);
    if (!forces_known_) find_forces(chunk);
    turn(chunk, share, out);
  });
  energy_known_ = forces_known_ = true;
}

void BatchedModel::begin_step(double h, const double* x, const double* history) {
  if (!relaxing_) return;
  move(x);
  relaxing_->set_step(h);
  for_chunks([&](const ElementChunk& chunk) { relaxing_->begin_step(chunk.batch, history); });
  energy_known_ = forces_known_ = false;
}

void BatchedModel::end_step(const double* x, double* history) {
  if (!relaxing_) return;
  move(x);
  for_chunks([&](const ElementChunk& chunk) { relaxing_->end_step(chunk.batch, history); });
}

void BatchedModel::relax_fully() {
  if (!relaxing_) return;
  relaxing_->relax_fully();
  energy_known_ = forces_known_ = false;
}

}  // namespace prosector::soft
