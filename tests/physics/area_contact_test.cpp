// Contacts that integrate the pressure over the area that touches.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/anatomy/embedding.h"
#include "common/error.h"
#include "server/physics/mechanics/contact/area_rule.h"
#include "server/physics/mechanics/contact/potentials.h"
#include "server/physics/mechanics/soft/elements/edge_nodes.h"
#include "server/physics/mechanics/soft/mesh_follower.h"
#include "server/physics/stations/touching/area_contacts.h"
#include "server/physics/stations/touching/surface_point.h"
#include "tests/physics/pressed_layer.h"
#include "tests/physics/scenes.h"
#include "tests/physics/under_ball.h"

namespace prosector::test {
namespace {

/// Sums f over the rule's points of a triangle, by their shares.
template <class F>
double integral(contact::Division division, const F& f) {
  double sum = 0;
  for (Eigen::Index k = 0; k < 3; ++k) sum += contact::corner_share(division) * f(Vec3(Vec3::Unit(k)));
  for (const contact::AreaPoint& p : contact::face_points(division)) sum += p.share * f(p.weights);
  return sum;
}

TEST(AreaRule, IsExactForQuadraticFunctions) {
  for (const contact::Division division :
       {contact::Division::whole, contact::Division::quarters, contact::Division::sixteenths}) {
    EXPECT_NEAR(integral(division, [](const Vec3&) { return 1; }), 1, 1e-14);
    EXPECT_NEAR(integral(division, [](const Vec3& w) { return w[0]; }), 1. / 3, 1e-14);
    EXPECT_NEAR(integral(division, [](const Vec3& w) { return w[1] * w[1]; }), 1. / 6, 1e-14);
    EXPECT_NEAR(integral(division, [](const Vec3& w) { return w[1] * w[2]; }), 1. / 12, 1e-14);
  }
}

TEST(AreaRule, CornersShareAnEvenPressure) {
  EXPECT_NEAR(integral(contact::Division::corners, [](const Vec3& w) { return w[0]; }), 1. / 3, 1e-14);
  EXPECT_TRUE(contact::face_points(contact::Division::corners).empty());
}

TEST(AreaRule, NumbersOfPointsDiffer) {
  std::uint32_t next = 0;
  for (const contact::Division division :
       {contact::Division::whole, contact::Division::quarters, contact::Division::sixteenths}) {
    EXPECT_EQ(contact::first_face_point(division), next);
    next += static_cast<std::uint32_t>(contact::face_points(division).size());
  }
  EXPECT_EQ(next, contact::most_face_points);
  EXPECT_EQ(contact::places_on_quarters().size(), contact::face_points(contact::Division::quarters).size());
  EXPECT_LT((contact::places_on_quarters().back() - Vec3::Constant(1. / 3)).norm(), 1e-15);
}

TEST(AreaRule, IsAsFineAsWhatPressesIsRound) {
  EXPECT_EQ(contact::division_for(1e-4, 0, false), contact::Division::corners);
  EXPECT_EQ(contact::division_for(1e-4, 0, true), contact::Division::whole);
  EXPECT_EQ(contact::division_for(1e-6, 2 / 0.01, false), contact::Division::whole);
  EXPECT_EQ(contact::division_for(4e-5, 2 / 0.01, false), contact::Division::quarters);
  EXPECT_EQ(contact::division_for(1e-4, 2 / 0.01, false), contact::Division::sixteenths);
}

// Energy, slope and share are derivatives of each other, and the energy is the mean over the area.
TEST(EvenSpring, IsTheMeanOverTheArea) {
  const contact::EvenSpring area{1, 0.3};
  constexpr double step = 1e-6;
  for (double g = -0.5; g < 0.5; g += 0.0501) {
    EXPECT_NEAR((area.energy(g + step) - area.energy(g - step)) / (2 * step), area.slope(g), 1e-8) << g;
    EXPECT_NEAR((area.slope(g + step) - area.slope(g - step)) / (2 * step), area.stiffness(g), 1e-8) << g;
    double mean = 0;
    constexpr int parts = 10000;
    for (int i = 0; i < parts; ++i) mean += std::min(0.0, g + 0.3 * ((2 * i + 1.0) / parts - 1)) / parts;
    EXPECT_NEAR(area.slope(g), mean, 1e-7) << g;
  }
}

TEST(EvenSpring, WithoutSpreadIsASpring) {
  const contact::EvenSpring point{1, 0};
  EXPECT_DOUBLE_EQ(point.slope(-0.2), -0.2);
  EXPECT_DOUBLE_EQ(point.energy(-0.2), 0.02);
  EXPECT_DOUBLE_EQ(point.stiffness(-0.2), 1);
  EXPECT_EQ(point.slope(0.2), 0);
  EXPECT_EQ(point.stiffness(0), 0);
}

SoftDesc tissue(const std::string& element) {
  SoftDesc out = block();
  out.configuration.element = element;
  out.contact.points = ContactPoints::surface;
  out.gravity = false;
  out.material.damping_mass = 0;
  return out;
}

Tissue tissue_of(const SoftDesc& desc) {
  return Tissue(0, std::make_unique<soft::SoftBody>(desc, make_block({0.1, 0.06, 0.1}, {3, 2, 3})), {});
}

// An even pressure on all faces balances itself, and each node has its share of it: of a quadratic face's
// corners none, of its middles a third.
TEST(SurfacePoint, EvenPressureLoadsNodesAsItMust) {
  for (const std::string element : {"tet4", "tet10"}) {
    const Tissue made = tissue_of(tissue(element));
    const TriangleMesh& surface = made.anatomy().surface;
    const auto nodes = static_cast<std::size_t>(made.solver->nodes());
    for (const contact::Division division :
         {contact::Division::whole, contact::Division::quarters, contact::Division::sixteenths}) {
      std::vector<double> load(nodes, 0);
      const auto add = [&](const contact::ContactSide& side, double share) {
        double sum = 0;
        for (std::size_t k = 0; k < side.nodes; ++k) {
          load[side.node[k]] += share * side.weight[k];
          sum += side.weight[k];
        }
        EXPECT_NEAR(sum, 1, 1e-14);
      };
      for (std::uint32_t k = 0; k < 3; ++k)
        add(surface_side(made, surface.triangles[0][k]), contact::corner_share(division));
      for (const contact::AreaPoint& p : contact::face_points(division))
        add(surface_side(made, 0, p.weights), p.share);
      const soft::EdgeNodes* edges = made.solver->follower().edge_nodes();
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = made.anatomy().embedding.rows[surface.triangles[0][k]].node[0],
                            b = made.anatomy().embedding.rows[surface.triangles[0][(k + 1) % 3]].node[0];
        EXPECT_NEAR(load[a], edges ? 0 : 1. / 3, 1e-14);
        if (edges) {
          EXPECT_NEAR(load[edges->find(a, b)], 1. / 3, 1e-14);
        }
      }
    }
  }
}

TEST(SurfacePoint, LiesWhereItsTriangleDoesAtRest) {
  for (const std::string element : {"tet4", "tet10"}) {
    const Tissue made = tissue_of(tissue(element));
    const TriangleMesh& surface = made.anatomy().surface;
    const Vec3 weights(0.2, 0.5, 0.3);
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
      Vec3 at = Vec3::Zero();
      for (std::size_t k = 0; k < 3; ++k)
        at += weights[static_cast<Eigen::Index>(k)] * surface.positions[surface.triangles[t][k]];
      EXPECT_LT((place_of(surface_side(made, t, weights), made) - at).norm(), 1e-15);
    }
  }
}

// The size is an element's, however finely the surface divides its faces.
TEST(SurfacePoint, ElementSizeIsNotTheSurfaces) {
  SoftDesc desc = tissue("tet10");
  Anatomy coarse = make_block({0.1, 0.1, 0.1}, {2, 2, 2}), fine = coarse;
  halve_surface(fine);
  const Tissue a(0, std::make_unique<soft::SoftBody>(desc, coarse), {}),
      b(0, std::make_unique<soft::SoftBody>(desc, fine), {});
  EXPECT_NEAR(element_size(a, 0), 0.05, 1e-12);
  for (std::uint32_t t = 0; t < 4; ++t) EXPECT_NEAR(element_size(b, t), 0.05, 1e-12);
}

// A surface triangle across the edge between two faces of elements has four corners, as one element has.
TEST(SurfacePoint, ElementSizeIsNotOfTwoFaces) {
  const Anatomy own = make_block({0.1, 0.1, 0.1}, {2, 2, 2});
  TriangleMesh across;  // a small triangle over each edge between cells of the top
  for (const double z : {-0.025, 0.025}) {
    const auto first = static_cast<std::uint32_t>(across.positions.size());
    for (const Vec3& at :
         {Vec3(-0.004, 0.05, z - 0.003), Vec3(-0.004, 0.05, z + 0.003), Vec3(0.004, 0.05, z)})
      across.positions.push_back(at);
    across.triangles.push_back({first, first + 1, first + 2});
  }
  const Tissue made(0, std::make_unique<soft::SoftBody>(tissue("tet4"), embed(own.tets, across).anatomy), {});
  for (std::uint32_t t = 0; t < across.triangles.size(); ++t)
    EXPECT_NEAR(element_size(made, t), 0.05, 1e-12) << t;
}

// Embedding leaves weights of rounding's size at nodes off the face.
TEST(SurfacePoint, ElementSizeIsNotToldByRounding) {
  SoftDesc desc = tissue("tet4");
  const Anatomy own = make_block({0.1, 0.1, 0.1}, {3, 3, 3});
  Anatomy embedded = embed(own.tets, own.surface).anatomy;
  for (SparseMap::Row& row : embedded.embedding.rows)
    for (double& weight : row.weight)
      if (std::abs(weight) < 1e-12) weight = 1e-17;
  const Tissue made(0, std::make_unique<soft::SoftBody>(desc, embedded), {});
  for (std::uint32_t t = 0; t < own.surface.triangles.size(); ++t)
    EXPECT_NEAR(element_size(made, t), 0.1 / 3, 1e-12);
}

// ---- Presses

constexpr double radius = 0.01, depth = 0.001, height = 0.02;  // m
constexpr double half_a_cell = 2;                              // radii of contact: a cell

struct Layer {
  explicit Layer(const std::string& element, ContactPoints contact, double poisson_ratio = 0.3) {
    SoftDesc layer;
    layer.name = "layer";
    layer.configuration.model = "fem_linear";
    layer.configuration.element = element;
    layer.contact.points = contact;
    layer.material.youngs_modulus = 5000;
    layer.material.poisson_ratio = poisson_ratio;
    layer.gravity = false;
    layer.material.damping_mass = layer.material.damping_stiffness = 0;
    layer.configuration.newton_iterations = 8;
    layer.configuration.solver_iterations = 300;
    layer.configuration.solver_tolerance = 1e-4;
    layer.geometry.cell = layer.geometry.surface_cell = cell;
    layer.attach = {bonded_below(height)};
    SceneDesc scene = under_ball(layer, radius, {0, radius + 1e-4, 0});
    scene.tick_rate = 1;
    CompileOptions options;
    options.threads = 1;
    options.anatomy = [](const SoftDesc&) -> std::optional<Anatomy> {
      return pressed_layer(height, 2.5 * cell, cell);
    };
    simulation.emplace(scene, options);
  }

  /// Returns the ball's force, N, where it has been pressed at (x, z) for some ticks.
  double press(double x, double z, int ticks) {
    run(*simulation, ticks, ball_at({x, radius - depth, z}));
    return pressing_force(*simulation);
  }

  static inline const double cell = half_a_cell * std::sqrt(radius * depth);
  std::optional<Simulation> simulation;
};

struct Range {
  double least = 1e300, most = 0;
  void add(double x) {
    least = std::min(least, x);
    most = std::max(most, x);
  }
};

// Wherever the ball is over a cell, it meets the same: with vertices as contacts the most is six times the
// least. 0.02661 N is the finite layer's, from a table of converged values.
TEST(AreaContact, ForceIsRightWhereverVerticesAre) {
  Range forces;
  for (const auto& [x, z] : {std::pair(0.0, 0.0), {0.5, 0.5}, {0.33, 0.66}, {0.25, 0.1}, {0.75, 0.0}}) {
    Layer layer("tet4", ContactPoints::surface);
    forces.add(layer.press(x * Layer::cell, z * Layer::cell, 5) / 0.02661);
  }
  EXPECT_GT(forces.least, 0.9);
  EXPECT_LT(forces.most, 1.1);
}

TEST(AreaContact, QuadraticElementsAreRight) {
  Layer layer("tet10", ContactPoints::surface, 0.45);
  EXPECT_NEAR(layer.press(0, 0, 4) / 0.03128, 1, 0.08);
}

// Sliding over a cell in steps of a fortieth, the force hardly changes from step to step.
TEST(AreaContact, ForceIsSmoothWhileSliding) {
  Layer layer("tet4", ContactPoints::surface);
  double last = layer.press(0, 0.2 * Layer::cell, 5);
  for (double x = 0.025; x <= 1; x += 0.025) {
    const double force = layer.press(x * Layer::cell, 0.2 * Layer::cell, 1);
    EXPECT_NEAR(force / last, 1, 0.02) << x;
    last = force;
  }
}

// ---- Exchange

Vec3 momentum(const Simulation& simulation, BodyId soft) {
  const VecX& mass = simulation.soft(soft).node_mass();
  return simulation.soft_state(soft).motion.v.reshaped(3, mass.size()) * mass;
}

Vec3 spin(const Simulation& simulation, BodyId soft) {
  const VecX& mass = simulation.soft(soft).node_mass();
  const soft::SoftBodyState& state = simulation.soft_state(soft);
  Vec3 sum = Vec3::Zero();
  for (Eigen::Index i = 0; i < mass.size(); ++i)
    sum += mass[i] * state.motion.x.segment<3>(3 * i).cross(Vec3(state.motion.v.segment<3>(3 * i)));
  return sum;
}

// What a driven ball gives the block, by the contacts' impulses, is what the block got, with its moment about
// the origin, where all presses go through one small spot.
TEST(AreaContact, TissueGetsTheImpulseAndItsMoment) {
  for (const std::string element : {"tet4", "tet10"}) {
    SceneDesc scene;
    scene.gravity = Vec3::Zero();
    scene.soft = {tissue(element)};
    scene.soft[0].configuration.newton_iterations = 30;
    scene.soft[0].configuration.solver_iterations = 400;
    scene.soft[0].configuration.solver_tolerance = 1e-9;
    scene.soft[0].material.damping_stiffness = 0;
    scene.rigid = {part_body("ball", "sphere", {0.04, 0, 0}, {0.021, 0.0805, 0.013})};
    scene.rigid[0].fixed = true;
    scene.rigid[0].contact.friction = 0;
    Simulation simulation(scene, options());
    TickInput input;
    input.kinematic_targets.push_back({0, {{0.021, 0.078, 0.013}, Quat::Identity()}});
    simulation.step(input);
    ASSERT_EQ(simulation.exchanges().size(), 1U);
    const Exchange touch = simulation.exchanges()[0];
    EXPECT_GT(touch.points, 3U);
    const Vec3 given = (touch.b == 0 ? 1 : -1) * touch.impulse, got = momentum(simulation, 1);
    EXPECT_GT(got.norm(), 1e-3);
    EXPECT_LT((given - got).norm(), 1e-5 * got.norm()) << element;
    // A ball without friction: all of it goes through its middle.
    const Vec3 middle(0.021, 0.078, 0.013);
    EXPECT_LT((spin(simulation, 1) - middle.cross(got)).norm(), 0.02 * (middle.cross(got)).norm()) << element;
  }
}

// A block that rests on a table over its area sleeps there.
TEST(AreaContact, WhatRestsSleeps) {
  SceneDesc scene;
  scene.rigid = {table()};
  scene.soft = {block()};
  scene.soft[0].contact.points = ContactPoints::surface;
  Simulation simulation(scene, options());
  run(simulation, 300);
  EXPECT_TRUE(simulation.asleep(1));
}

// One degree below the angle of friction a block of quadratic elements, whose faces' middles touch too, holds
// on a table that keeps it awake.
TEST(AreaContact, FrictionHoldsWithoutCreep) {
  SceneDesc scene;
  scene.rigid = {table()};
  scene.soft = {block()};
  scene.soft[0].contact.points = ContactPoints::surface;
  scene.soft[0].configuration.element = "tet10";
  scene.soft[0].geometry.cell = scene.soft[0].geometry.surface_cell = 0.03;
  scene.soft[0].material.youngs_modulus = 2e4;
  const double angle =
      std::atan(std::sqrt(scene.soft[0].contact.friction * scene.rigid[0].contact.friction)) -
      std::numbers::pi / 180;
  scene.gravity = {9.81 * std::sin(angle), -9.81 * std::cos(angle), 0};
  Simulation simulation(scene, options());
  TickInput input;
  input.kinematic_targets.push_back({0, {{0, -0.05, 0}, Quat::Identity()}});
  const auto place = [&] {
    const auto nodes = simulation.soft_state(1).motion.x.reshaped(3, simulation.soft(1).nodes());
    return Vec3(nodes.rowwise().mean());
  };
  run(simulation, 60, input);
  const double from = place().x();
  run(simulation, 180, input);
  EXPECT_FALSE(simulation.asleep(1));
  EXPECT_LT(std::abs(place().x() - from), 1e-4);
}

// A ball of 3 mm and 20 g, which weighs more than a dent of its size bears, stays out of cells of 6 mm.
TEST(AreaContact, WhatIsSmallAndHeavyStaysOutside) {
  SceneDesc scene;
  scene.rigid = {table(), part_body("tip", "sphere", {0.006, 0, 0}, {0.002, 0.0340, 0.001})};
  scene.rigid[1].material.mass = 0.02;
  scene.soft = {block()};
  scene.soft[0].contact.points = ContactPoints::surface;
  scene.soft[0].geometry.size = {0.06, 0.03, 0.06};
  scene.soft[0].geometry.cell = scene.soft[0].geometry.surface_cell = 0.006;
  scene.soft[0].pose.p = {0, 0.015, 0};
  Simulation simulation(scene, options());
  run(simulation, 90);
  for (const Exchange& touch : simulation.exchanges()) {
    if (touch.a != 1 && touch.b != 1) continue;
    EXPECT_GT(touch.depth, 0);
    EXPECT_LT(touch.depth, 0.003);
  }
  EXPECT_LT(simulation.rigid_state(1).linear_velocity.norm(), 0.02);
}

TEST(AreaContact, IsForSolidsOnly) {
  SceneDesc scene;
  scene.soft = {block()};
  scene.soft[0].contact.points = ContactPoints::surface;
  scene.soft[0].configuration.model = "xpbd";
  EXPECT_THROW(Simulation(scene, options()), InputError);
  scene.soft[0] = block();
  scene.soft[0].contact.points = ContactPoints::surface;
  scene.soft[0].contact.collision = Fidelity::sphere;
  EXPECT_THROW(Simulation(scene, options()), InputError);
}

TEST(AreaContact, GoesOnFromACheckpoint) {
  SceneDesc scene;
  scene.rigid = {table(), part_body("ball", "sphere", {0.04, 0, 0}, {0.01, 0.085, 0})};
  scene.soft = {block()};
  scene.soft[0].contact.points = ContactPoints::surface;
  Simulation simulation(scene, options()), other(scene, options());
  run(simulation, 40);
  other.restore(simulation.checkpoint());
  EXPECT_EQ(simulation.state_hash(), other.state_hash());
  run(simulation, 20);
  run(other, 20);
  EXPECT_EQ(simulation.state_hash(), other.state_hash());
}

}  // namespace
}  // namespace prosector::test
