#include "server/physics/soft/soft_body.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "common/error.h"
#include "common/hash.h"
#include "common/messages.h"
#include "server/physics/parallel.h"
#include "server/physics/soft/body_hessian.h"
#include "server/physics/soft/rungs.h"
#include "server/physics/soft/soft_body_setup.h"
#include "server/physics/soft/stiffness_damping.h"
#include "server/physics/soft/substepper.h"
#include "server/physics/soft/tet10.h"

namespace prosector {
namespace {

const char* const recovery_model = "fem_corotational";  // no minimum but the rest shape was ever seen

template <class T>
auto named(const SoftDesc& desc, const T& make) {
  try {
    return make();
  } catch (const InputError& error) {
    throw InputError(fmt::format("soft body \"{}\": {}", desc.name, error.what()));
  }
}

/// With the nodes that its elements need.
Anatomy nodes_for(const SoftDesc& desc, Anatomy anatomy) {
  if (desc.element == "tet10") add_edge_nodes(anatomy);
  return anatomy;
}

std::unique_ptr<ElasticModel> usable_model(const SoftDesc& desc, const Anatomy& anatomy) {
  auto model = named(desc, [&] { return make_elastic_model(desc, anatomy); });
  require(model->connectivity().size() > 0, desc,
          fmt::format("all {} elements are flat or of no length; at least one must not be",
                      model->dropped_elements()));
  return model;
}

VecX lumped_mass(double density, VecX volume) {
  const double least = SoftBody::least_mass_share * volume.mean();
  return density * volume.cwiseMax(least);
}

double bounding_diagonal(const VecX& x) {
  const auto points = x.reshaped(3, x.size() / 3);
  return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
}

}  // namespace

struct SoftBody::Impl {
  SoftDesc desc;
  Anatomy anatomy;
  std::unique_ptr<ElasticModel> model;
  std::unique_ptr<TimeIntegrator> integrator, euler;
  const TimeIntegrator* stepping = nullptr;  // the one of the step begun
  BlockPattern pattern;
  SymmetricPattern symmetric;
  VecX mass, ties;  // n kg; n N/m, as described
  // A material that is s times as stiff moves as if inertia, ties and loads were 1/s of what they are: so it
  // is computed, and what leaves this class is multiplied by s. No element knows of it.
  double strength = 1;  // s
  bool tied = true;
  VecX inertia, attached;  // n kg; n N/m: those divided by s
  std::unique_ptr<Substepper> substepper;
  std::unique_ptr<SoftBody> recovery;
  std::vector<double> area;
  double diagonal;    // m
  TetMesh eighths;    // of quadratic tetrahedra: linear ones on the same nodes
  Motion remembered;  // x, v
  VecX history;       // with them

  Stage stage;
  VecX x_n;              // 3n
  bool relaxed = false;  // see set_relaxed
  SoftSystem system;
  StageElements elements;
  StiffnessDamping damping;
  std::optional<BodyHessian> hessian;
  NodeSum node_sum;

  Impl(const SoftDesc& d, Anatomy a)
      : desc((check_constants(d), d)),
        anatomy((check_mesh(d, a), nodes_for(d, std::move(a)))),
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
    if (d.element == "tet10") eighths = divided(anatomy.tets);
    integrator = make_integrator(substepper ? "implicit_euler" : d.integrator);
    start_anew();
  }

  /// Nothing is known of any step.
  void start_anew() {
    stepping = integrator.get();
    relaxed = false;
    history = {};
    for (VecX* v : {&x_n, &stage.y, &stage.x_v, &stage.v_h, &remembered.x, &remembered.v})
      v->setZero(rest().size());
  }

  /// To model and pattern as they are after a cut; the surface's area is the caller's.
  void fit() {
    symmetric.fit(pattern);
    mass = lumped_mass(desc.density, model->volume());
    ties = prosector::attachment_stiffness(desc.attach, model->rest(), model->volume());
    weigh();
    recovery.reset();
    diagonal = bounding_diagonal(model->rest());
    elements.fit();
    damping.fit(node_count());
    hessian->fit();
    node_sum = NodeSum(node_count());
    start_anew();
  }

  void weigh() {
    inertia = mass / strength;
    attached = (tied ? 1 / strength : 0) * ties;
  }

  void follow(const MeshEdit& edit) {
    apply(edit, anatomy.tets);
    model->follow(desc, anatomy.tets, edit);
    pattern.follow(edit);
    fit();
  }

  void build_on_inertia() {
    hessian.emplace(system, elements);
    substepper = named(desc, [&] {
      return make_substepper({desc, *model, pattern, inertia, attached}, anatomy);
    });
  }

  std::size_t node_count() const { return model->connectivity().nodes(); }
  const VecX& rest() const { return model->rest(); }
  const TetMesh& linear_tets() const { return eighths.tets.empty() ? anatomy.tets : eighths; }

  void scale(double factor, double* vector) const {
    if (factor != 1) Eigen::Map<VecX>(vector, rest().size()) *= factor;
  }

  StageWeights weights() const {
    return {stage.alpha + desc.damping_mass / stage.dxdv, desc.damping_stiffness / stage.dxdv};
  }
};

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

bool SoftBody::can_follow(const MeshEdit& edit) const {
  const Impl& m = *impl_;
  return !m.substepper && m.eighths.tets.empty() && m.node_count() == edit.kept_nodes.before &&
         m.model->can_follow(edit);
}

void SoftBody::follow(const MeshEdit& edit, TriangleMesh surface, SparseMap embedding) {
  Impl& m = *impl_;
  m.anatomy.surface = std::move(surface);
  m.anatomy.embedding = std::move(embedding);
  m.area = vertex_areas(m.anatomy);
  m.follow(edit);
}

void SoftBody::follow(const MeshEdit& edit, const SurfaceEdit& surface) {
  Impl& m = *impl_;
  apply(surface, m.anatomy.surface);
  apply(surface.vertices, surface.rows, m.anatomy.embedding.rows);
  follow_vertex_areas(m.anatomy.surface, surface, m.area);
  m.follow(edit);
}

bool SoftBody::can_follow_sheet() const {
  const Impl& m = *impl_;
  return mesh_kind(m.anatomy) == MeshKind::sheet && m.model->can_follow_sheet() &&
         (!m.substepper || m.substepper->can_fit());
}

void SoftBody::follow_sheet(Anatomy sheet, std::span<const std::uint32_t> touched) {
  Impl& m = *impl_;
  m.anatomy = std::move(sheet);
  m.area = vertex_areas(m.anatomy);
  m.pattern.follow(m.model->follow_sheet(m.desc, m.anatomy, touched));
  m.fit();
  if (m.substepper) m.substepper->fit();
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

bool SoftBody::has_recovery() const {
  const SoftDesc& desc = impl_->desc;
  return (desc.model != recovery_model || desc.element == "tet10") &&
         mesh_kind(impl_->anatomy) == MeshKind::tets;
}

SoftBody* SoftBody::recovery() {
  if (!impl_->recovery && has_recovery()) {
    SoftDesc desc = impl_->desc;
    desc.model = recovery_model;
    desc.integrator = "implicit_euler";
    desc.solver = "cg";
    desc.element = "tet4";
    desc.fiber_stiffness = 0;
    for (RegionDesc& region : desc.regions) region.fiber_stiffness = -1;
    desc.relaxation.clear();
    impl_->recovery = std::make_unique<SoftBody>(desc, Anatomy{impl_->linear_tets(), {}, {}});
    impl_->recovery->set_in_force(impl_->strength, impl_->tied);
  }
  return impl_->recovery.get();
}

SoftBody& SoftBody::in_force(const SoftBodyState& state) {
  return state.recovering ? *recovery() : *this;
}

bool SoftBody::turned_by(double angle, const VecX& x) const {
  if (impl_->model->objective()) return false;
  return best_rotation(impl_->rest(), impl_->mass, x).trace() < 1 + 2 * std::cos(angle);
}

double SoftBody::inverted_share(const VecX& x, double least) const {
  return crushed_share(impl_->linear_tets(), x, least);
}

const TetMesh& SoftBody::linear_tets() const {
  return impl_->linear_tets();
}

void SoftBody::unfold(SoftBodyState& state) const {
  prosector::unfold(impl_->rest(), impl_->mass, impl_->model->objective(), state);
  if (impl_->attached.isZero()) return;
  state.motion.x = impl_->rest();
  state.motion.v.setZero();
}

}  // namespace prosector
