#include "server/physics/mechanics/soft/body_hessian.h"

#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/soft/base/node_sum.h"
#include "server/physics/mechanics/soft/base/scratch.h"

namespace prosector::soft {
namespace {

constexpr std::size_t blocks_per_chunk = 16 * NodeSum::nodes_per_chunk;
/// Ratio of inertia to stiffness above which H in single precision is as definite as in double.
constexpr double least_inertia = 1e-5;

std::vector<Mat3> rest_stiffness(const SoftSystem& system) {
  std::vector<Mat3> blocks(system.pattern.blocks());
  system.pattern.gather(system.model.warped_stiffness(system.model.rest().data()), 0, {}, blocks);
  return blocks;
}

}  // namespace

BodyHessian::BodyHessian(const SoftSystem& system, StageElements& elements)
    : system_(system), elements_(elements), rows_(system.symmetric) {
  fit();
}

void BodyHessian::fit() {
  rows_.fit(system_.symmetric);
  fit_scratch(diagonal_, system_.pattern.rows());
  if (!turns() || system_.desc.configuration.solver == "direct")
    fit_scratch(blocks_, system_.pattern.blocks());
  rest_stiffness_ = system_.model.rest_trace() / static_cast<double>(3 * nodes());
  blocks_known_ = rows_known_ = factored_ = multigrid_set_ = multigrid_turned_ = false;
  cholesky_.reset();
  multigrid_.reset();
  if (system_.desc.configuration.solver == "direct") cholesky_ = std::make_unique<Cholesky>(system_.pattern);
  if (system_.desc.configuration.solver == "multigrid") make_coarse_levels();
}

void BodyHessian::make_coarse_levels() {
  const std::vector<Mat3> stiffness = soft::rest_stiffness(system_);
  multigrid_ =
      std::make_unique<Multigrid>(RestSystem{system_.pattern, system_.model.connectivity(), stiffness,
                                             system_.model.rest(), system_.mass, system_.attached});
}

bool BodyHessian::single_will_do(const StageWeights& weights) const {
  const std::string& solver = system_.desc.configuration.solver;
  return solver != "direct" && (turns() || solver == "multigrid") &&
         weights.inertia * system_.mass.mean() > least_inertia * rest_stiffness_;
}

void BodyHessian::begin_stage(const VecX& start, const StageWeights& weights) {
  start_ = &start;
  weights_ = weights;
  single_ = single_will_do(weights);
  multigrid_turned_ = false;
  elements_.begin_stage(start, weights.scale(), single_);
}

void BodyHessian::assemble(const Eigen::Ref<const VecX>& x) {
  if (elements_.turned()) {
    elements_.assemble(x, rows_);
    take_rows();
    return;
  }
  const std::span<const Mat3> damping =
      system_.damped() ? elements_.damping_blocks(x) : std::span<const Mat3>();
  fit_scratch(blocks_, system_.pattern.blocks());
  system_.pattern.gather(system_.model.tangent(x.data()), weights_.damping_share, damping, blocks_);
  take_blocks();
}

bool BodyHessian::assemble_roughly(const Eigen::Ref<const VecX>& x) {
  if (elements_.turned() ? !elements_.near_assembled(x) : !elements_.near_start(x)) {
    assemble(x);
    return false;
  }
  if (elements_.turned())
    multigrid_set_ = false;  // contacts of the body may have changed
  else
    assemble_warped(x);
  return true;
}

/// Assembles the warped stiffness instead of the tangent; damping uses the warped stiffness anyway.
void BodyHessian::assemble_warped(const Eigen::Ref<const VecX>& x) {
  fit_scratch(blocks_, system_.pattern.blocks());
  if (system_.damped()) {
    const std::span<const Mat3> damping = elements_.damping_blocks(x);
    parallel_chunks(blocks_.size(), blocks_per_chunk, [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t k = begin; k < end; ++k) blocks_[k] = weights_.scale() * damping[k];
    });
  } else {
    system_.pattern.gather(system_.model.warped_stiffness(start_->data()), 0, {}, blocks_);
  }
  take_blocks();
}

/// Completes blocks_, which hold the couplings between nodes.
void BodyHessian::take_blocks() {
  add_diagonal([&](std::size_t i) -> const Mat3& { return blocks_[system_.pattern.diagonal(i)]; });
  for (std::size_t i = 0; i < nodes(); ++i) blocks_[system_.pattern.diagonal(i)] = diagonal_[i];
  blocks_known_ = true;
  rows_known_ = false;
  if (single_) rows_from_blocks();
}

/// Completes rows_, as take_blocks() completes blocks_.
void BodyHessian::take_rows() {
  add_diagonal([&](std::size_t i) -> Mat3 { return weights_.scale() * rows_.diagonal[i]; });
  blocks_known_ = false;
  rows_known_ = true;
}

/// Sets diagonal_ to the elements' diagonal blocks plus inertia and attachments.
template <class F>
void BodyHessian::add_diagonal(const F& of_elements) {
  parallel_short_chunks(
      nodes(), NodeSum::nodes_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
        for (std::size_t i = first; i < last; ++i) {
          const auto row = static_cast<Eigen::Index>(i);
          diagonal_[i] = of_elements(i);
          diagonal_[i].diagonal().array() +=
              weights_.inertia * system_.mass[row] + weights_.scale() * system_.attached[row];
        }
      });
  factored_ = multigrid_set_ = false;
}

void BodyHessian::blocks_from_rows() {
  if (blocks_known_) return;
  fit_scratch(blocks_, system_.pattern.blocks());
  rows_.write(system_.symmetric, system_.pattern, weights_.scale(), blocks_);
  for (std::size_t i = 0; i < nodes(); ++i) blocks_[system_.pattern.diagonal(i)] = diagonal_[i];
  blocks_known_ = true;
}

void BodyHessian::rows_from_blocks() {
  if (!rows_known_) rows_.set(system_.symmetric, system_.pattern, 1 / weights_.scale(), blocks_);
  rows_known_ = true;
}

void BodyHessian::multiply(const double* p, double* Hp) const {
  if (single_)
    soft::multiply(system_.symmetric, rows_, weights_.scale(), diagonal_, p, Hp);
  else
    system_.pattern.multiply(blocks_, p, Hp);
}

void BodyHessian::factor_solve(const double* r, double* z) {
  if (!cholesky_) cholesky_ = std::make_unique<Cholesky>(system_.pattern);
  if (!factored_) {
    blocks_from_rows();
    cholesky_->factor(blocks_);
    factored_ = true;
  }
  cholesky_->solve(r, z);
}

void BodyHessian::multigrid_solve(std::span<const Mat3> diagonal, std::span<const Mat3> inverse,
                                  const double* r, double* z) {
  if (!multigrid_) make_coarse_levels();
  if (!multigrid_turned_) {
    multigrid_->retime(weights_.inertia / weights_.scale());
    multigrid_->turn(system_.model.objective() ? start_->data() : nullptr);
    multigrid_turned_ = true;
  }
  rows_from_blocks();
  if (!multigrid_set_)
    multigrid_->set_matrix(system_.symmetric.blocks_of(rows_.right), weights_.scale(), diagonal, inverse);
  multigrid_set_ = true;
  multigrid_->apply(r, z);
}

}  // namespace prosector::soft
