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
#include "server/physics/soft/block_matrix.h"
#include "server/physics/soft/cholesky.h"
#include "server/physics/soft/elastic_model.h"
#include "server/physics/soft/multigrid.h"
#include "server/physics/soft/node_vectors.h"
#include "server/physics/soft/rungs.h"
#include "server/physics/soft/soft_body_setup.h"
#include "server/physics/soft/substepper.h"
#include "server/physics/soft/symmetric_rows.h"
#include "server/physics/soft/tet10.h"
#include "server/physics/soft/turned_stiffness.h"

namespace prosector {
namespace {

constexpr std::size_t nodes_per_chunk = 256;
/// Cells that nodes may move while a matrix is still good to descend with.
constexpr double same_tangent = 0.1;
/// Of inertia over stiffness: from here on H in single precision is as definite as in double.
constexpr double least_inertia = 1e-5;
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

VecX lumped_mass(double density, VecX volume) {
  const double least = SoftBody::least_mass_share * volume.mean();
  return density * volume.cwiseMax(least);
}

double bounding_diagonal(const VecX& x) {
  const auto points = x.reshaped(3, x.size() / 3);
  return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
}

}  // namespace

/// Turned elements, and the positions they are at.
struct Linearised {
  TurnedElements elements;
  VecX at;
  bool known = false;
};

struct SoftBody::Impl {
  SoftDesc desc;
  Anatomy anatomy;
  std::unique_ptr<ElasticModel> model;
  std::unique_ptr<TimeIntegrator> integrator, euler;
  const TimeIntegrator* stepping = nullptr;  // the one of the step begun
  BlockPattern pattern;
  SymmetricPattern symmetric;
  std::optional<TurnedStiffness> turned;  // of models that turn
  VecX mass, attached;                    // n kg; n N/m
  std::unique_ptr<Substepper> substepper;
  std::unique_ptr<SoftBody> recovery;
  std::vector<double> area;
  double diagonal;    // m
  TetMesh eighths;    // of quadratic tetrahedra: linear ones on the same nodes
  Motion remembered;  // x, v
  VecX history;       // with them

  Stage stage;
  std::vector<double> node_sums;  // one a chunk

  // The Hessian without the bodies around: `hessian` in double, or scale()·(off-diagonal blocks of `rows`)
  // and own_diagonal. Turned elements go straight into `rows`; the others, and `direct`, by `hessian`.
  mutable std::vector<Mat3> hessian;  // blocks of `pattern`; made when first used
  mutable SymmetricRows rows;
  mutable bool hessian_known = false, rows_known = false;  // as last assembled
  std::vector<Mat3> own_diagonal;
  bool uses_single = false;
  double rest_stiffness = 0;  // N/m: mean of the diagonal at rest

  // Where the stage's elements were linearised: first, and last after that. Damping multiplies with Hooke's
  // stiffness turned with each element as it is at the first, as turned elements or as blocks.
  Linearised first, later;
  const Linearised* present = nullptr;    // the last of them
  const Linearised* assembled = nullptr;  // of the last matrix
  bool damped;
  std::vector<Mat3> first_stiffness;
  bool first_stiffness_known = false;
  VecX x_n, drift, damping;   // 3n: x_n; x − x_v; the stiffness times drift
  double damping_energy = 0;  // half of drift times that
  bool drift_known = false, damping_known = false;
  bool relaxed = false;  // see set_relaxed
  mutable std::unique_ptr<Cholesky> cholesky;
  mutable bool factored = false;
  mutable std::unique_ptr<Multigrid> multigrid;
  mutable bool multigrid_set = false, multigrid_turned = false;

  Impl(const SoftDesc& d, Anatomy a)
      : desc((check_constants(d), d)),
        anatomy((check_mesh(d, a), nodes_for(d, std::move(a)))),
        model(named(d, [&] { return make_elastic_model(d, anatomy); })),
        pattern(model->connectivity()),
        symmetric(pattern),
        mass(lumped_mass(d.density, model->volume())),
        attached(prosector::attachment_stiffness(d.attach, model->rest(), model->volume())),
        area(vertex_areas(anatomy)),
        diagonal(bounding_diagonal(model->rest())),
        rows(symmetric),
        own_diagonal(pattern.rows()),
        damped(d.damping_stiffness > 0) {
    named(d, [&] { return make_solver(d.solver); });  // used by whoever solves, refused here
    require(model->connectivity().size() > 0, d,
            fmt::format("all {} elements are flat or of no length; at least one must not be",
                        model->dropped_elements()));
    substepper = named(d, [&] { return make_substepper({desc, *model, pattern, mass, attached}, anatomy); });
    euler = make_integrator("implicit_euler");
    if (d.element == "tet10") eighths = divided(anatomy.tets);
    integrator = make_integrator(substepper ? "implicit_euler" : d.integrator);
    stepping = integrator.get();
    reserve();
  }

  std::size_t node_count() const { return model->connectivity().nodes(); }
  const VecX& rest() const { return model->rest(); }
  const TetMesh& linear_tets() const { return eighths.tets.empty() ? anatomy.tets : eighths; }

  void reserve() {
    node_sums.resize(chunk_count(node_count(), nodes_per_chunk));
    if (model->turns()) turned.emplace(model->connectivity(), symmetric);
    if (!turned || desc.solver == "direct") {
      hessian.resize(pattern.blocks());
      if (damped) first_stiffness.resize(pattern.blocks());
    }
    std::vector<Mat3> stiffness(pattern.blocks());
    pattern.gather(model->warped_stiffness(rest().data()), 0, {}, stiffness);
    for (std::size_t i = 0; i < node_count(); ++i) rest_stiffness += stiffness[pattern.diagonal(i)].trace();
    rest_stiffness /= static_cast<double>(3 * node_count());
    for (VecX* v : {&first.at, &later.at, &x_n, &drift, &damping, &stage.y, &stage.x_v, &stage.v_h,
                    &remembered.x, &remembered.v})
      *v = VecX::Zero(rest().size());
    if (desc.solver == "direct") cholesky = std::make_unique<Cholesky>(pattern);
    if (desc.solver == "multigrid") make_coarse_levels();
  }

  void make_coarse_levels() const {
    std::vector<Mat3> stiffness(pattern.blocks());
    pattern.gather(model->warped_stiffness(rest().data()), 0, {}, stiffness);
    multigrid = std::make_unique<Multigrid>(RestSystem{pattern, stiffness, rest(), mass, attached});
  }

  /// Sums f(i) over the nodes.
  template <class F>
  double node_sum(const F& f) {
    parallel_chunks(node_count(), nodes_per_chunk,
                    [&](std::size_t first, std::size_t last, std::size_t chunk) {
                      double sum = 0;
                      for (std::size_t i = first; i < last; ++i) sum += f(static_cast<Eigen::Index>(i));
                      node_sums[chunk] = sum;
                    });
    return ordered_sum(node_sums);
  }

  double inertia() const { return stage.alpha + desc.damping_mass / stage.dxdv; }
  double damping_share() const { return desc.damping_stiffness / stage.dxdv; }
  double scale() const { return 1 + damping_share(); }
  bool tangent_is_cheap() const { return turned && uses_single; }

  /// x, unless it is nowhere to know anything of: x_n then.
  Eigen::Ref<const VecX> somewhere(const Eigen::Ref<const VecX>& x) const {
    const bool good = x.allFinite() && x.lpNorm<Eigen::Infinity>() < max_coordinate;
    return good ? x : Eigen::Ref<const VecX>(x_n);
  }
  void find(const Eigen::Ref<const VecX>& x, Linearised& out) {
    model->linearise(x.data(), 1 / scale(), out.elements);
    out.at = x;
    out.known = true;
  }
  /// Everything that is known of turned elements, at x.
  void linearise(const Eigen::Ref<const VecX>& x) {
    if (present && x == present->at) return;
    if (!first.known) find(somewhere(x), first);
    present = &first;
    if (x == first.at) return;
    find(x, later);
    present = &later;
    if (assembled == &later) assembled = nullptr;
  }
  bool near(const Eigen::Ref<const VecX>& x, const VecX& there) const {
    return (x - there).lpNorm<Eigen::Infinity>() <= same_tangent * desc.cell;
  }

  /// What stiffness-proportional damping multiplies with in this stage, found at x when first asked for.
  void begin_damping(const Eigen::Ref<const VecX>& x) {
    if (tangent_is_cheap()) {
      if (!first.known) linearise(x);
    } else if (!first_stiffness_known) {
      first_stiffness.resize(pattern.blocks());
      pattern.gather(model->warped_stiffness(somewhere(x).data()), 0, {}, first_stiffness);
      first_stiffness_known = true;
    }
  }

  /// drift = x − x_v, damping_energy = ½drift·K·drift and, with `forces`, damping = K·drift: what
  /// stiffness-proportional damping needs at x.
  void update_damping(const Eigen::Ref<const VecX>& x, bool forces) {
    if (!damped) return;
    const bool same = drift_known && (x - stage.x_v) == drift;
    if (same && (damping_known || !forces)) return;
    begin_damping(x);
    drift = x - stage.x_v;
    drift_known = true;
    damping_known = forces || !tangent_is_cheap();
    if (!tangent_is_cheap()) {
      pattern.multiply(first_stiffness, drift.data(), damping.data());
      damping_energy = 0.5 * node_sum([&](Eigen::Index i) {
                         return drift.segment<3>(3 * i).dot(damping.segment<3>(3 * i));
                       });
    } else if (forces) {
      damping_energy = turned->multiply(first.elements, drift.data(), damping.data());
    } else {
      damping_energy = turned->energy(first.elements, drift.data());
    }
  }

  void assemble_warped(const Eigen::Ref<const VecX>& x) {
    hessian.resize(pattern.blocks());
    if (damped) {
      begin_damping(x);
      parallel_chunks(hessian.size(), 16 * nodes_per_chunk,
                      [&](std::size_t begin, std::size_t end, std::size_t) {
                        for (std::size_t k = begin; k < end; ++k) hessian[k] = scale() * first_stiffness[k];
                      });
    } else {
      pattern.gather(model->warped_stiffness(x_n.data()), 0, {}, hessian);
    }
    use_hessian();
  }

  /// Completes `hessian`, which holds what couples nodes.
  void use_hessian() {
    add_diagonal([&](std::size_t i) -> const Mat3& { return hessian[pattern.diagonal(i)]; });
    for (std::size_t i = 0; i < node_count(); ++i) hessian[pattern.diagonal(i)] = own_diagonal[i];
    hessian_known = true;
    rows_known = false;
    if (uses_single) set_rows();
  }
  /// The rows in double, for who factors another's matrix.
  void set_hessian() const {
    hessian.resize(pattern.blocks());
    rows.write(symmetric, pattern, scale(), hessian);
    for (std::size_t i = 0; i < node_count(); ++i) hessian[pattern.diagonal(i)] = own_diagonal[i];
    hessian_known = true;
  }
  void set_rows() const {
    if (!rows_known) rows.set(symmetric, pattern, 1 / scale(), hessian);
    rows_known = true;
  }
  /// Takes `rows` as they are.
  void use_rows() {
    add_diagonal([&](std::size_t i) -> Mat3 { return scale() * rows.diagonal[i]; });
    hessian_known = false;
    rows_known = true;
  }

  /// own_diagonal = what elements make of it, and all else that is diagonal.
  template <class F>
  void add_diagonal(const F& of_elements) {
    parallel_chunks(node_count(), nodes_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t i = first; i < last; ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        own_diagonal[i] = of_elements(i);
        own_diagonal[i].diagonal().array() += inertia() * mass[row] + scale() * attached[row];
      }
    });
    factored = multigrid_set = false;
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
  return impl_->attached;
}

std::uint64_t SoftBody::content_hash() const {
  StateHasher hasher;
  const VecX& rest = impl_->rest();
  hasher.add(impl_->anatomy.tets.positions.size());
  hasher.add(impl_->anatomy.tets.tets.size());
  hasher.add(std::as_bytes(std::span(impl_->anatomy.tets.tets)));
  hasher.add(std::as_bytes(std::span(impl_->anatomy.quads)));
  hasher.add(std::as_bytes(std::span(impl_->anatomy.segments)));
  hasher.add(rest.data(), static_cast<std::size_t>(rest.size()));
  hasher.add(impl_->mass.data(), static_cast<std::size_t>(impl_->mass.size()));
  return hasher.digest();
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
  m.stepping->begin(stage_index, h, m.desc.gravity ? gravity : Vec3::Zero(), state.motion, m.stage);
  m.x_n = state.motion.x;
  m.multigrid_turned = false;
  m.first.known = m.first_stiffness_known = m.drift_known = false;
  m.present = m.assembled = nullptr;
  m.uses_single = m.desc.solver != "direct" && (m.turned || m.desc.solver == "multigrid") &&
                  m.inertia() * m.mass.mean() > least_inertia * m.rest_stiffness;
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
  if (tangent_is_cheap() && !(m.assembled && m.near(x, m.assembled->at))) m.linearise(x);
  m.update_damping(x, true);
}

double SoftBody::energy(const Eigen::Ref<const VecX>& x) {
  Impl& m = *impl_;
  m.update_damping(x, false);
  const double c = m.desc.damping_mass / m.stage.dxdv, d = m.desc.damping_stiffness / m.stage.dxdv;
  const double nodal = m.node_sum([&](Eigen::Index i) {
    const auto at = [i](const auto& v) { return v.template segment<3>(3 * i); };
    double sum = m.mass[i] * (m.stage.alpha * (at(x) - at(m.stage.y)).squaredNorm() +
                              c * (at(x) - at(m.stage.x_v)).squaredNorm());
    if (m.attached[i] > 0)
      sum += m.attached[i] *
             ((at(x) - at(m.rest())).squaredNorm() + d * (at(x) - at(m.stage.x_v)).squaredNorm());
    return 0.5 * sum;
  });
  const double damping = m.damped ? d * m.damping_energy : 0;
  return nodal + damping + m.model->energy(x.data());
}

void SoftBody::gradient(const Eigen::Ref<const VecX>& x, Eigen::Ref<VecX> g) {
  Impl& m = *impl_;
  m.update_damping(x, true);
  const double c = m.desc.damping_mass / m.stage.dxdv, d = m.desc.damping_stiffness / m.stage.dxdv;
  parallel_chunks(m.node_count(), nodes_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t node = first; node < last; ++node) {
      const auto i = static_cast<Eigen::Index>(node);
      const auto at = [i](const auto& v) { return v.template segment<3>(3 * i); };
      Vec3 sum = m.mass[i] * (m.stage.alpha * (at(x) - at(m.stage.y)) + c * (at(x) - at(m.stage.x_v)));
      if (m.attached[i] > 0) sum += m.attached[i] * (at(x) - at(m.rest()) + d * (at(x) - at(m.stage.x_v)));
      if (m.damped) sum += d * at(m.damping);
      g.segment<3>(3 * i) = sum;
    }
  });
  m.model->add_gradient(x.data(), g.data());
}

bool SoftBody::tangent_is_cheap() const {
  return impl_->tangent_is_cheap();
}

void SoftBody::assemble(const Eigen::Ref<const VecX>& x) {
  Impl& m = *impl_;
  if (tangent_is_cheap()) {
    m.linearise(x);
    m.turned->assemble(m.present->elements, m.rows);
    m.assembled = m.present;
    m.use_rows();
  } else {
    if (m.damped) m.begin_damping(x);
    m.hessian.resize(m.pattern.blocks());
    m.pattern.gather(m.model->tangent(x.data()), m.damping_share(), m.first_stiffness, m.hessian);
    m.use_hessian();
  }
}

bool SoftBody::assemble_roughly(const Eigen::Ref<const VecX>& x) {
  Impl& m = *impl_;
  if (tangent_is_cheap() ? !(m.assembled && m.near(x, m.assembled->at)) : !m.near(x, m.x_n)) {
    assemble(x);
    return false;
  }
  if (tangent_is_cheap())
    m.multigrid_set = false;  // what touches the body may have changed
  else
    m.assemble_warped(x);
  return true;
}

void SoftBody::multiply(const double* p, double* Hp) const {
  const Impl& m = *impl_;
  if (m.uses_single)
    prosector::multiply(m.symmetric, m.rows, m.scale(), m.own_diagonal, p, Hp);
  else
    m.pattern.multiply(m.hessian, p, Hp);
}

void SoftBody::diagonal(std::span<Mat3> blocks) const {
  std::copy(impl_->own_diagonal.begin(), impl_->own_diagonal.end(), blocks.begin());
}

void SoftBody::factor_solve(const double* r, double* z) const {
  const Impl& m = *impl_;
  if (!m.cholesky) m.cholesky = std::make_unique<Cholesky>(m.pattern);
  if (!m.factored) {
    if (!m.hessian_known) m.set_hessian();
    m.cholesky->factor(m.hessian);
    m.factored = true;
  }
  m.cholesky->solve(r, z);
}

void SoftBody::multigrid_solve(std::span<const Mat3> diagonal, std::span<const Mat3> inverse, const double* r,
                               double* z) const {
  const Impl& m = *impl_;
  if (!m.multigrid) m.make_coarse_levels();
  if (!m.multigrid_turned) {
    m.multigrid->retime(m.inertia() / m.scale());
    m.multigrid->turn(m.model->objective() ? m.x_n.data() : nullptr);
    m.multigrid_turned = true;
  }
  m.set_rows();
  if (!m.multigrid_set)
    m.multigrid->set_matrix(m.symmetric.blocks_of(m.rows.right), m.scale(), diagonal, inverse);
  m.multigrid_set = true;
  m.multigrid->apply(r, z);
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
  return springs + m.model->energy(x.data());
}

double SoftBody::kinetic_energy(const SoftBodyState& state) const {
  const VecX& v = state.motion.v;
  double sum = 0;
  for (Eigen::Index i = 0; i < nodes(); ++i) sum += impl_->mass[i] * v.segment<3>(3 * i).squaredNorm();
  return 0.5 * sum;
}

double SoftBody::fall_energy(const VecX& from, const VecX& to, const Vec3& gravity) const {
  double sum = 0;
  if (!impl_->desc.gravity) return sum;
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

void SoftBody::unfold(SoftBodyState& state) const {
  prosector::unfold(impl_->rest(), impl_->mass, impl_->model->objective(), state);
  if (impl_->attached.isZero()) return;
  state.motion.x = impl_->rest();
  state.motion.v.setZero();
}

}  // namespace prosector
