#include "server/physics/mechanics/soft/elements/element_batches.h"

#include <algorithm>

#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/soft/base/node_vectors.h"
#include "server/physics/mechanics/soft/elements/corotational_kernel.h"

namespace prosector::soft {
namespace {

constexpr std::size_t batches_per_chunk = 16;

void set_lane(LaneMatrix& m, std::size_t lane, const Mat3& A) {
  for (std::size_t k = 0; k < 9; ++k) m.at[k][lane] = A.data()[k];
}

}  // namespace

ElementBatches::ElementBatches(const Materials& materials, const Tet4Elements& elements)
    : materials_(materials),
      elements_(elements),
      rest_(chunk_count(elements.size(), elements_per_batch)),
      strain_(rest_.size()),
      trace_(rest_.size()) {
  parallel_chunks(rest_.size(), batches_per_chunk, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t batch = begin; batch < end; ++batch) set_rest(batch);
  });
}

void ElementBatches::set_rest(std::size_t batch) {
  for (std::size_t lane = 0; lane < elements_per_batch; ++lane) {
    const bool used = lane < count(batch);
    const std::size_t e = first(batch) + lane;
    set_lane(rest_[batch].gradients, lane, used ? elements_.gradients(e) : Mat3::Identity());
    rest_[batch].volume[lane] = used ? elements_.volume(e) : 0;
    const Lame& lame = used ? materials_.of(e).lame : materials_.kinds.front().lame;
    rest_[batch].lambda[lane] = lame.lambda;
    rest_[batch].mu[lane] = lame.mu;
  }
  set_trace(batch);
}

// tr K_aa = V(λ + 4μ)|b_a|²; fibres along f add V·k(b_a·f)².
void ElementBatches::set_trace(std::size_t batch) {
  const LaneRest& rest = rest_[batch];
  double sum = 0;
  for (std::size_t lane = 0; lane < elements_per_batch; ++lane) {
    double squares = 0, own[3] = {0, 0, 0};
    for (std::size_t k = 0; k < 9; ++k) {
      const double entry = rest.gradients.at[k][lane];
      squares += entry * entry;
      own[k % 3] += entry;
    }
    squares += own[0] * own[0] + own[1] * own[1] + own[2] * own[2];
    sum += rest.volume[lane] * (rest.lambda[lane] + 4 * rest.mu[lane]) * squares;
  }
  for (std::size_t e = first(batch); e < first(batch) + count(batch); ++e)
    if (const Material& material = materials_.of(e); material.fiber_stiffness > 0) {
      const Vec3 along = elements_.gradients(e).transpose() * material.fiber;
      const double squares = along.squaredNorm() + along.sum() * along.sum();
      sum += elements_.volume(e) * material.fiber_stiffness * squares;
    }
  trace_[batch] = sum;
}

double ElementBatches::rest_trace() const {
  return ordered_sum(trace_);
}

void ElementBatches::follow(const SoftMaterial& material, const TetMesh& mesh, const MeshEdit& edit) {
  const std::size_t each = elements_.size() / edit.kept_tets.now;
  materials_.follow(material, mesh, edit, each);
  rest_.resize(chunk_count(elements_.size(), elements_per_batch));
  strain_.resize(rest_.size());
  trace_.resize(rest_.size());
  // Lanes of this and later batches hold other elements than before, or none.
  const std::size_t moved = each * edit.kept_tets.unmoved() / elements_per_batch;
  std::vector<std::size_t> others;
  for (const std::size_t tet : edit.tets)  // all points of a tetrahedron are in one batch
    if (const std::size_t batch = each * tet / elements_per_batch;
        batch < moved && (others.empty() || batch != others.back()))
      others.push_back(batch);
  for (const std::size_t batch : others) set_rest(batch);
  const std::size_t count = rest_.size() - std::min(moved, rest_.size());
  parallel_chunks(count, batches_per_chunk, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t batch = begin; batch < end; ++batch) set_rest(moved + batch);
  });
}

void ElementBatches::set_pressures(std::size_t batch, std::span<const double> pressure) {
  std::copy(pressure.begin(), pressure.end(), strain_[batch].pressure);
}

std::size_t ElementBatches::count(std::size_t batch) const {
  return std::min(elements_per_batch, elements_.size() - first(batch));
}

void ElementBatches::deform(std::size_t batch, const double* x) {
  LaneMatrix edges;
  for (std::size_t lane = 0; lane < elements_per_batch; ++lane) {
    const bool used = lane < count(batch);
    set_lane(edges, lane, used ? elements_.edges(first(batch) + lane, x) : Mat3::Identity());
  }
  lane_gradients(rest_[batch], edges, strain_[batch].F);
}

}  // namespace prosector::soft
