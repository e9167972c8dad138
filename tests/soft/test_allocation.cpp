// Nothing allocates within a step. This executable counts every malloc of its test's thread (operator new's
// and Eigen's end there), so it holds nothing else.

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "server/physics/mechanics/coupled/step_island.h"
#include "server/physics/mechanics/soft/implicit_stepper.h"
#include "server/physics/mechanics/soft/incremental_potential.h"
#include "server/physics/mechanics/soft/rungs.h"
#include "tests/soft/kuhn.h"
#include "tests/soft/print_rows.h"
#include "tests/soft/stepper.h"

namespace {
thread_local long allocations = 0;
}  // namespace

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define PROSECTOR_COUNTS_ALLOCATIONS 1
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void* malloc(std::size_t size) noexcept {
  ++allocations;
  return __libc_malloc(size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  ++allocations;
  return __libc_memalign(alignment, size);
}
}
#endif

namespace prosector {
namespace {

/// One Newton iteration a step, in vectors that are there beforehand.
class FixedStep {
 public:
  explicit FixedStep(soft::SoftBody& body)
      : body_(body),
        H_(body),
        solver_(soft::make_solver(body.desc().configuration.solver)),
        state_(body.initial_state()) {
    for (VecX* v : {&x_, &b_, &dx_}) *v = VecX::Zero(3 * body.nodes());
  }
  void operator()() {
    constexpr double h = 1. / 60;
    for (int stage = 0; stage < body_.stepper().integrator().stages(); ++stage) {
      body_.stepper().begin_stage(stage, h, Vec3(0, -9.81, 0), state_);
      body_.stepper().initial_guess(h, state_, x_);
      for (int iteration = 0; iteration < 2; ++iteration) {
        body_.potential().gradient(x_, b_);
        b_ = -b_;
        if (iteration == 0) {
          body_.potential().assemble_roughly(x_);
        } else {
          body_.potential().assemble(x_);
        }
        H_.update();
        dx_.setZero();
        solver_->solve(H_, b_, {}, dx_);
        x_ += dx_;
        energy_ = body_.potential().energy(x_);
      }
      body_.stepper().finish_stage(stage, h, x_, state_);
    }
  }
  double energy() const { return energy_; }

 private:
  soft::SoftBody& body_;
  BodyOperator H_;
  std::unique_ptr<soft::LinearSolver> solver_;
  soft::SoftBodyState state_;
  VecX x_, b_, dx_;
  double energy_ = 0;
};

class LawAllocation : public testing::TestWithParam<soft::LawRow> {};
INSTANTIATE_TEST_SUITE_P(Table, LawAllocation, testing::ValuesIn(soft::laws()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(LawAllocation, NoneWithinAStep) {
#ifndef PROSECTOR_COUNTS_ALLOCATIONS
  GTEST_SKIP() << "malloc is not ours to count here";
#endif
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  for (const soft::IntegratorRow& integrator : soft::integrators()) {
    for (const char* solver : {"cg", "multigrid"}) {
      SoftDesc desc;
      desc.configuration.model = GetParam().name;
      desc.configuration.integrator = integrator.name;
      desc.configuration.solver = solver;
      desc.attach.push_back({Vec3::Zero(), 0.05, 1e7});
      const long before = allocations;
      soft::SoftBody body(desc, kuhn_anatomy({7, 7, 7}, Vec3(0.1, 0.1, 0.1)));
      EXPECT_GT(allocations, before) << "the counter must see the constructor";
      FixedStep step(body);
      for (int i = 0; i < 3; ++i) step();
      const long start = allocations;
      for (int i = 0; i < 5; ++i) step();
      EXPECT_EQ(allocations - start, 0) << integrator.name << " " << solver;
      EXPECT_TRUE(std::isfinite(step.energy()));
    }
  }
}

/// A cube that a rigid body with another one on it presses and a hand's tie holds, or that nothing touches.
class PressedCube {
 public:
  PressedCube(const SoftDesc& desc, bool touched)
      : body_(desc, kuhn_anatomy({2, 2, 2}, Vec3(0.1, 0.1, 0.1))), state_(body_.initial_state()) {
    state_.asleep = false;
    island_.soft.push_back({0, &body_, &state_});
    if (!touched) return;
    coupled::RigidMember ball;
    ball.mass = 0.1;
    ball.inertia.setIdentity();
    ball.inertia *= 1e-4;
    ball.predicted.setZero();
    island_.rigid.push_back(ball);
    contact::Contact contact;
    contact.a = {contact::ContactSide::Kind::rigid, 0};
    contact.b = {contact::ContactSide::Kind::soft, 0, 1, {26}, {1}};
    contact.gap = -1e-4;
    contact.stiffness = 1e4;
    contact.friction = 0.3;
    island_.contacts.push_back(contact);
    ball.slot = 1;
    island_.rigid.push_back(ball);
    contact.a = {contact::ContactSide::Kind::rigid, 1};
    contact.b = {contact::ContactSide::Kind::rigid, 0};
    island_.contacts.push_back(contact);
    contact::Tie tie;
    tie.a = {contact::ContactSide::Kind::rigid, 0};
    tie.b = {contact::ContactSide::Kind::soft, 0, 1, {0}, {1}};
    tie.stiffness = 10;
    tie.max_force = 1;
    island_.ties.push_back(tie);
  }

  void tick() {
    for (coupled::RigidMember& ball : island_.rigid) ball.predicted << 0, -1e-3, 0, 0, 0, 0;
    stepper_.step(island_, 1. / 60, Vec3::Zero());
  }
  bool pressed() const { return !island_.contacts.empty() && island_.contacts.front().force > 0; }
  const VecX& positions() const { return state_.motion.x; }

 private:
  soft::SoftBody body_;
  soft::SoftBodyState state_;
  coupled::Island island_;
  coupled::IslandStepper stepper_;
};

/// Every method that a scene may name, each with the solvers that don't factor.
std::vector<SoftDesc> ways_to_step() {
  std::vector<SoftDesc> bodies;
  for (const soft::ModelRow& model : soft::models()) {
    if (!model.tets) continue;
    for (const std::string& integrator : soft::integrators_for(model))
      for (const char* solver : {"cg", "multigrid"}) {
        SoftDesc& desc = bodies.emplace_back();
        desc.configuration.model = model.name;
        desc.configuration.integrator = integrator;
        desc.configuration.solver = solver;
      }
  }
  return bodies;
}

TEST(Allocation, NoneInTicksOfAnIsland) {
#ifndef PROSECTOR_COUNTS_ALLOCATIONS
  GTEST_SKIP() << "malloc is not ours to count here";
#endif
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  for (const SoftDesc& desc : ways_to_step())
    for (const bool touched : {true, false}) {
      PressedCube cube(desc, touched);
      for (int i = 0; i < 3; ++i) cube.tick();
      const long start = allocations;
      for (int i = 0; i < 5; ++i) cube.tick();
      EXPECT_EQ(allocations - start, 0)
          << desc.configuration.model << " " << desc.configuration.integrator << " "
          << desc.configuration.solver << (touched ? ", touched" : ", alone");
      EXPECT_TRUE(cube.positions().allFinite());
      EXPECT_EQ(cube.pressed(), touched);
    }
}

}  // namespace
}  // namespace prosector
