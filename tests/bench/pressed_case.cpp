#include "tests/bench/pressed_case.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "server/physics/mechanics/soft/integrators/explicit_integrators.h"
#include "server/physics/mechanics/soft/soft_body.h"

namespace prosector {
namespace {

constexpr double pressing_s = 0.5, held_s = 1;
constexpr std::size_t last_ticks = 10;  // ticks over which the force is averaged

bool takes_substeps(const Rung& rung) {
  const auto& rows = soft::explicit_integrators();
  return rung.is_position_based() ||
         std::any_of(rows.begin(), rows.end(), [&](const auto& row) { return row.name == rung.integrator; });
}

template <const PressedBody& (*body)()>
void judge(ReportRow& row) {
  const double force = figure(row, "force_N");
  if (std::isfinite(force)) row["error_material"] = std::abs(force / body().force - 1);
}

template <const PressedBody& (*body)()>
TradeCase pressed(const char* name, const char* title, const std::vector<unsigned>& cells) {
  return {name,  title,       "error_material", "error of the static force", cells, nullptr, nullptr, {},
          false, judge<body>, &body()};
}

}  // namespace

PressedSpecimen::PressedSpecimen(const PressedBody& body, const SoftDesc& desc, double dt)
    : depth_(body.depth), dt_(dt), tissue_(body, desc, {.tick = dt}) {}

VecX PressedSpecimen::positions() const {
  return tissue_.simulation().soft_state(1).motion.x;
}

std::size_t PressedSpecimen::nodes() const {
  return static_cast<std::size_t>(tissue_.simulation().soft(1).node_mass().size());
}

StepFigures PressedSpecimen::step(double dt, const Vec3&) {
  if (dt != dt_) throw std::logic_error("the step must equal the simulation's tick");
  const double down = std::min(1.0, ++steps_ * dt / pressing_s);
  const StepReport& report = tissue_.press(depth_ * down);
  StepFigures figures;
  for (const BodyReport& body : report.bodies) {
    figures.residual = std::max(figures.residual, body.residual);
    figures.solver_iterations += body.solver_iterations;
    figures.converged = figures.converged && body.converged;
    figures.reset = figures.reset || body.reset;
    figures.reported = figures.reported || body.reset || !body.note.empty();
    if (!body.note.empty()) figures.note = body.note;
  }
  return figures;
}

std::unique_ptr<PressedSpecimen> make_pressed(const PressedBody& body, const Rung& rung, unsigned cells,
                                              double dt) {
  SoftDesc desc = pressed_desc(body, body.longest / cells);
  rung.apply_to(desc);
  if (takes_substeps(rung))
    desc.contact.points = ContactPoints::vertices;  // substepped methods support only vertex contacts
  return std::make_unique<PressedSpecimen>(body, desc, dt);
}

ReportRow measure_press(const PressedSpecimen& specimen, Runner& runner) {
  std::vector<double> forces;
  ReportRow row = ReportRow::object();
  if (!runner.run(pressing_s + held_s, [&](double) { forces.push_back(specimen.tissue().force()); }))
    return row;
  row["force_N"] = std::accumulate(forces.end() - last_ticks, forces.end(), 0.0) / last_ticks;
  return row;
}

const TradeCase& press_case() {
  static const TradeCase row = pressed<pressed_layer_body>(
      "press", "A ball is pressed 2 mm into a bonded layer of 20 mm (ν = 0.45)", {12, 18, 24});
  return row;
}

const TradeCase& organ_case() {
  static const TradeCase row =
      pressed<pressed_organ>("organ", "A ball is pressed 10 mm into an organ (ν = 0.45)", {10, 16, 20});
  return row;
}

}  // namespace prosector
