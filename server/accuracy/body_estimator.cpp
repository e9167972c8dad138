#include "server/accuracy/body_estimator.h"

#include <algorithm>

#include "server/accuracy/error_work.h"

namespace prosector {

bool BodyEstimator::judges(const SoftDesc& desc, const TetMesh& mesh) {
  return !mesh.tets.empty() &&
         std::any_of(prosector::soft::laws().begin(), prosector::soft::laws().end(),
                     [&](const soft::LawRow& row) { return row.name == desc.configuration.model; });
}

BodyEstimator::BodyEstimator(const SoftDesc& desc, const TetMesh& mesh, const VecX& ties,
                             const std::string& tissue)
    : work_(std::make_unique<estimation::ErrorWork>(desc, mesh, ties, tissue)) {}
BodyEstimator::~BodyEstimator() = default;
BodyEstimator::BodyEstimator(BodyEstimator&&) noexcept = default;

std::size_t BodyEstimator::pieces() const {
  return work_->piece_count();
}

void BodyEstimator::begin(BodyMoment& moment) {
  std::swap(work_->moment, moment);
  work_->clear();
}

bool BodyEstimator::go_on(std::size_t pieces) {
  estimation::ErrorWork& w = *work_;
  const std::size_t end = std::min(w.done + pieces, w.piece_count());
  for (; w.done < end; ++w.done) w.piece(w.done);
  return w.done == w.piece_count();
}

const Estimate& BodyEstimator::newest() const {
  return work_->newest;
}

void BodyEstimator::keep_as_quiet() {
  work_->state.keep(work_->before.quiet);
}

const TetMesh& BodyEstimator::mesh() const {
  return work_->body.mesh;
}

}  // namespace prosector
