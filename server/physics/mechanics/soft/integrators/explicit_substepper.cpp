// Explicit integration of a body's forces in substeps below the limit of its highest frequency.

#include <cmath>
#include <limits>

#include "server/physics/mechanics/soft/base/find_row.h"
#include "server/physics/mechanics/soft/base/scratch.h"
#include "server/physics/mechanics/soft/integrators/explicit_integrators.h"
#include "server/physics/mechanics/soft/integrators/substepper.h"

namespace prosector::soft {
namespace {

constexpr double safety = 0.9;  // relative to the stability limit, because the power method underestimates ω
// 1/s: allowed energy growth rate for methods that are stable only with damping.
constexpr double growth = 0.06;
constexpr int first_iterations = 60;  // of the power method, from an arbitrary start vector
// Ratio of ω to ω at rest above which stiffness-proportional damping is ignored: it does not damp stress
// stiffening.
constexpr double most_stiffening = 1.2;
constexpr int tick_iterations = 4;  // of the power method, from the last tick's vector

/// a = M⁻¹·(−∂W/∂x − k(x − x₀ + βv) − βK(x_n)·v) − α·v + g, with Rayleigh damping as in soft_body.h.
class BodyField final : public AccelerationField {
 public:
  explicit BodyField(const SubstepBody& body) : body_(body) { fit(); }

  void fit() {
    gradient_.resize(body_.model.rest().size());
    damping_.resize(gradient_.size());
    if (body_.desc.material.damping_stiffness > 0) fit_scratch(stiffness_, body_.pattern.blocks());
  }
  void begin(const double* x) {
    if (!stiffness_.empty()) body_.pattern.gather(body_.model.warped_stiffness(x), 0, {}, stiffness_);
  }
  void set_weight(const Weight& weight) { weight_ = weight; }

  void at(const VecX& x, const VecX& v, VecX& a) override {
    const double alpha = body_.desc.material.damping_mass, beta = body_.desc.material.damping_stiffness;
    const VecX& rest = body_.model.rest();
    a.resize(x.size());
    gradient_.setZero();
    body_.model.add_gradient(x.data(), gradient_.data());
    if (!stiffness_.empty()) {
      body_.pattern.multiply(stiffness_, v.data(), damping_.data());
      gradient_ += beta * damping_;
    }
    for (Eigen::Index i = 0; i < body_.mass.size(); ++i) {
      Vec3 g = gradient_.segment<3>(3 * i);
      if (body_.attached[i] > 0)
        g += body_.attached[i] * (x.segment<3>(3 * i) - rest.segment<3>(3 * i) + beta * v.segment<3>(3 * i));
      a.segment<3>(3 * i) = weight_.at(i) - alpha * v.segment<3>(3 * i) - g / body_.mass[i];
    }
  }
  bool damped() const override {
    return body_.desc.material.damping_mass > 0 || body_.desc.material.damping_stiffness > 0;
  }

 private:
  const SubstepBody body_;
  std::vector<Mat3> stiffness_;  // K(x_n), used if damped
  VecX gradient_, damping_;
  Weight weight_;
};

class ExplicitSubstepper final : public Substepper {
 public:
  explicit ExplicitSubstepper(const SubstepBody& body)
      : body_(body),
        sounded_(find_row(explicit_integrators(), "integrator", body.desc.configuration.integrator).make()),
        limit_(*sounded_),
        needs_damping_(limit_.at(1) == 0),
        field_(body) {
    fit();
  }

  /// Updates the substepper for the present body. The power method starts from the same arbitrary vector each
  /// time: starting from the previous mode, the result would depend on the cuts in between.
  void fit() override {
    method_ = find_row(explicit_integrators(), "integrator", body_.desc.configuration.integrator).make();
    field_.fit();
    fit_scratch(stiffness_, body_.pattern.blocks());
    scale_.resize(body_.model.rest().size());
    product_.resize(scale_.size());
    for (Eigen::Index i = 0; i < body_.mass.size(); ++i)
      scale_.segment<3>(3 * i).setConstant(1 / std::sqrt(body_.mass[i]));
    mode_ = VecX::NullaryExpr(scale_.size(), [](Eigen::Index i) {
      const auto k = static_cast<double>(i);
      return std::cos(2.7 * k * k + 0.3);  // contains a part of every shape, the same each time
    });
    mode_.normalize();
    omega_ = frequency(body_.model.rest().data(), first_iterations, mode_);
  }

  void initialise(SoftBodyState& state) override {
    state.mode = mode_;
    state.omega = omega_;
  }
  double needed(double h, const SoftBodyState& state) const override {
    const double limit = limit_at(state.omega);
    return limit > 0 ? std::ceil(h / (safety * limit)) : std::numeric_limits<double>::infinity();
  }
  int allowed() const override { return body_.desc.configuration.max_substeps; }
  double most_gain(double h) const override { return needs_damping_ ? 1 + growth * h : 2; }
  double most_pushed(double h) const override {
    return needs_damping_ ? growth * h : 2;  // work of the push, and strain energy from it
  }
  void begin(const SoftBodyState& state) override { field_.begin(state.motion.x.data()); }
  void step(double hs, const Weight& weight, SoftBodyState& state) override {
    field_.set_weight(weight);
    method_->step(field_, hs, state.motion.x, state.motion.v);
  }
  bool finish(double hs, SoftBodyState& state) override {
    if (!state.motion.x.allFinite()) return false;
    state.omega = std::max(omega_, frequency(state.motion.x.data(), tick_iterations, state.mode));
    return hs <= limit_at(state.omega);
  }

 private:
  /// Returns the square root of the largest eigenvalue of M⁻¹K at x, by the power method on M^−½KM^−½, and
  /// improves `mode`. K is the projected tangent plus attachments, without terms that lower frequencies.
  double frequency(const double* x, int iterations, VecX& mode) {
    body_.pattern.gather(body_.model.tangent(x), 0, {}, stiffness_);
    double lambda = 0;
    for (int k = 0; k < iterations; ++k) {
      mode.array() *= scale_.array();
      body_.pattern.multiply(stiffness_, mode.data(), product_.data());
      for (Eigen::Index i = 0; i < body_.mass.size(); ++i)
        product_.segment<3>(3 * i) += body_.attached[i] * mode.segment<3>(3 * i);
      mode = product_.cwiseProduct(scale_);
      lambda = mode.norm();
      if (!(lambda > 0) || !std::isfinite(lambda)) {
        mode = mode_;
        return lambda > 0 ? std::numeric_limits<double>::infinity() : 0;
      }
      mode /= lambda;
    }
    return std::sqrt(lambda);
  }

  double limit_at(double omega) const {
    if (!std::isfinite(omega)) return 0;
    if (!(omega > 0)) return std::numeric_limits<double>::infinity();
    const bool stiffened = omega > most_stiffening * omega_;
    return limit_.at(omega, body_.desc.material.damping_mass,
                     stiffened && needs_damping_ ? 0 : body_.desc.material.damping_stiffness);
  }

  const SubstepBody body_;
  std::unique_ptr<ExplicitIntegrator> method_, sounded_;  // for steps; for the computation of the limit
  mutable StepLimit limit_;                               // has its own buffers, in sounded_
  bool needs_damping_;                                    // whether the method is stable only with damping
  BodyField field_;
  std::vector<Mat3> stiffness_;
  VecX scale_, product_;  // 3n: M^−½; scratch
  VecX mode_;             // in the rest shape
  double omega_ = 0;      // 1/s, in the rest shape
};

}  // namespace

std::unique_ptr<Substepper> make_explicit_substepper(const SubstepBody& body) {
  return std::make_unique<ExplicitSubstepper>(body);
}

std::unique_ptr<Substepper> make_substepper(const SubstepBody& body, const Anatomy& anatomy) {
  if (body.desc.configuration.is_position_based()) return make_xpbd_substepper(body, anatomy);
  for (const ExplicitRow& row : explicit_integrators())
    if (body.desc.configuration.integrator == row.name) return make_explicit_substepper(body);
  return nullptr;
}

}  // namespace prosector::soft
