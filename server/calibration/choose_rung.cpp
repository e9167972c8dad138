#include "server/calibration/choose_rung.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "common/error.h"
#include "common/percent_text.h"
#include "server/physics/mechanics/soft/base/find_row.h"
#include "server/physics/mechanics/soft/rungs.h"

namespace prosector {
namespace {

constexpr const char* usual_models[] = {"xpbd", "mass_spring", "fem_corotational", "fem_neo_hookean"};
constexpr const char* usual_solvers[] = {"cg", "multigrid"};
constexpr int fineness_steps = 16;      // steps from the coarsest mesh measured to the finest
constexpr double beyond_the_table = 2;  // limit of fineness, over that of the table's finest mesh
constexpr double cell_quantum = 1e-4;   // m
constexpr double least_cell = 5e-4;
constexpr double locking_ratio =
    0.45;  // above this Poisson ratio linear tetrahedra err by half or more on any affordable mesh (locking)

struct Effort {
  int newton, solver;
  double tolerance;
};
constexpr Effort cg_efforts[] = {{1, 20, 1e-2}, {3, 60, 1e-3}};
constexpr Effort multigrid_efforts[] = {{1, 10, 1e-2}, {3, 30, 1e-3}};
constexpr Effort direct_efforts[] = {{1, 60, 1e-3}, {3, 60, 1e-3}};
constexpr int substeps[] = {10, 20, 50};

std::span<const Effort> efforts_of(const std::string& solver) {
  if (solver == "direct") return direct_efforts;
  if (solver == "multigrid") return multigrid_efforts;
  return cg_efforts;
}

std::vector<unsigned> resolutions(const std::string& element, double ratio) {
  if (element == "tet10") return {4, 8, 12};
  if (ratio > locking_ratio) return {8, 12};  // a finer mesh would lock, too: its cost is of no use
  return {8, 12, 16};
}

void add_rungs(const std::string& model, const std::string& element, const std::string& solver,
               std::vector<Rung>& out) {
  Rung rung;
  rung.model = model;
  rung.element = element;
  rung.integrator = SoftDesc{}.configuration.integrator;
  rung.solver = solver;
  for (const Effort& effort : efforts_of(solver)) {
    rung.newton_iterations = effort.newton;
    rung.solver_iterations = effort.solver;
    rung.solver_tolerance = effort.tolerance;
    out.push_back(rung);
  }
}

void add_substepped(const std::string& model, std::vector<Rung>& out) {
  Rung rung;
  rung.model = model;
  rung.integrator = SoftDesc{}.configuration.integrator;
  rung.solver = SoftDesc{}.configuration.solver;
  for (const int n : substeps) {
    rung.substeps = n;
    out.push_back(rung);
  }
}

/// Returns whether the material has fibres or relaxation, which only constitutive laws model.
bool needs_a_law(const SoftDesc& desc) {
  return desc.material.fiber_stiffness > 0 || !desc.material.relaxation.empty();
}

/// A candidate rung at one resolution.
struct Option {
  Rung rung;
  double cell;
  Prospect expected;
  std::vector<ActError> acts;
};

/// Rounds the cell size down to whole tenths of a millimetre; not below `least_cell`.
double rounded(double cell) {
  return std::max(std::floor(cell / cell_quantum * (1 + 1e-9)) * cell_quantum, least_cell);
}

class Options {
 public:
  Options(const SoftDesc& desc, const RungTable& table, const BodyGeometry& mesh, double mesh_cell,
          double largest_cell, const KnownErrors& known)
      : desc_(desc),
        table_(table),
        mesh_(mesh),
        mesh_cell_(mesh_cell),
        largest_cell_(largest_cell),
        known_(known) {
    for (const Rung& rung : candidates(desc)) add(rung);
  }
  const std::vector<Option>& all() const { return all_; }

 private:
  void add(const Rung& rung) {
    if (desc_.choice.fixed.cell) return add(rung, mesh_cell_);
    const auto [coarsest, finest] = table_.measured_fineness(rung, desc_.material.poisson_ratio);
    double last = 0;
    // The table's errors don't apply to meshes finer than its finest; errors on the body itself may.
    const double last_fineness = (known_.on_the_body ? beyond_the_table : 1) * finest;
    for (int k = 0; k <= fineness_steps; ++k) {
      const double fineness = coarsest * std::pow(last_fineness / coarsest, double(k) / fineness_steps);
      const double cell = rounded(std::min(largest_cell_, mesh_cell_ * mesh_.fineness() / fineness));
      if (cell != last) add(rung, cell);
      last = cell;
    }
  }

  void add(const Rung& rung, double cell) {
    BodyGeometry body = mesh_;
    body.elements *= std::pow(mesh_cell_ / cell, 3);
    auto expected = table_.prospect(rung, desc_.material.poisson_ratio, body, desc_.choice.fixed.model);
    if (!expected)
      throw std::logic_error(fmt::format(
          "the server's table of measured costs and errors has no entry for the model configuration {}, {}",
          rung.model, rung.element));
    std::vector<ActError> acts;
    if (known_.on_the_body) acts = known_.on_the_body(rung.model, rung.element, cell);
    const double of_the_way =
        acts.empty() ? known_.untried_error_ratio * (expected->error - expected->drift) : worst(acts).error;
    expected->error = of_the_way + expected->drift;
    all_.push_back({rung, cell, *expected, std::move(acts)});
  }

  const SoftDesc& desc_;
  const RungTable& table_;
  const BodyGeometry& mesh_;
  double mesh_cell_, largest_cell_;
  const KnownErrors& known_;
  std::vector<Option> all_;
};

/// Finds the allowed option of the least `cost`; null: none is allowed.
template <class Allowed, class Cost>
const Option* least(const std::vector<Option>& options, const Allowed& allowed, const Cost& cost) {
  const Option* best = nullptr;
  for (const Option& o : options)
    if (allowed(o) && (!best || cost(o) < cost(*best))) best = &o;
  return best;
}

bool enough(const SoftDesc& desc, const Prospect& expected) {
  return desc.choice.accuracy ? 100 * expected.error <= desc.choice.accuracy.value
                              : expected.ms <= desc.choice.budget.value;
}

}  // namespace

std::vector<Rung> candidates(const SoftDesc& desc) {
  std::vector<std::string> models{std::begin(usual_models), std::end(usual_models)};
  std::vector<std::string> elements = {"tet4", "tet10"};
  std::vector<std::string> solvers{std::begin(usual_solvers), std::end(usual_solvers)};
  if (desc.choice.fixed.model) models = {desc.configuration.model};
  if (desc.choice.fixed.element) elements = {desc.configuration.element};
  if (desc.choice.fixed.solver) solvers = {desc.configuration.solver};
  std::vector<Rung> out;
  for (const std::string& model : models) {
    const soft::ModelRow& row = soft::find_row(prosector::soft::models(), "model", model);
    if (!desc.choice.fixed.model && needs_a_law(desc) && (row.position_based || row.fabric)) continue;
    if (row.position_based) {
      if (!desc.choice.fixed.solver && elements.front() == "tet4") add_substepped(model, out);
      continue;
    }
    for (const std::string& element : elements) {
      if (element == "tet10" && row.fabric) continue;
      for (const std::string& solver : solvers) add_rungs(model, element, solver, out);
    }
  }
  if (out.empty())
    throw InputError(fmt::format(
        "soft body \"{}\": no configuration combines model \"{}\", element \"{}\" and solver "
        "\"{}\"; omit one of these keys",
        desc.name, desc.configuration.model, desc.configuration.element, desc.configuration.solver));
  return out;
}

std::vector<RungTrial> trials_for(const SoftDesc& desc) {
  const double ratio = table_ratio(desc.material.poisson_ratio);
  std::vector<RungTrial> out;
  for (const Rung& rung : candidates(desc))
    for (const unsigned cells : resolutions(rung.element, ratio)) out.push_back({rung, ratio, cells});
  return out;
}

Choice choose_rung(const SoftDesc& desc, const RungTable& table, const BodyGeometry& mesh, double mesh_cell,
                   double largest_cell, const KnownErrors& known) {
  const Options options(desc, table, mesh, mesh_cell, largest_cell, known);
  const auto error = [](const Option& o) { return o.expected.error; };
  const auto ms = [](const Option& o) { return o.expected.ms; };
  const auto fits = [&](const Option& o) { return enough(desc, o.expected); };
  const auto any = [](const Option&) { return true; };
  const Option* best =
      desc.choice.accuracy ? least(options.all(), fits, ms) : least(options.all(), fits, error);
  const bool good_enough = best != nullptr;
  if (!best) best = desc.choice.accuracy ? least(options.all(), any, error) : least(options.all(), any, ms);
  return {desc.name, best->rung, best->cell, desc.geometry.grade, best->expected, good_enough, best->acts};
}

bool serves_better(const SoftDesc& desc, const Choice& one, const Choice& other) {
  if (one.good_enough != other.good_enough) return one.good_enough;
  const bool by_cost = static_cast<bool>(desc.choice.accuracy) == one.good_enough;
  return by_cost ? one.expected.ms < other.expected.ms : one.expected.error < other.expected.error;
}

void adopt(const Choice& choice, SoftDesc& desc) {
  choice.rung.apply_to(desc);
  desc.geometry.cell = choice.cell;
  desc.geometry.grade = choice.grade;
}

std::string in_words(const std::vector<ActError>& acts) {
  std::string out;
  for (const ActError& act : acts)
    out += (out.empty() ? "" : ", ") + (act.error < collapsed
                                            ? fmt::format("{} {}", act.act, percent_text(act.error))
                                            : act.act + " it collapses");
  return out;
}

std::string explain(const Choice& choice, const SoftDesc& desc) {
  SoftDesc chosen = desc;
  adopt(choice, chosen);
  const std::string asked = desc.choice.accuracy ? fmt::format("accuracy {} %", desc.choice.accuracy.value)
                                                 : fmt::format("budget {} ms", desc.choice.budget.value);
  std::string line = fmt::format(
      "{} requested, chosen configuration: {}, cell {:.1f} mm{}; expected error {}, expected cost {:.2g} ms "
      "per frame",
      asked, soft::in_words(chosen), 1e3 * choice.cell,
      choice.grade == Grading::rims ? ", with smaller elements at the rims of the attached regions" : "",
      percent_text(choice.expected.error), choice.expected.ms);
  if (!choice.acts.empty()) line += "; on this body: " + in_words(choice.acts);
  if (!choice.good_enough && desc.choice.accuracy)
    line += fmt::format(
        "; no configuration is accurate enough: the most accurate one misses the requested accuracy by {}",
        percent_text(choice.expected.error - 0.01 * desc.choice.accuracy.value));
  if (!choice.good_enough && desc.choice.budget)
    line += fmt::format("; no configuration is fast enough: the fastest one exceeds the budget by {:.2g} ms",
                        choice.expected.ms - desc.choice.budget.value);
  if (table_ratio(desc.material.poisson_ratio) < desc.material.poisson_ratio)
    line += fmt::format(
        "; the configurations were measured at a Poisson ratio of {}, but this body has {}: expect a larger "
        "error",
        table_ratio(desc.material.poisson_ratio), desc.material.poisson_ratio);
  return line;
}

}  // namespace prosector
