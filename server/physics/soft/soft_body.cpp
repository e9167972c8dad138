#include "server/physics/soft/soft_body.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <utility>

#include "common/error.h"
#include "common/hash.h"
#include "server/physics/parallel.h"
#include "server/physics/soft/block_matrix.h"
#include "server/physics/soft/cholesky.h"
#include "server/physics/soft/element_batches.h"
#include "server/physics/soft/tet4.h"

namespace prosector {
namespace {

constexpr std::size_t nodes_per_chunk = 256;

void require(bool ok, const SoftDesc& desc, const std::string& what) {
  if (!ok) throw InputError(fmt::format("soft body \"{}\": {}", desc.name, what));
}

void check_constants(const SoftDesc& desc) {
  const auto positive = [](double v) { return v > 0 && std::isfinite(v); };
  const auto not_negative = [](double v) { return v >= 0 && std::isfinite(v); };
  require(positive(desc.density), desc,
          fmt::format("density is {}; allowed: positive, in kg/m³", desc.density));
  require(not_negative(desc.damping_mass), desc,
          fmt::format("damping_mass is {}; allowed: 0 or more, in 1/s", desc.damping_mass));
  require(not_negative(desc.damping_stiffness), desc,
          fmt::format("damping_stiffness is {}; allowed: 0 or more, in s", desc.damping_stiffness));
  for (const AttachDesc& attach : desc.attach) {
    require(not_negative(attach.stiffness), desc,
            fmt::format("attach stiffness is {}; allowed: 0 or more, in N/m⁴", attach.stiffness));
    require(not_negative(attach.radius), desc,
            fmt::format("attach radius is {}; allowed: 0 or more, in m", attach.radius));
  }
}

void check_mesh(const SoftDesc& desc, const Anatomy& anatomy) {
  const std::size_t n = anatomy.tets.positions.size();
  require(!anatomy.tets.tets.empty(), desc, "its mesh has no tetrahedra; at least one is needed");
  for (std::size_t i = 0; i < n; ++i) {
    require(is_finite(anatomy.tets.positions[i]), desc, fmt::format("node {} is not finite", i));
  }
  for (std::size_t e = 0; e < anatomy.tets.tets.size(); ++e) {
    for (std::uint32_t node : anatomy.tets.tets[e]) {
      require(node < n, desc, fmt::format("tetrahedron {} names node {}; there are {}", e, node, n));
    }
  }
  const std::size_t vertices = anatomy.surface.positions.size();
  require(anatomy.embedding.rows.size() == vertices, desc,
          fmt::format("{} surface vertices but {} rows that embed them", vertices,
                      anatomy.embedding.rows.size()));
  for (const auto& row : anatomy.embedding.rows) {
    for (std::uint32_t node : row.node) {
      require(node < n, desc, fmt::format("its surface is tied to node {}; there are {}", node, n));
    }
  }
  for (const auto& triangle : anatomy.surface.triangles) {
    for (std::uint32_t vertex : triangle) {
      require(vertex < vertices, desc,
              fmt::format("a surface triangle names vertex {}; there are {}", vertex, vertices));
    }
  }
}

template <class T>
auto named(const SoftDesc& desc, const T& make) {
  try {
    return make();
  } catch (const InputError& error) {
    throw InputError(fmt::format("soft body \"{}\": {}", desc.name, error.what()));
  }
}

VecX flattened(const std::vector<Vec3>& points) {
  VecX x(static_cast<Eigen::Index>(3 * points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) x.segment<3>(static_cast<Eigen::Index>(3 * i)) = points[i];
  return x;
}

VecX lumped_mass(double density, VecX volume) {
  const double least = SoftBody::least_mass_share * volume.mean();
  return density * volume.cwiseMax(least);
}

/// A node in several spheres takes the stiffest.
VecX attachment(const std::vector<AttachDesc>& attach, const std::vector<Vec3>& nodes, const VecX& volume) {
  VecX k = VecX::Zero(volume.size());
  for (const AttachDesc& a : attach) {
    for (Eigen::Index i = 0; i < k.size(); ++i) {
      const bool inside = (nodes[static_cast<std::size_t>(i)] - a.center).norm() <= a.radius;
      if (inside) k[i] = std::max(k[i], a.stiffness * volume[i]);
    }
  }
  return k;
}

std::vector<double> vertex_areas(const TriangleMesh& surface) {
  std::vector<double> area(surface.positions.size(), 0.0);
  for (const auto& t : surface.triangles) {
    const Vec3 &a = surface.positions[t[0]], &b = surface.positions[t[1]], &c = surface.positions[t[2]];
    const double third = (b - a).cross(c - a).norm() / 6;
    for (std::uint32_t vertex : t) area[vertex] += third;
  }
  return area;
}

}  // namespace

struct SoftBody::Impl {
  SoftDesc desc;
  Anatomy anatomy;
  std::unique_ptr<TimeIntegrator> integrator;
  Tet4Elements elements;
  std::unique_ptr<ElementBatches> batches;
  BlockPattern pattern;
  VecX rest, mass, attached;  // 3n m; n kg; n N/m
  std::vector<double> area;

  // Where each node appears: `corner` lists 4·element + local node, node i's from corner_begin[i] on.
  std::vector<std::size_t> corner_begin;
  std::vector<std::uint32_t> corner;

  Stage stage;
  std::vector<double> element_sums, node_sums;  // one a chunk
  std::vector<Tet4Elements::Forces> element_forces;
  std::vector<Tet4Elements::Stiffness> element_stiffness;
  std::vector<Mat3> hessian, start_stiffness;  // blocks; K(x_n), used when damped
  bool damped;
  VecX x_n, drift, damping;  // 3n: x_n; x − x_v; K(x_n)·drift
  VecX moved_to;             // 3n: where `batches` are
  bool moved = false;
  mutable std::unique_ptr<Cholesky> cholesky;
  mutable bool factored = false;

  Impl(const SoftDesc& d, Anatomy a)
      : desc((check_constants(d), d)),
        anatomy((check_mesh(d, a), std::move(a))),
        integrator(named(d, [&] { return make_integrator(d.integrator); })),
        elements(anatomy.tets),
        batches(named(
            d, [&] { return make_batches(d.model, lame(d.youngs_modulus, d.poisson_ratio), elements); })),
        pattern(anatomy.tets.positions.size(), elements),
        rest(flattened(anatomy.tets.positions)),
        area(vertex_areas(anatomy.surface)),
        damped(d.damping_stiffness > 0) {
    named(d, [&] { return make_solver(d.solver); });  // used by whoever solves, refused here
    require(elements.size() > 0, d,
            fmt::format("all {} tetrahedra are flat; at least one must not be", elements.dropped()));
    const VecX volume = Tet4Elements::lumped_volume(anatomy.tets);
    mass = lumped_mass(d.density, volume);
    attached = attachment(d.attach, anatomy.tets.positions, volume);
    list_corners();
    reserve();
  }

  std::size_t node_count() const { return anatomy.tets.positions.size(); }

  void list_corners() {
    corner_begin.assign(node_count() + 1, 0);
    for (std::size_t e = 0; e < elements.size(); ++e) {
      for (std::uint32_t i : elements.nodes(e)) ++corner_begin[i + 1];
    }
    for (std::size_t i = 0; i < node_count(); ++i) corner_begin[i + 1] += corner_begin[i];
    corner.resize(corner_begin.back());
    std::vector<std::size_t> next(corner_begin.begin(), corner_begin.end() - 1);
    for (std::uint32_t e = 0; e < elements.size(); ++e) {
      for (std::uint32_t a = 0; a < 4; ++a) corner[next[elements.nodes(e)[a]]++] = 4 * e + a;
    }
  }

  void reserve() {
    element_sums.resize(chunk_count(elements.size(), elements_per_batch));
    node_sums.resize(chunk_count(node_count(), nodes_per_chunk));
    element_forces.resize(elements.size());
    element_stiffness.resize(elements.size());
    hessian.resize(pattern.blocks());
    if (damped) start_stiffness.resize(pattern.blocks());
    for (VecX* v : {&x_n, &drift, &damping, &moved_to, &stage.y, &stage.x_v}) *v = VecX::Zero(rest.size());
    if (desc.solver == "direct") cholesky = std::make_unique<Cholesky>(pattern);
  }

  /// Calls f(batch, first, count) for all batches of elements.
  template <class F>
  void for_batches(const F& f) const {
    parallel_chunks(
        elements.size(), elements_per_batch,
        [&](std::size_t first, std::size_t last, std::size_t batch) { f(batch, first, last - first); });
  }

  /// Puts the elements at x, unless they are there: Newton asks for energy, gradient and Hessian at the same
  /// place, and the next step starts where the last one ended.
  void move(const double* x) {
    const auto bytes = static_cast<std::size_t>(moved_to.size()) * sizeof(double);
    if (moved && std::memcmp(x, moved_to.data(), bytes) == 0) return;
    std::memcpy(moved_to.data(), x, bytes);
    moved = true;
    for_batches([&](std::size_t batch, std::size_t, std::size_t) { batches->move(batch, x); });
  }

  static double ordered_sum(const std::vector<double>& sums) {
    double total = 0;
    for (double sum : sums) total += sum;
    return total;
  }

  double strain_energy(const double* x) {
    move(x);
    for_batches(
        [&](std::size_t batch, std::size_t, std::size_t) { element_sums[batch] = batches->energy(batch); });
    return ordered_sum(element_sums);
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

  /// drift = x − x_v, damping = K(x_n)·drift: what stiffness-proportional damping needs at x.
  void update_damping(const Eigen::Ref<const VecX>& x) {
    if (!damped) return;
    drift = x - stage.x_v;
    pattern.multiply(start_stiffness, drift.data(), damping.data());
  }

  /// scale·base + K(x) into `values`, see BlockPattern::gather.
  void tangent(const double* x, double scale, std::span<const Mat3> base, std::vector<Mat3>& values) {
    move(x);
    for_batches([&](std::size_t batch, std::size_t first, std::size_t count) {
      batches->stiffness(batch, std::span(element_stiffness).subspan(first, count));
    });
    pattern.gather(element_stiffness, scale, base, values);
  }

  /// The warped stiffness at x into `values`.
  void warped_stiffness(const double* x, std::vector<Mat3>& values) {
    move(x);
    for_batches([&](std::size_t batch, std::size_t first, std::size_t count) {
      batches->warped_stiffness(batch, std::span(element_stiffness).subspan(first, count));
    });
    pattern.gather(element_stiffness, 0, {}, values);
  }

  /// Adds to `hessian`, which holds what couples nodes, all that is diagonal.
  void add_diagonal() {
    const double inertia = stage.alpha + desc.damping_mass / stage.dxdv;
    for (std::size_t i = 0; i < node_count(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      hessian[pattern.diagonal(i)].diagonal().array() += inertia * mass[row] + attached[row];
    }
    factored = false;
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
  return impl_->elements.size();
}
std::size_t SoftBody::dropped_elements() const {
  return impl_->elements.dropped();
}
const VecX& SoftBody::attachment_stiffness() const {
  return impl_->attached;
}

std::uint64_t SoftBody::content_hash() const {
  StateHasher hasher;
  hasher.add(impl_->anatomy.tets.positions.size());
  hasher.add(impl_->anatomy.tets.tets.size());
  hasher.add(std::as_bytes(std::span(impl_->anatomy.tets.tets)));
  hasher.add(impl_->rest.data(), static_cast<std::size_t>(impl_->rest.size()));
  hasher.add(impl_->mass.data(), static_cast<std::size_t>(impl_->mass.size()));
  return hasher.digest();
}

SoftBodyState SoftBody::initial_state() const {
  SoftBodyState state;
  const VecX still = VecX::Zero(impl_->rest.size());
  state.motion = {impl_->rest, still, impl_->rest, still, false};
  state.warm_start = still;
  return state;
}

void SoftBody::begin_stage(int stage_index, double h, const Vec3& gravity, const SoftBodyState& state) {
  Impl& m = *impl_;
  m.integrator->begin(stage_index, h, m.desc.gravity ? gravity : Vec3::Zero(), state.motion, m.stage);
  m.x_n = state.motion.x;
  if (m.damped) m.warped_stiffness(m.x_n.data(), m.start_stiffness);
}

const Stage& SoftBody::stage() const {
  return impl_->stage;
}

void SoftBody::initial_guess(double h, const SoftBodyState& state, Eigen::Ref<VecX> x) const {
  x = state.motion.x + h * state.motion.v + state.warm_start;
}

double SoftBody::energy(const Eigen::Ref<const VecX>& x) {
  Impl& m = *impl_;
  m.update_damping(x);
  const double c = m.desc.damping_mass / m.stage.dxdv, d = m.desc.damping_stiffness / m.stage.dxdv;
  const double nodal = m.node_sum([&](Eigen::Index i) {
    const auto at = [i](const auto& v) { return v.template segment<3>(3 * i); };
    double sum = m.mass[i] * (m.stage.alpha * (at(x) - at(m.stage.y)).squaredNorm() +
                              c * (at(x) - at(m.stage.x_v)).squaredNorm());
    if (m.attached[i] > 0) sum += m.attached[i] * (at(x) - at(m.rest)).squaredNorm();
    if (m.damped) sum += d * at(m.drift).dot(at(m.damping));
    return 0.5 * sum;
  });
  return nodal + m.strain_energy(x.data());
}

void SoftBody::gradient(const Eigen::Ref<const VecX>& x, Eigen::Ref<VecX> g) {
  Impl& m = *impl_;
  m.update_damping(x);
  m.move(x.data());
  m.for_batches([&](std::size_t batch, std::size_t first, std::size_t count) {
    m.batches->forces(batch, std::span(m.element_forces).subspan(first, count));
  });
  const double c = m.desc.damping_mass / m.stage.dxdv, d = m.desc.damping_stiffness / m.stage.dxdv;
  parallel_chunks(m.node_count(), nodes_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t node = first; node < last; ++node) {
      const auto i = static_cast<Eigen::Index>(node);
      const auto at = [i](const auto& v) { return v.template segment<3>(3 * i); };
      Vec3 sum = m.mass[i] * (m.stage.alpha * (at(x) - at(m.stage.y)) + c * (at(x) - at(m.stage.x_v)));
      if (m.attached[i] > 0) sum += m.attached[i] * (at(x) - at(m.rest));
      if (m.damped) sum += d * at(m.damping);
      for (std::size_t k = m.corner_begin[node]; k < m.corner_begin[node + 1]; ++k) {
        sum += m.element_forces[m.corner[k] / 4][m.corner[k] % 4];
      }
      g.segment<3>(3 * i) = sum;
    }
  });
}

void SoftBody::assemble(const Eigen::Ref<const VecX>& x) {
  Impl& m = *impl_;
  m.tangent(x.data(), m.desc.damping_stiffness / m.stage.dxdv, m.start_stiffness, m.hessian);
  m.add_diagonal();
}

void SoftBody::assemble_at_start() {
  Impl& m = *impl_;
  if (m.damped) {
    const double scale = 1 + m.desc.damping_stiffness / m.stage.dxdv;
    for (std::size_t k = 0; k < m.hessian.size(); ++k) m.hessian[k] = scale * m.start_stiffness[k];
  } else {
    m.warped_stiffness(m.x_n.data(), m.hessian);
  }
  m.add_diagonal();
}

void SoftBody::multiply(const double* p, double* Hp) const {
  impl_->pattern.multiply(impl_->hessian, p, Hp);
}

void SoftBody::diagonal(std::span<Mat3> blocks) const {
  for (std::size_t i = 0; i < blocks.size(); ++i) blocks[i] = impl_->hessian[impl_->pattern.diagonal(i)];
}

void SoftBody::factor_solve(const double* r, double* z) const {
  const Impl& m = *impl_;
  if (!m.cholesky) m.cholesky = std::make_unique<Cholesky>(m.pattern);
  if (!m.factored) {
    m.cholesky->factor(m.hessian);
    m.factored = true;
  }
  m.cholesky->solve(r, z);
}

void SoftBody::finish_stage(int stage_index, double h, const Eigen::Ref<const VecX>& x,
                            SoftBodyState& state) const {
  const Impl& m = *impl_;
  if (stage_index == 0) state.warm_start = -h * state.motion.v;
  m.integrator->finish(stage_index, h, m.stage, x, state.motion);
  if (stage_index + 1 == m.integrator->stages()) state.warm_start += h * state.motion.v;
}

double SoftBody::elastic_energy(const Eigen::Ref<const VecX>& x) {
  Impl& m = *impl_;
  const double springs = m.node_sum([&](Eigen::Index i) {
    return 0.5 * m.attached[i] * (x.segment<3>(3 * i) - m.rest.segment<3>(3 * i)).squaredNorm();
  });
  return springs + m.strain_energy(x.data());
}

double SoftBody::kinetic_energy(const SoftBodyState& state) const {
  const VecX& v = state.motion.v;
  double sum = 0;
  for (Eigen::Index i = 0; i < nodes(); ++i) sum += impl_->mass[i] * v.segment<3>(3 * i).squaredNorm();
  return 0.5 * sum;
}

}  // namespace prosector
