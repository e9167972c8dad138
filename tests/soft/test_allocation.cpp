// Nothing allocates within a step. This executable counts every malloc of its test's thread (operator new's
// and Eigen's end there), so it holds nothing else.

#include <gtest/gtest.h>
#include <tbb/global_control.h>

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
  explicit FixedStep(SoftBody& body)
      : body_(body), H_(body), solver_(make_solver(body.desc().solver)), state_(body.initial_state()) {
    for (VecX* v : {&x_, &b_, &dx_}) *v = VecX::Zero(3 * body.nodes());
  }
  void operator()() {
    constexpr double h = 1. / 60;
    for (int stage = 0; stage < body_.integrator().stages(); ++stage) {
      body_.begin_stage(stage, h, Vec3(0, -9.81, 0), state_);
      body_.initial_guess(h, state_, x_);
      for (int iteration = 0; iteration < 2; ++iteration) {
        body_.gradient(x_, b_);
        b_ = -b_;
        if (iteration == 0) {
          body_.assemble_roughly(x_);
        } else {
          body_.assemble(x_);
        }
        H_.update();
        dx_.setZero();
        solver_->solve(H_, b_, {}, dx_);
        x_ += dx_;
        energy_ = body_.energy(x_);
      }
      body_.finish_stage(stage, h, x_, state_);
    }
  }
  double energy() const { return energy_; }

 private:
  SoftBody& body_;
  BodyOperator H_;
  std::unique_ptr<LinearSolver> solver_;
  SoftBodyState state_;
  VecX x_, b_, dx_;
  double energy_ = 0;
};

class Allocation : public testing::TestWithParam<LawRow> {};
INSTANTIATE_TEST_SUITE_P(Table, Allocation, testing::ValuesIn(laws()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(Allocation, NoneWithinAStep) {
#ifndef PROSECTOR_COUNTS_ALLOCATIONS
  GTEST_SKIP() << "malloc is not ours to count here";
#endif
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  for (const IntegratorRow& integrator : integrators()) {
    for (const char* solver : {"cg", "multigrid"}) {
      SoftDesc desc;
      desc.model = GetParam().name;
      desc.integrator = integrator.name;
      desc.solver = solver;
      desc.attach.push_back({Vec3::Zero(), 0.05, 1e7});
      const long before = allocations;
      SoftBody body(desc, kuhn_anatomy({7, 7, 7}, Vec3(0.1, 0.1, 0.1)));
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

}  // namespace
}  // namespace prosector
