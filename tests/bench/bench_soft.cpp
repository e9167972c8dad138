#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "server/calibration/stopwatch.h"
#include "server/physics/mechanics/soft/implicit_stepper.h"
#include "server/physics/mechanics/soft/incremental_potential.h"
#include "server/physics/mechanics/soft/laws/constitutive_law.h"
#include "server/physics/mechanics/soft/make_model.h"
#include "server/physics/mechanics/soft/matrices/block_matrix.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/bench/subjects.h"
#include "tests/bench/text_table.h"
#include "tests/soft/kuhn.h"

namespace prosector {
namespace {

/// Returns the median duration of `repeats` calls of `f` in ms, after three calls to warm up.
template <class F>
double median_ms(int repeats, const F& f) {
  for (int i = 0; i < 3; ++i) f();
  std::vector<double> ms;
  for (int i = 0; i < repeats; ++i) {
    const double start = wall_ms();
    f();
    ms.push_back(wall_ms() - start);
  }
  return median(std::move(ms));
}

constexpr double h = 1. / 60;
const Vec3 gravity(0, -9.81, 0);

/// Returns a box of a liver's proportions with about that many tetrahedra.
Anatomy box(unsigned tets) {
  const auto side = static_cast<std::uint32_t>(std::max(1.0, std::round(std::cbrt(tets / 6.0 / 1.5))));
  const std::uint32_t length = std::max(1u, tets / 6 / (side * side));
  return kuhn_anatomy({length, side, side}, Vec3(0.012 * length, 0.012 * side, 0.012 * side));
}

/// Returns positions rotated by 0.3 rad and indented from above by up to a tenth of the size.
VecX pressed(const VecX& rest) {
  VecX x(rest.size());
  const double size = rest.maxCoeff();
  const Mat3 turned = Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for (Eigen::Index i = 0; i < rest.size(); i += 3) {
    Vec3 p = rest.segment<3>(i);
    const Vec3 from_hand = p - Vec3(size / 2, size / 2, size / 4);
    p[1] -= 0.1 * size * std::exp(-from_hand.squaredNorm() / (0.04 * size * size));
    x.segment<3>(i) = turned * p;
  }
  return x;
}

/// Returns the memory bandwidth of one core (read plus write) when copying more than the caches hold, GB/s.
/// It limits every pass with few operations per byte.
double copy_bandwidth(int repeats) {
  const std::vector<double> from(std::size_t{1} << 24, 1);  // 128 MiB
  std::vector<double> to(from.size());
  const double ms =
      median_ms(std::min(repeats, 11), [&] { std::copy(from.begin(), from.end(), to.begin()); });
  return 2 * 8e-6 * static_cast<double>(from.size()) / ms;
}

/// Returns the number of 3×3 blocks in the assembled matrix, both triangles.
std::size_t matrix_blocks(const soft::SoftBody& body) {
  return soft::BlockPattern(soft::make_elastic_model(body.desc(), body.anatomy())->connectivity()).blocks();
}

ReportRow measure(const std::string& model, const std::string& element, const SoftBenchOptions& options) {
  SoftDesc desc;
  desc.name = "box";
  desc.configuration.model = model;
  desc.configuration.element = element;
  soft::SoftBody body(desc, box(options.tets));
  soft::SoftBodyState state = body.initial_state();
  state.motion.x = pressed(state.motion.x);
  const Eigen::Index n = state.motion.x.size();
  soft::IncrementalPotential& potential = body.potential();
  body.stepper().begin_stage(0, h, gravity, state);
  // Alternate positions, so that nothing is cached from the last call.
  VecX places[2] = {state.motion.x, state.motion.x * 1.001}, out(n);
  std::size_t turn = 0;
  const auto elsewhere = [&]() -> const VecX& { return places[turn ^= 1]; };
  double sum = 0;
  ReportRow row = {{"model", model},
                   {"element", element},
                   {"integrator", desc.configuration.integrator},
                   {"solver", desc.configuration.solver},
                   {"tets", body.elements()},
                   {"nodes", body.nodes()},
                   {"dt", h},
                   {"threads", options.threads}};
  row["blocks"] = matrix_blocks(body);
  row["ms_energy"] = median_ms(options.repeats, [&] { sum += potential.energy(elsewhere()); });
  row["ms_gradient"] = median_ms(options.repeats, [&] { potential.gradient(elsewhere(), out); });
  row["ms_assemble"] = median_ms(options.repeats, [&] { potential.assemble(elsewhere()); });
  row["ms_begin_stage"] = median_ms(options.repeats, [&] {
    state.motion.x = elsewhere();
    body.stepper().begin_stage(0, h, gravity, state);
  });
  row["ms_multiply"] = median_ms(options.repeats, [&] { potential.multiply(places[0].data(), out.data()); });
  row["ms_iteration"] = median_ms(options.repeats, [&] {
    const VecX& x = elsewhere();
    potential.gradient(x, out);
    potential.assemble(x);
    sum += potential.energy(x);
  });
  row["ms_iteration_per_1000_tets"] =
      1e3 * figure(row, "ms_iteration") / static_cast<double>(body.elements());
  row["ms_multiply_per_1000_tets"] = 1e3 * figure(row, "ms_multiply") / static_cast<double>(body.elements());
  if (!std::isfinite(sum)) throw std::runtime_error("the energy of " + model + " is not finite");
  return row;
}

}  // namespace

Report bench_soft(const SoftBenchOptions& options) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, options.threads);
  fmt::print("ms, {} thread(s); iteration: gradient, assembly and energy at one position\n", options.threads);
  using enum Column::Kind;
  const TextTable table({{text, "model", "model", 28},
                         {text, "element", "element", 7},
                         {count, "tets", "tets", 8},
                         {count, "nodes", "nodes", 8},
                         {number, "ms_energy", "energy", 10},
                         {number, "ms_gradient", "gradient", 10},
                         {number, "ms_assemble", "assemble", 10},
                         {number, "ms_begin_stage", "begin_stage", 10},
                         {number, "ms_multiply", "multiply", 10},
                         {number, "ms_iteration", "iteration", 10},
                         {number, "ms_iteration_per_1000_tets", "per 1000", 10}});
  table.print_header();
  Report report("soft");
  for (const char* element : {"tet4", "tet10"})
    for (const soft::LawRow& law : soft::laws()) {
      report.add(measure(law.name, element, options));
      table.print(report.rows().back());
    }
  const double bandwidth = copy_bandwidth(options.repeats);
  fmt::print("copy bandwidth of one core: {:.3g} GB/s\n", bandwidth);
  report.note("gb_per_s_copy", bandwidth);
  return report;
}

}  // namespace prosector
