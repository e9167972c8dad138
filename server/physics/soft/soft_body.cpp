#include "server/physics/soft/soft_body.h"
#include "server/physics/soft/make_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "common/error.h"
#include "common/hash.h"
#include "server/physics/parallel.h"
#include "server/physics/soft/rungs.h"
#include "server/physics/soft/soft_body_impl.h"
#include "server/physics/soft/soft_body_setup.h"

namespace prosector {
namespace {

template <class T>
auto named(const SoftDesc& desc, const T& make) {
  try {
    return make();
  } catch (const InputError& error) {
    throw InputError(fmt::format("soft body \"{}\": {}", desc.name, error.what()));
  }
}

/// With the nodes that its elements need.
Anatomy nodes_for(const SoftDesc& desc, Anatomy anatomy, std::optional<QuadraticNodes>& quadratic) {
  if (desc.element != "tet10") return anatomy;
  SparseMap linear = anatomy.embedding;
  EdgeNodes edges = add_edge_nodes(anatomy);
  TetMesh eighths = divided(anatomy.tets, edges);
  quadratic = QuadraticNodes{std::move(edges), std::move(linear), std::move(eighths)};
  return anatomy;
}

std::unique_ptr<ElasticModel> usable_model(const SoftDesc& desc, const Anatomy& anatomy) {
  auto model = named(desc, [&] { return make_elastic_model(desc, anatomy); });
  require(model->connectivity().size() > 0, desc,
          fmt::format("all {} elements are flat or of no length; at least one must not be",
                      model->dropped_elements()));
  return model;
}

}  // namespace

SoftBody::Impl::Impl(const SoftDesc& d, Anatomy a)
    : desc((check_constants(d), d)),
      anatomy((check_mesh(d, a), nodes_for(d, std::move(a), quadratic))),
      model(usable_model(d, anatomy)),
      pattern(model->connectivity()),
      symmetric(pattern),
      mass(lumped_mass(d.density, model->volume())),
      ties(prosector::attachment_stiffness(d.attach, model->rest(), model->volume())),
      inertia(mass),
      attached(ties),
      area(vertex_areas(anatomy)),
      diagonal(bounding_diagonal(model->rest())),
      system{desc, *model, pattern, symmetric, inertia, attached},
      elements(system, !model->turns() || desc.solver == "direct"),
      damping(system, elements),
      node_sum(node_count()) {
  named(d, [&] { return make_solver(d.solver); });  // used by whoever solves, refused here
  build_on_inertia();
  euler = make_integrator("implicit_euler");
  integrator = make_integrator(substepper ? "implicit_euler" : d.integrator);
  start_anew();
}

void SoftBody::Impl::start_anew() {
  stepping = integrator.get();
  relaxed = false;
  history = {};
  for (VecX* v : {&x_n, &stage.y, &stage.x_v, &stage.v_h, &remembered.x, &remembered.v})
    v->setZero(rest().size());
}

void SoftBody::Impl::weigh() {
  inertia = mass / strength;
  attached = (tied ? 1 / strength : 0) * ties;
}

void SoftBody::Impl::build_on_inertia() {
  hessian.emplace(system, elements);
  substepper = named(desc, [&] {
    return make_substepper({desc, *model, pattern, inertia, attached}, anatomy);
  });
}

SoftBody::SoftBody(const SoftDesc& desc, Anatomy anatomy)
    : impl_(std::make_unique<Impl>(desc, std::move(anatomy))) {}
SoftBody::~SoftBody() = default;
SoftBody::SoftBody(SoftBody&&) noexcept = default;

const SoftDesc& SoftBody::desc() const {
  return impl_->desc;
}
const Anatomy& SoftBody::anatomy() const {
  return impl_->anatomy;
}
Eigen::Index SoftBody::nodes() const {
  return impl_->mass.size();
}
const VecX& SoftBody::node_mass() const {
  return impl_->mass;
}
double SoftBody::total_mass() const {
  return impl_->mass.sum();
}
std::span<const double> SoftBody::surface_area() const {
  return impl_->area;
}
const TimeIntegrator& SoftBody::integrator() const {
  return *impl_->integrator;
}
std::size_t SoftBody::elements() const {
  return impl_->model->connectivity().size();
}
std::size_t SoftBody::dropped_elements() const {
  return impl_->model->dropped_elements();
}
Substepper* SoftBody::substepper() const {
  return impl_->substepper.get();
}
const VecX& SoftBody::attachment_stiffness() const {
  return impl_->ties;
}

void SoftBody::set_in_force(double stiffness, bool attached) {
  Impl& m = *impl_;
  if (stiffness == m.strength && attached == m.tied) return;
  m.strength = stiffness;
  m.tied = attached;
  m.weigh();
  m.build_on_inertia();
  if (m.recovery) m.recovery->set_in_force(stiffness, attached);
}

bool SoftBody::attached() const {
  return !impl_->attached.isZero();
}

bool SoftBody::falls() const {
  const bool cut_loose = !impl_->desc.attach.empty() && impl_->ties.isZero();
  return impl_->desc.gravity || !impl_->tied || cut_loose;
}

std::uint64_t SoftBody::content_hash() const {
  StateHasher hasher;
  const VecX& rest = impl_->rest();
  hasher.add(impl_->anatomy.tets.positions.size());
  hasher.add(impl_->anatomy.tets.tets.size());
  hasher.add(std::as_bytes(std::span(impl_->anatomy.tets.tets)));
  hasher.add(std::as_bytes(std::span(impl_->anatomy.quads)));
  hasher.add(std::as_bytes(std::span(impl_->anatomy.triangles)));
  hasher.add(std::as_bytes(std::span(impl_->anatomy.segments)));
  hasher.add(rest.data(), static_cast<std::size_t>(rest.size()));
  hasher.add(impl_->mass.data(), static_cast<std::size_t>(impl_->mass.size()));
  return hasher.digest();
}

const VecX& SoftBody::rest() const {
  return impl_->rest();
}

SoftBodyState SoftBody::initial_state() const {
  SoftBodyState state;
  const VecX& rest = impl_->rest();
  const VecX still = VecX::Zero(rest.size());
  state.motion = {rest, still, rest, still, false};
  state.warm_start = still;
  state.history = VecX::Zero(static_cast<Eigen::Index>(impl_->model->history_size()));
  if (impl_->substepper) impl_->substepper->initialise(state);
  return state;
}

void SoftBody::begin_stage(int stage_index, double h, const Vec3& gravity, const SoftBodyState& state,
                           bool euler) {
  Impl& m = *impl_;
  m.stepping = euler ? m.euler.get() : m.integrator.get();
  m.stepping->begin(stage_index, h, falls() ? gravity : Vec3::Zero(), state.motion, m.stage);
  m.x_n = state.motion.x;
  m.hessian->begin_stage(m.x_n, m.weights());
  m.damping.begin_stage(m.stage.x_v);
  if (m.relaxed)
    m.model->relax_fully();
  else
    m.model->begin_step(m.stepping->share(stage_index) * h, m.x_n.data(), state.history.data());
}

void SoftBody::set_relaxed(bool relaxed) {
  impl_->relaxed = relaxed;
}

const Stage& SoftBody::stage() const {
  return impl_->stage;
}

void SoftBody::initial_guess(double h, const SoftBodyState& state, Eigen::Ref<VecX> x) const {
  const Impl& m = *impl_;
  if (m.stepping->stages() == 1)
    x = state.motion.x + h * state.motion.v + state.warm_start;
  else
    x = m.stage.x_v + m.stage.dxdv * state.motion.v;
}

void SoftBody::linearise(const Eigen::Ref<const VecX>& x) {
  Impl& m = *impl_;
  if (tangent_is_cheap() && !m.elements.near_assembled(x)) m.elements.linearise(x);
  if (m.system.damped()) m.damping.update(x, true);
}

double SoftBody::energy(const Eigen::Ref<const VecX>& x) {
  Impl& m = *impl_;
  if (m.system.damped()) m.damping.update(x, false);
  const double c = m.desc.damping_mass / m.stage.dxdv, d = m.desc.damping_stiffness / m.stage.dxdv;
  const double nodal = m.node_sum([&](Eigen::Index i) {
    const auto at = [i](const auto& v) { return v.template segment<3>(3 * i); };
    double sum = m.inertia[i] * (m.stage.alpha * (at(x) - at(m.stage.y)).squaredNorm() +
                                 c * (at(x) - at(m.stage.x_v)).squaredNorm());
    if (m.attached[i] > 0)
      sum += m.attached[i] *
             ((at(x) - at(m.rest())).squaredNorm() + d * (at(x) - at(m.stage.x_v)).squaredNorm());
    return 0.5 * sum;
  });
  const double damping = m.system.damped() ? d * m.damping.energy() : 0;
  return m.strength * (nodal + damping + m.model->energy(x.data()));
}

void SoftBody::gradient(const Eigen::Ref<const VecX>& x, Eigen::Ref<VecX> g) {
  Impl& m = *impl_;
  if (m.system.damped()) m.damping.update(x, true);
  const double c = m.desc.damping_mass / m.stage.dxdv, d = m.desc.damping_stiffness / m.stage.dxdv;
  parallel_chunks(
      m.node_count(), NodeSum::nodes_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
        for (std::size_t node = first; node < last; ++node) {
          const auto i = static_cast<Eigen::Index>(node);
          const auto at = [i](const auto& v) { return v.template segment<3>(3 * i); };
          Vec3 sum = m.inertia[i] * (m.stage.alpha * (at(x) - at(m.stage.y)) + c * (at(x) - at(m.stage.x_v)));
          if (m.attached[i] > 0)
            sum += m.attached[i] * (at(x) - at(m.rest()) + d * (at(x) - at(m.stage.x_v)));
          if (m.system.damped()) sum += d * at(m.damping.forces());
          g.segment<3>(3 * i) = sum;
        }
      });
  m.model->add_gradient(x.data(), g.data());
  if (m.strength != 1) g *= m.strength;
}

bool SoftBody::tangent_is_cheap() const {
  return impl_->elements.turned();
}

void SoftBody::assemble(const Eigen::Ref<const VecX>& x) {
  impl_->hessian->assemble(x);
}
bool SoftBody::assemble_roughly(const Eigen::Ref<const VecX>& x) {
  return impl_->hessian->assemble_roughly(x);
}
void SoftBody::multiply(const double* p, double* Hp) const {
  impl_->hessian->multiply(p, Hp);
  impl_->scale(impl_->strength, Hp);
}
void SoftBody::diagonal(std::span<Mat3> blocks) const {
  std::copy(impl_->hessian->diagonal().begin(), impl_->hessian->diagonal().end(), blocks.begin());
  if (impl_->strength == 1) return;
  for (Mat3& block : blocks) block *= impl_->strength;
}
void SoftBody::factor_solve(const double* r, double* z) const {
  impl_->hessian->factor_solve(r, z);
  impl_->scale(1 / impl_->strength, z);
}
void SoftBody::multigrid_solve(std::span<const Mat3> diagonal, std::span<const Mat3> inverse, const double* r,
                               double* z) const {
  Impl& m = *impl_;
  if (m.strength == 1) return m.hessian->multigrid_solve(diagonal, inverse, r, z);
  std::vector<Mat3> own(diagonal.begin(), diagonal.end()), own_inverse(inverse.begin(), inverse.end());
  for (Mat3& block : own) block /= m.strength;
  for (Mat3& block : own_inverse) block *= m.strength;
  m.hessian->multigrid_solve(own, own_inverse, r, z);
  m.scale(1 / m.strength, z);
}

void SoftBody::finish_stage(int stage_index, double h, const Eigen::Ref<const VecX>& x,
                            SoftBodyState& state) const {
  const Impl& m = *impl_;
  if (stage_index == 0) state.warm_start = -h * state.motion.v;
  m.stepping->finish(stage_index, h, m.stage, x, state.motion);
  if (!m.relaxed) m.model->end_step(x.data(), state.history.data());
  if (stage_index + 1 == m.stepping->stages()) state.warm_start += h * state.motion.v;
}

void SoftBody::remember(const SoftBodyState& state) {
  impl_->remembered.x = state.motion.x;
  impl_->remembered.v = state.motion.v;
  impl_->history = state.history;
}

void SoftBody::recall(SoftBodyState& state) const {
  state.motion.x = impl_->remembered.x;
  state.motion.v = impl_->remembered.v;
  state.history = impl_->history;
  state.motion.has_history = false;
  state.warm_start.setZero();
}

const Motion& SoftBody::remembered() const {
  return impl_->remembered;
}

double SoftBody::elastic_energy(const Eigen::Ref<const VecX>& x) {
  Impl& m = *impl_;
  const double springs = m.node_sum([&](Eigen::Index i) {
    return 0.5 * m.attached[i] * (x.segment<3>(3 * i) - m.rest().segment<3>(3 * i)).squaredNorm();
  });
  m.model->relax_fully();
  return m.strength * (springs + m.model->energy(x.data()));
}

double SoftBody::kinetic_energy(const SoftBodyState& state) const {
  const VecX& v = state.motion.v;
  double sum = 0;
  for (Eigen::Index i = 0; i < nodes(); ++i) sum += impl_->mass[i] * v.segment<3>(3 * i).squaredNorm();
  return 0.5 * sum;
}

double SoftBody::inertia_energy(const Eigen::Ref<const VecX>& x) const {
  const Impl& m = *impl_;
  double sum = 0;
  for (Eigen::Index i = 0; i < nodes(); ++i)
    sum += m.mass[i] * (x.segment<3>(3 * i) - m.stage.y.segment<3>(3 * i)).squaredNorm();
  return 0.5 * m.stage.alpha * sum;
}

double SoftBody::fall_energy(const VecX& from, const VecX& to, const Vec3& gravity) const {
  double sum = 0;
  if (!falls()) return sum;
  for (Eigen::Index i = 0; i < nodes(); ++i)
    sum += impl_->mass[i] * gravity.dot(to.segment<3>(3 * i) - from.segment<3>(3 * i));
  return sum;
}

double SoftBody::diagonal() const {
  return impl_->diagonal;
}

}  // namespace prosector
