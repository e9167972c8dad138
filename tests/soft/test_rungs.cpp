// The whole ladder: every model on every mesh with every integrator that goes with it.

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <random>
#include <string>

#include "common/anatomy/sheets_and_ropes.h"
#include "common/error.h"
#include "server/physics/mechanics/soft/incremental_potential.h"
#include "server/physics/mechanics/soft/integrators/substepper.h"
#include "server/physics/mechanics/soft/laws/material.h"
#include "server/physics/mechanics/soft/make_model.h"
#include "server/physics/mechanics/soft/mechanical_energy.h"
#include "server/physics/mechanics/soft/rungs.h"
#include "server/physics/mechanics/soft/solvers/linear_solver.h"
#include "tests/soft/kuhn.h"
#include "tests/soft/stepper.h"

namespace prosector {
namespace {

constexpr double h = 1. / 60;
const Vec3 gravity(0, -9.81, 0);

struct Rung {
  soft::ModelRow model;
  soft::MeshKind mesh;
  std::string integrator;
  std::string name() const {
    const char* const kinds[] = {"tets", "sheet", "rope"};
    return model.name + "_" + kinds[static_cast<int>(mesh)] + "_" + integrator;
  }
};

void PrintTo(const Rung& rung, std::ostream* out) {
  *out << rung.name();
}

Anatomy anatomy_of(soft::MeshKind mesh) {
  if (mesh == soft::MeshKind::sheet) return make_sheet({0.1, 0.005, 0.08}, 0.02);
  if (mesh == soft::MeshKind::rope) return make_rope({0.1, 0.01, 0}, 0.02);
  return kuhn_anatomy({2, 2, 2}, {0.06, 0.06, 0.06});
}

std::vector<soft::MeshKind> meshes_of(const soft::ModelRow& model) {
  std::vector<soft::MeshKind> out;
  if (model.tets) out.push_back(soft::MeshKind::tets);
  if (model.fabric) out.insert(out.end(), {soft::MeshKind::sheet, soft::MeshKind::rope});
  return out;
}

std::vector<Rung> rungs() {
  std::vector<Rung> out;
  for (const soft::ModelRow& model : soft::models())
    for (const soft::MeshKind mesh : meshes_of(model))
      for (const std::string& integrator : soft::integrators_for(model))
        out.push_back({model, mesh, integrator});
  return out;
}

/// One integrator of each model and mesh: what does not depend on it is tested with that.
std::vector<Rung> elastic_rungs() {
  std::vector<Rung> out;
  for (const Rung& rung : rungs())
    if (rung.integrator == "implicit_euler") out.push_back(rung);
  return out;
}

SoftDesc describe(const Rung& rung) {
  SoftDesc desc;
  desc.name = "body";
  desc.configuration.model = rung.model.name;
  desc.configuration.integrator = rung.integrator;
  desc.configuration.solver = "direct";
  desc.material.youngs_modulus = 2e4;
  desc.material.poisson_ratio = 0.4;
  desc.material.density = 1000;
  return desc;
}

VecX random_vector(Eigen::Index n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  return VecX::NullaryExpr(n, [&] { return std::uniform_real_distribution<double>(-1, 1)(random); });
}

VecX mapped(const Mat3& A, const VecX& x) {
  return (A * x.reshaped(3, x.size() / 3)).reshaped();
}

/// One tick of a body alone; the number of substeps, 0 when it was minimised.
int tick(soft::SoftBody& body, const Vec3& g, soft::SoftBodyState& state) {
  soft::Substepper* own = body.substepper();
  if (!own) {
    Stepper(body).step(h, g, state);
    return 0;
  }
  const double needed = own->needed(h, state);
  if (needed > own->allowed()) return -1;
  own->begin(state);
  for (int k = 0; k < static_cast<int>(needed); ++k)
    own->step(h / needed, body.weight(g, body.attached()), state);
  EXPECT_TRUE(own->finish(h / needed, state));
  return static_cast<int>(needed);
}

class Elastic : public testing::TestWithParam<Rung> {};
INSTANTIATE_TEST_SUITE_P(Rungs, Elastic, testing::ValuesIn(elastic_rungs()),
                         [](const auto& info) { return info.param.name(); });

TEST_P(Elastic, ForcesAndStiffnessAreDerivativesOfTheEnergy) {
  const Anatomy anatomy = anatomy_of(GetParam().mesh);
  const auto model = soft::make_elastic_model(describe(GetParam()), anatomy);
  const VecX& rest = model->rest();
  const Eigen::Index n = rest.size();
  const soft::BlockPattern pattern(model->connectivity());
  std::vector<Mat3> K(pattern.blocks());
  // Swollen, so that springs are in tension and nothing is projected; bent, so that bends store something.
  // Volume springs alone are never definite under pressure: with those at rest.
  const bool volume_springs =
      GetParam().model.name == "mass_spring" && GetParam().mesh == soft::MeshKind::tets;
  VecX x = rest;
  if (!volume_springs) x = 1.02 * rest + 1e-4 * random_vector(n, 3);
  const VecX dx = random_vector(n, 4);
  const double e = 1e-6;
  const auto gradient = [&](const VecX& at) {
    VecX g = VecX::Zero(n);
    model->add_gradient(at.data(), g.data());
    return g;
  };
  const VecX plus = x + e * dx, minus = x - e * dx;
  const double slope = (model->energy(plus.data()) - model->energy(minus.data())) / (2 * e);
  const VecX change = (gradient(plus) - gradient(minus)) / 2;
  EXPECT_NEAR(gradient(x).dot(dx), slope, 1e-6 * gradient(x).norm() * dx.norm() + change.norm() * dx.norm());
  pattern.gather(model->tangent(x.data()), 0, {}, K);
  VecX Kdx(n);
  pattern.multiply(K, dx.data(), Kdx.data());
  const VecX exact = (gradient(plus) - gradient(minus)) / (2 * e);
  EXPECT_LT((Kdx - exact).norm(), 1e-5 * exact.norm());
  // At rest the warped stiffness is the tangent.
  VecX warped(n);
  pattern.gather(model->tangent(rest.data()), 0, {}, K);
  pattern.multiply(K, dx.data(), Kdx.data());
  pattern.gather(model->warped_stiffness(rest.data()), 0, {}, K);
  pattern.multiply(K, dx.data(), warped.data());
  EXPECT_LT((Kdx - warped).norm(), 1e-9 * Kdx.norm());
}

TEST_P(Elastic, TraceAtRestIsThatOfTheStiffnessTurned) {
  const Rung& rung = GetParam();
  SoftDesc desc = describe(rung);
  if (rung.model.name == "fem_fibers") desc.material.fiber_stiffness = 5e4;
  desc.material.fiber_direction = {1, 2, -3};
  const auto model = soft::make_elastic_model(desc, anatomy_of(rung.mesh));
  const soft::BlockPattern pattern(model->connectivity());
  std::vector<Mat3> K(pattern.blocks());
  pattern.gather(model->warped_stiffness(model->rest().data()), 0, {}, K);
  double trace = 0;
  for (std::size_t i = 0; i < pattern.rows(); ++i) trace += K[pattern.diagonal(i)].trace();
  EXPECT_GT(trace, 0);
  EXPECT_NEAR(model->rest_trace(), trace, 1e-12 * trace);
}

TEST_P(Elastic, TurningAndMovingStoreNothing) {
  const auto model = soft::make_elastic_model(describe(GetParam()), anatomy_of(GetParam().mesh));
  const VecX& rest = model->rest();
  const Mat3 Q = Eigen::AngleAxisd(2, Vec3(1, -2, 3).normalized()).toRotationMatrix();
  VecX x = rest + 0.005 * random_vector(rest.size(), 1);
  const double stored = model->energy(x.data());
  EXPECT_NEAR(model->energy(rest.data()), 0, 1e-12 * stored);
  VecX turned = mapped(Q, x);
  for (Eigen::Index i = 0; i < turned.size() / 3; ++i) turned.segment<3>(3 * i) += Vec3(1, 2, 3);
  if (GetParam().model.name != "fem_linear") {
    EXPECT_NEAR(model->energy(turned.data()), stored, 1e-10 * stored);
  }
}

TEST_P(Elastic, HomogeneousStrainLeavesTheInsideInBalance) {
  const auto model = soft::make_elastic_model(describe(GetParam()), anatomy_of(GetParam().mesh));
  const VecX& rest = model->rest();
  Mat3 A = Mat3::Identity();
  A << 1.1, 0.02, 0.03, 0.01, 0.95, -0.02, 0.05, 0.04, 1.06;
  const VecX x = mapped(A, rest);
  VecX g = VecX::Zero(rest.size());
  model->add_gradient(x.data(), g.data());
  const auto extent = rest.reshaped(3, rest.size() / 3);
  const Vec3 lo = extent.rowwise().minCoeff(), hi = extent.rowwise().maxCoeff();
  int inside = 0;
  for (Eigen::Index i = 0; i < rest.size() / 3; ++i) {
    const Vec3 X = rest.segment<3>(3 * i);
    bool interior = true;
    for (int c = 0; c < 3; ++c)
      if (hi[c] > lo[c]) interior = interior && X[c] > lo[c] + 1e-9 && X[c] < hi[c] - 1e-9;
    if (!interior) continue;
    ++inside;
    EXPECT_LT(g.segment<3>(3 * i).norm(), 1e-10 * g.norm());
  }
  EXPECT_GT(inside, 0);
}

class Rungs : public testing::TestWithParam<Rung> {};
INSTANTIATE_TEST_SUITE_P(Ladder, Rungs, testing::ValuesIn(rungs()),
                         [](const auto& info) { return info.param.name(); });

TEST_P(Rungs, ConserveMomentum) {
  SoftDesc desc = describe(GetParam());
  desc.material.damping_mass = 0;
  const std::string& by = GetParam().integrator;
  desc.material.damping_stiffness =
      by == "explicit_euler" || by == "rk2" ? 1e-4 : 0;  // else they are refused
  soft::SoftBody body(desc, anatomy_of(GetParam().mesh));
  soft::SoftBodyState state = body.initial_state();
  state.motion.v = 0.3 * random_vector(state.motion.x.size(), 6);
  const auto momenta = [&] {
    Vec3 p = Vec3::Zero(), l = Vec3::Zero();
    for (Eigen::Index i = 0; i < body.nodes(); ++i) {
      const Vec3 m = body.node_mass()[i] * state.motion.v.segment<3>(3 * i);
      p += m;
      l += state.motion.x.segment<3>(3 * i).cross(m);
    }
    return std::pair(p, l);
  };
  const auto before = momenta();
  for (int i = 0; i < 20; ++i) ASSERT_GE(tick(body, Vec3::Zero(), state), 0);
  const auto after = momenta();
  EXPECT_LT((after.first - before.first).norm(), 1e-9 * body.total_mass());
  // Kick and drift: angular momentum too, of laws that turn freely.
  const bool turns = by == "symplectic_euler" || by == "verlet";
  if (turns && GetParam().model.name != "fem_linear") {
    EXPECT_LT((after.second - before.second).norm(), 1e-9 * body.total_mass());
  }
}

/// The rung with each element that it takes, and each solver with one integrator: they don't know of each
/// other.
std::vector<SoftDesc> variants(const Rung& rung) {
  const bool is_law = !rung.model.position_based && !rung.model.fabric;
  const bool with_all_solvers =
      rung.integrator == SoftDesc{}.configuration.integrator && !rung.model.position_based;
  std::vector<SoftDesc> out;
  for (const char* element : {"tet4", "tet10"}) {
    if (!is_law && element != SoftDesc{}.configuration.element) continue;
    for (const soft::SolverRow& solver : soft::solvers()) {
      if (!with_all_solvers && SoftDesc{}.configuration.solver != solver.name) continue;
      out.push_back(describe(rung));
      out.back().configuration.element = element;
      out.back().configuration.solver = solver.name;
    }
  }
  return out;
}

/// More nodes and elements than one thread takes at once.
Anatomy large_anatomy(soft::MeshKind mesh, const std::string& element) {
  if (mesh == soft::MeshKind::sheet) return make_sheet({0.1, 0.005, 0.1}, 0.005);
  if (mesh == soft::MeshKind::rope) return make_rope({0.3, 0.01, 0}, 0.01);
  if (element == "tet10") return kuhn_anatomy({4, 3, 2}, {0.1, 0.075, 0.05});
  return kuhn_anatomy({4, 4, 4}, {0.1, 0.1, 0.1});
}

TEST_P(Rungs, SameBitsForAnyNumberOfThreads) {
  for (const SoftDesc& desc : variants(GetParam())) {
    std::vector<soft::SoftBodyState> results;
    for (const std::size_t threads : {1u, 2u, 4u}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      soft::SoftBody body(desc, large_anatomy(GetParam().mesh, desc.configuration.element));
      soft::SoftBodyState state = body.initial_state();
      state.motion.v = 0.3 * random_vector(state.motion.x.size(), 6);
      for (int i = 0; i < 2; ++i) tick(body, gravity, state);
      results.push_back(state);
    }
    for (const soft::SoftBodyState& state : results) {
      EXPECT_EQ(state.motion.x, results[0].motion.x) << soft::in_words(desc);
      EXPECT_EQ(state.motion.v, results[0].motion.v) << soft::in_words(desc);
      EXPECT_EQ(state.mode, results[0].mode) << soft::in_words(desc);
      EXPECT_EQ(state.omega, results[0].omega) << soft::in_words(desc);
    }
  }
}

TEST_P(Rungs, NeverGainEnergyByThemselves) {
  soft::SoftBody body(describe(GetParam()), anatomy_of(GetParam().mesh));
  soft::SoftBodyState state = body.initial_state();
  state.motion.v = 0.5 * random_vector(state.motion.x.size(), 6);
  const auto energy = [&] {
    return body.potential().elastic_energy(state.motion.x) +
           soft::kinetic_energy(body.node_mass(), state.motion.v);
  };
  const double start = energy();
  for (int i = 0; i < 60; ++i) {
    ASSERT_GE(tick(body, Vec3::Zero(), state), 0);
    ASSERT_LE(energy(), 1.01 * start) << i;
  }
}

TEST(RungTable, RefusesWhatDoesNotGoTogetherAndSaysWhatDoes) {
  int refused = 0;
  for (const soft::ModelRow& model : soft::models())
    for (const soft::MeshKind mesh : {soft::MeshKind::tets, soft::MeshKind::sheet, soft::MeshKind::rope})
      for (const std::string& integrator : soft::integrators_for(soft::models()[0])) {
        const SoftDesc desc = describe({model, mesh, integrator});
        const auto meshes = meshes_of(model);
        const auto names = soft::integrators_for(model);
        const bool fits = std::count(meshes.begin(), meshes.end(), mesh) &&
                          std::count(names.begin(), names.end(), integrator);
        try {
          soft::SoftBody body(desc, anatomy_of(mesh));
          EXPECT_TRUE(fits) << model.name << " " << integrator;
        } catch (const InputError& error) {
          EXPECT_FALSE(fits) << error.what();
          EXPECT_NE(std::string(error.what()).find("allowed"), std::string::npos) << error.what();
          ++refused;
        }
      }
  EXPECT_GT(refused, 20);
}

/// Energy of the fabric's model at A·rest.
/// Of the small strain A − I and of its opposite, in the mean: what closed forms leave out is of odd order.
double stored(const SoftDesc& desc, const Anatomy& anatomy, const Mat3& A) {
  const auto model = soft::make_elastic_model(desc, anatomy);
  const VecX there = mapped(A, model->rest()), opposite = mapped(2 * Mat3::Identity() - A, model->rest());
  return (model->energy(there.data()) + model->energy(opposite.data())) / 2;
}

SoftDesc springs() {
  SoftDesc desc;
  desc.name = "fabric";
  desc.configuration.model = "mass_spring";
  desc.material.youngs_modulus = 1e5;
  desc.material.poisson_ratio = 0.3;
  return desc;
}

TEST(Springs, AreTheContinuumInHomogeneousStrain) {
  const SoftDesc desc = springs();
  const double E = desc.material.youngs_modulus, nu = desc.material.poisson_ratio, t = 0.002,
               area = 0.3 * 0.2, e = 1e-6;
  for (const double cell : {0.1, 0.05, 0.03}) {  // the last one's cells are not square
    const Anatomy sheet = make_sheet({0.3, t, 0.2}, cell);
    Mat3 A = Mat3::Identity();
    A(0, 0) += e;
    EXPECT_NEAR(stored(desc, sheet, A) / (0.5 * E * t / (1 - nu * nu) * e * e * area), 1, 1e-6) << cell;
    A = Mat3::Identity();
    A(2, 2) += e;
    EXPECT_NEAR(stored(desc, sheet, A) / (0.5 * E * t / (1 - nu * nu) * e * e * area), 1, 1e-6) << cell;
    A = Mat3::Identity();
    A(0, 2) += e;
    EXPECT_NEAR(stored(desc, sheet, A) / (0.5 * E * t / (2 * (1 + nu)) * e * e * area), 1, 1e-6) << cell;
  }
  const double d = 0.01;
  Mat3 A = Mat3::Identity();
  A(0, 0) += e;
  EXPECT_NEAR(stored(desc, make_rope({0.5, d, 0}, 0.02), A) / (0.5 * E * M_PI * d * d / 4 * e * e * 0.5), 1,
              1e-6);
}

TEST(Springs, AndVolumeSpringsMeetPoissonsRatio) {
  // Of a cube's dilation the lattice stores exactly what a solid of those constants does.
  SoftDesc desc = springs();
  for (const double nu : {0.3, 0.45}) {
    desc.material.poisson_ratio = nu;
    const soft::Lame c = soft::lame(desc.material.youngs_modulus, nu);
    const double e = 1e-6;
    const Mat3 A = (1 + e) * Mat3::Identity();
    const double expected = 0.5 * (9 * c.lambda + 6 * c.mu) * e * e * 1e-3;
    EXPECT_NEAR(stored(desc, kuhn_anatomy({3, 3, 3}, {0.1, 0.1, 0.1}), A) / expected, 1, 1e-6) << nu;
  }
}

TEST(Springs, BendAsPlatesAndRodsDo) {
  const SoftDesc desc = springs();
  const double E = desc.material.youngs_modulus, nu = desc.material.poisson_ratio, t = 0.002, radius = 0.5;
  // On a wide arc: chords shorten, so only the bends are asked, at constant angle per piece.
  const auto bent = [&](const Anatomy& anatomy) {
    SoftDesc soft = desc;
    soft.material.spring_stiffness = soft.material.shear_stiffness = 1e-9;
    const auto model = soft::make_elastic_model(soft, anatomy);
    VecX x = model->rest();
    for (Eigen::Index i = 0; i < x.size() / 3; ++i) {
      const double phi = x[3 * i] / radius;
      x[3 * i] = radius * std::sin(phi);
      x[3 * i + 1] += radius * (1 - std::cos(phi));
    }
    return model->energy(x.data());
  };
  const double D = E * t * t * t / (12 * (1 - nu * nu)), n = 50, inner = (n - 1) / n;
  EXPECT_NEAR(bent(make_sheet({0.5, t, 0.2}, 0.01)) / (0.5 * D / (radius * radius) * 0.5 * 0.2 * inner), 1,
              1e-3);
  const double EI = E * M_PI * std::pow(t, 4) / 64;
  EXPECT_NEAR(bent(make_rope({0.5, t, 0}, 0.01)) / (0.5 * EI / (radius * radius) * 0.5 * inner), 1, 1e-3);
}

/// A rope along x with its ends held, or only its first.
SoftDesc hung(const std::string& model, double k) {
  SoftDesc desc = springs();
  desc.configuration.model = model;
  desc.material.spring_stiffness = k;
  desc.material.bending_stiffness = 1e-12;
  desc.configuration.solver = "direct";
  desc.material.damping_mass = desc.material.damping_stiffness = 0;
  return desc;
}

TEST(Springs, HangAsAChainDoes) {
  // Nodes of mass m on springs k: the stretch is (mg/k)·N(N + 1)/2, less the half mass of the last node.
  const double k = 200, l = 0.5, d = 0.01;
  const std::uint32_t n = 10;
  SoftDesc desc = hung("mass_spring", k);
  desc.attach.push_back({Vec3(-l / 2, 0, 0), 0.001, 1e12});
  soft::SoftBody body(desc, make_rope({l, d, 0}, l / n));
  soft::SoftBodyState state = body.initial_state();
  Stepper(body).settle(Vec3(9.81, 0, 0), state);
  const double m = body.node_mass()[1];
  const double stretch = state.motion.x[3 * n] - state.motion.x[0] - l;
  EXPECT_NEAR(stretch, m * 9.81 / k * (n * (n + 1) / 2. - n / 2.), 1e-6);
}

/// Ten links of 0.12 on an arc whose ends are 1 apart.
Anatomy arc() {
  constexpr int n = 10;
  double low = 1e-3, high = 0.5;  // angle of a link
  for (int i = 0; i < 100; ++i) {
    const double theta = (low + high) / 2;
    (std::sin(n * theta / 2) / std::sin(theta / 2) * 0.12 > 1 ? low : high) = theta;
  }
  const double R = 0.06 / std::sin(low / 2);
  Anatomy out = make_rope({1.2, 0.01, 0}, 0.12);
  for (int i = 0; i <= n; ++i) {
    const double phi = (i - n / 2.) * low;
    out.tets.positions[static_cast<std::size_t>(i)] = R * Vec3(std::sin(phi), -std::cos(phi), 0);
  }
  return out;
}

TEST(Springs, SagAsADiscreteCatenary) {
  const Anatomy rope = arc();
  SoftDesc desc = hung("mass_spring", 1e6);
  desc.attach.push_back({rope.tets.positions.front(), 0.001, 1e12});
  desc.attach.push_back({rope.tets.positions.back(), 0.001, 1e12});
  soft::SoftBody body(desc, rope);
  soft::SoftBodyState state = body.initial_state();
  Stepper(body, {400, 1e-11, {2000, 1e-10}}).settle(gravity, state, 300, 1);
  const auto y = state.motion.x.reshaped(3, body.nodes()).row(1);
  EXPECT_NEAR(y[0] - y.minCoeff(), .293864249, 5e-5);
}

TEST(Explicit, KnowsItsLimit) {
  // Fixed-mesh values of the reference beam's 2/ω_max, ms: the fastest mode is local, so that what holds the
  // beam's end hardly changes it.
  struct Case {
    double nu, limit;
  };
  for (const Case& c : {Case{.3, 1.64856}, Case{.45, .94413}}) {
    SoftDesc desc;
    desc.name = "beam";
    desc.configuration.model = "fem_linear";
    desc.configuration.integrator = "verlet";
    desc.material.youngs_modulus = 3e5;
    desc.material.poisson_ratio = c.nu;
    desc.material.density = 1000;
    soft::SoftBody body(desc, kuhn_anatomy({8, 2, 2}, {0.4, 0.1, 0.1}));
    EXPECT_NEAR(2e3 / body.initial_state().omega, c.limit, 0.02 * c.limit);
  }
}

TEST(Explicit, NeedsMoreSubstepsWhenItGetsStiffer) {
  SoftDesc desc = springs();
  desc.configuration.integrator = "symplectic_euler";
  desc.configuration.model = "fem_neo_hookean";
  soft::SoftBody body(desc, kuhn_anatomy({3, 3, 3}, {0.1, 0.1, 0.1}));
  soft::SoftBodyState state = body.initial_state();
  const double at_rest = body.substepper()->needed(h, state);
  state.motion.x = mapped(Vec3(3, 0.3, 3).asDiagonal(), state.motion.x);
  EXPECT_FALSE(body.substepper()->finish(h / at_rest, state));
  EXPECT_GT(body.substepper()->needed(h, state), 1.5 * at_rest);
}

TEST(Xpbd, ConvergesToTheSameRestingShapeAsTheMinimiser) {
  SoftDesc desc = springs();
  desc.configuration.model = "xpbd";
  desc.configuration.substeps = 60;
  desc.material.damping_mass = 8;
  desc.configuration.solver = "direct";
  desc.material.youngs_modulus = 3e4;
  desc.attach.push_back({Vec3(0, 0.05, 0.05), 0.08, 1e8});
  soft::SoftBody body(desc, kuhn_anatomy({4, 2, 2}, {0.2, 0.1, 0.1}));
  soft::SoftBodyState still = body.initial_state(), moving = still;
  Stepper(body).settle(gravity, still);
  for (int i = 0; i < 300; ++i) tick(body, gravity, moving);
  const double sag = (still.motion.x - body.initial_state().motion.x).lpNorm<Eigen::Infinity>();
  EXPECT_GT(sag, 0.002);
  EXPECT_LT((moving.motion.x - still.motion.x).lpNorm<Eigen::Infinity>(), 0.05 * sag);
}

}  // namespace
}  // namespace prosector
