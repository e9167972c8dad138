#include "server/physics/mechanics/soft/elements/relaxation.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "server/physics/mechanics/soft/elements/corotational_kernel.h"
#include "server/physics/mechanics/soft/laws/symmetric_eigen.h"

namespace prosector::soft {
namespace {

/// Smallest volume ratio at which S is computed. F⁻¹ of flatter elements is too large: their S counts as 0,
/// while their history stresses relax further.
constexpr double least_volume = 0.05;
/// Relative to c·μ: upper bound of the outward pull of H. Then c·W, which grows at least as μ/3·|F|²,
/// balances H.
constexpr double most_outward = 0.5;

Mat3 unpack(const double* h) {
  Mat3 A;
  A << h[0], h[1], h[2], h[1], h[3], h[4], h[2], h[4], h[5];
  return A;
}
void pack(const Mat3& A, double* h) {
  h[0] = A(0, 0), h[1] = A(0, 1), h[2] = A(0, 2), h[3] = A(1, 1), h[4] = A(1, 2), h[5] = A(2, 2);
}

/// Returns A with its eigenvalues raised to `least`.
Mat3 raised(const Mat3& A, double least) {
  const SymmetricEigen eigen = symmetric_eigen(A);
  if (!(eigen.values.minCoeff() < least)) return A;
  return eigen.vectors * eigen.values.cwiseMax(least).asDiagonal() * eigen.vectors.transpose();
}

}  // namespace

RelaxingBatches::RelaxingBatches(std::unique_ptr<ElementBatches> law, std::vector<RelaxationDesc> terms,
                                 const Materials& materials, const Tet4Elements& elements)
    : ElementBatches(materials, elements),
      law_(std::move(law)),
      terms_(std::move(terms)),
      keep_(terms_.size(), 1),
      gain_(terms_.size(), 0),
      held_(elements.size(), Mat3::Zero()),
      start_(elements.size(), Mat3::Zero()) {}

void RelaxingBatches::follow(const SoftMaterial& material, const TetMesh& mesh, const MeshEdit& edit) {
  ElementBatches::follow(material, mesh, edit);
  law_->follow(material, mesh, edit);
  std::fill(keep_.begin(), keep_.end(), 1);
  std::fill(gain_.begin(), gain_.end(), 0);
  share_ = 1;
  held_.assign(elements_.size(), Mat3::Zero());
  start_.assign(elements_.size(), Mat3::Zero());
}

void RelaxingBatches::set_step(double h) {
  share_ = 1;
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    const double z = h / terms_[i].time;
    keep_[i] = std::exp(-z);
    gain_[i] = terms_[i].share * (std::isfinite(z) ? -std::expm1(-z) / z : 0);
    share_ += gain_[i] - terms_[i].share;
  }
}

void RelaxingBatches::relax_fully() {
  set_step(std::numeric_limits<double>::infinity());
  std::fill(held_.begin(), held_.end(), Mat3::Zero());
}

Mat3 RelaxingBatches::gradient(std::size_t batch, std::size_t lane) const {
  Mat3 F;
  for (std::size_t k = 0; k < 9; ++k) F.data()[k] = strain_[batch].F.at[k][lane];
  return F;
}

void RelaxingBatches::second_piola(std::size_t batch, std::span<Mat3> S) const {
  std::array<Tet4Elements::Forces, elements_per_batch> f;
  law_->forces(batch, std::span(f.data(), S.size()));
  for (std::size_t lane = 0; lane < S.size(); ++lane) {
    const std::size_t e = first(batch) + lane;
    Mat3 VPB;
    VPB << f[lane][1], f[lane][2], f[lane][3];
    const Mat3 P = VPB * elements_.gradients(e).inverse() / elements_.volume(e), F = gradient(batch, lane);
    if (!objective())
      S[lane] = P;
    else if (F.determinant() > least_volume)
      S[lane] = F.inverse() * P;
    else
      S[lane].setZero();
    S[lane] = (0.5 * (S[lane] + S[lane].transpose())).eval();
  }
}

void RelaxingBatches::begin_step(std::size_t batch, const double* history) {
  const std::span<Mat3> S = std::span(start_).subspan(first(batch), count(batch));
  second_piola(batch, S);
  for (std::size_t lane = 0; lane < S.size(); ++lane) {
    const std::size_t e = first(batch) + lane;
    Mat3 H = Mat3::Zero();
    for (std::size_t i = 0; i < terms_.size(); ++i)
      H += keep_[i] * unpack(history + history_per_element() * e + 6 * i) - gain_[i] * S[lane];
    held_[e] = objective() ? raised(H, -most_outward * share_ * materials_.of(e).lame.mu) : H;
  }
}

void RelaxingBatches::end_step(std::size_t batch, double* history) const {
  std::array<Mat3, elements_per_batch> S;
  second_piola(batch, std::span(S.data(), count(batch)));
  for (std::size_t lane = 0; lane < count(batch); ++lane) {
    const std::size_t e = first(batch) + lane;
    for (std::size_t i = 0; i < terms_.size(); ++i) {
      double* h = history + history_per_element() * e + 6 * i;
      pack(keep_[i] * unpack(h) + gain_[i] * (S[lane] - start_[e]), h);
    }
  }
}

void RelaxingBatches::move(std::size_t batch, const double* x) {
  deform(batch, x);
  law_->move(batch, x);
}

double RelaxingBatches::energy(std::size_t batch) const {
  double sum = share_ * law_->energy(batch);
  for (std::size_t lane = 0; lane < count(batch); ++lane) {
    const std::size_t e = first(batch) + lane;
    const Mat3 F = gradient(batch, lane);
    const Mat3 strain =
        objective() ? Mat3(0.5 * (F.transpose() * F - Mat3::Identity())) : Mat3(F - Mat3::Identity());
    sum += elements_.volume(e) * held_[e].cwiseProduct(strain).sum();
  }
  return sum;
}

void RelaxingBatches::forces(std::size_t batch, std::span<Tet4Elements::Forces> f) const {
  law_->forces(batch, f);
  for (std::size_t lane = 0; lane < f.size(); ++lane) {
    const std::size_t e = first(batch) + lane;
    Tet4Elements::Forces own;
    elements_.forces(e, objective() ? Mat3(gradient(batch, lane) * held_[e]) : held_[e], own);
    for (std::size_t a = 0; a < own.size(); ++a) f[lane][a] = share_ * f[lane][a] + own[a];
  }
}

void RelaxingBatches::stiffness(std::size_t batch, std::span<Tet4Elements::Stiffness> K) const {
  law_->stiffness(batch, K);
  for (std::size_t lane = 0; lane < K.size(); ++lane) {
    const std::size_t e = first(batch) + lane;
    for (Mat3& block : K[lane]) block *= share_;
    if (!objective()) continue;
    // V·b_aᵀ H b_b on the diagonal. The outward part of H is left out, because the law's own projection may
    // have removed the terms that would balance it.
    const Mat3 VH = elements_.volume(e) * raised(held_[e], 0);
    Eigen::Matrix<double, 3, 4> B;
    B.rightCols<3>() = elements_.gradients(e);
    B.col(0) = -B.rightCols<3>().rowwise().sum();
    const Eigen::Matrix4d BHB = B.transpose() * VH * B;
    for (int a = 0; a < 4; ++a)
      for (int b = a + 1; b < 4; ++b)
        K[lane][static_cast<std::size_t>(Tet4Elements::pair_index(a, b))].diagonal().array() += BHB(a, b);
  }
}

std::unique_ptr<ElementBatches> make_relaxing_batches(const std::string& law, const Materials& materials,
                                                      const std::vector<RelaxationDesc>& terms,
                                                      const Tet4Elements& elements) {
  auto batches = make_batches(law, materials, elements);
  if (terms.empty()) return batches;
  return std::make_unique<RelaxingBatches>(std::move(batches), terms, materials, elements);
}

bool has_relaxed(const SoftMaterial& material, const VecX& history) {
  constexpr double least_strain = 1e-3;
  return history.size() == 0 || history.lpNorm<Eigen::Infinity>() <= least_strain * material.youngs_modulus;
}

}  // namespace prosector::soft
