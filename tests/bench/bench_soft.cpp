#include <fmt/format.h>
#include <tbb/global_control.h>

#include <cmath>
#include <string>

#include "server/physics/soft/soft_body.h"
#include "tests/bench/stopwatch.h"
#include "tests/bench/subjects.h"
#include "tests/soft/kuhn.h"

namespace prosector {
namespace {

constexpr double h = 1. / 60;
const Vec3 gravity(0, -9.81, 0);

/// Of a liver's proportions, with about that many tetrahedra.
Anatomy box(unsigned tets) {
  const auto side = static_cast<std::uint32_t>(std::max(1.0, std::round(std::cbrt(tets / 6.0 / 1.5))));
  const std::uint32_t length = std::max(1u, tets / 6 / (side * side));
  return kuhn_anatomy({length, side, side}, Vec3(0.012 * length, 0.012 * side, 0.012 * side));
}

/// Turned by 0.3 rad and dented from above by up to a tenth of the size.
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

nlohmann::json measure(const std::string& model, const SoftBenchOptions& options) {
  SoftDesc desc;
  desc.name = "box";
  desc.model = model;
  SoftBody body(desc, box(options.tets));
  SoftBodyState state = body.initial_state();
  state.motion.x = pressed(state.motion.x);
  const Eigen::Index n = state.motion.x.size();
  body.begin_stage(0, h, gravity, state);
  // Alternating positions: nothing may be remembered from the last call.
  VecX places[2] = {state.motion.x, state.motion.x * 1.001}, out(n);
  std::size_t turn = 0;
  const auto elsewhere = [&]() -> const VecX& { return places[turn ^= 1]; };
  double sum = 0;
  nlohmann::json ms;
  ms["energy"] = median_ms(options.repeats, [&] { sum += body.energy(elsewhere()); });
  ms["gradient"] = median_ms(options.repeats, [&] { body.gradient(elsewhere(), out); });
  ms["assemble"] = median_ms(options.repeats, [&] { body.assemble(elsewhere()); });
  ms["multiply"] = median_ms(options.repeats, [&] { body.multiply(places[0].data(), out.data()); });
  ms["begin_stage"] = median_ms(options.repeats, [&] {
    state.motion.x = elsewhere();
    body.begin_stage(0, h, gravity, state);
  });
  ms["iteration"] = median_ms(options.repeats, [&] {
    const VecX& x = elsewhere();
    body.gradient(x, out);
    body.assemble(x);
    sum += body.energy(x);
  });
  if (!std::isfinite(sum)) throw std::runtime_error("the energy of " + model + " is not finite");
  return {{"model", model}, {"tets", body.elements()}, {"nodes", body.nodes()}, {"ms", ms}};
}

}  // namespace

nlohmann::json bench_soft(const SoftBenchOptions& options) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, options.threads);
  nlohmann::json rows = nlohmann::json::array();
  const char* const columns[] = {"energy", "gradient", "assemble", "begin_stage", "multiply", "iteration"};
  fmt::print("ms, {} thread(s); iteration: gradient, assemble and energy at one place\n{:<28}{:>8}{:>8}",
             options.threads, "model", "tets", "nodes");
  for (const char* column : columns) fmt::print("{:>12}", column);
  fmt::print("\n");
  for (const LawRow& law : laws()) {
    const nlohmann::json row = measure(law.name, options);
    fmt::print("{:<28}{:>8}{:>8}", law.name, row["tets"].get<std::size_t>(), row["nodes"].get<std::size_t>());
    for (const char* column : columns) fmt::print("{:>12.3f}", row["ms"][column].get<double>());
    fmt::print("\n");
    rows.push_back(row);
  }
  return rows;
}

}  // namespace prosector
