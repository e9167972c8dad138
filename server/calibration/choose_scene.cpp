#include "server/calibration/choose_scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "common/error.h"
#include "server/calibration/own_errors.h"
#include "server/calibration/rung_json.h"
#include "server/calibration/table_file.h"
#include "server/physics/mechanics/soft/rungs.h"
#include "server/physics/stations/compile/sources.h"

namespace prosector {
namespace {

constexpr int most_meshes = 6;           // meshes tried to match the expected number of elements
constexpr double same_cell = 0.03;       // cell sizes that differ by a smaller fraction count as equal
constexpr double cells_across = 1. / 3;  // of the thickness: the coarsest cell tried
constexpr double too_coarse = 0.7;       // of a cell size that gave no mesh: the next size tried
constexpr int most_attempts = 12;        // trials of models and elements on a body
constexpr int most_proofs = 4;           // verifications of a choice; each takes seconds to minutes
// Assumed error of models and elements not tried yet, over that of the table's beam. The first value is far
// lower, so that those are tried that suit this body better than a beam; the second assumes equal errors.
constexpr double untried_error_ratios[] = {0.25, 1};
constexpr std::size_t progress_lines = 8;

void say(const ChoiceOptions& options, const std::string& line) {
  if (options.sources.progress) options.sources.progress(line);
}

/// Measures the trials of `wanted` that the table lacks. Returns whether there was any.
bool complete(RungTable& table, const std::vector<RungTrial>& wanted, const ChoiceOptions& options) {
  std::vector<RungTrial> missing;
  for (const RungTrial& trial : wanted)
    if (!table.find(trial) && std::find(missing.begin(), missing.end(), trial) == missing.end())
      missing.push_back(trial);
  if (missing.empty()) return false;
  say(options,
      fmt::format(
          "measuring cost and error of {} model configurations on this machine; the results are cached",
          missing.size()));
  const std::size_t stride = std::max<std::size_t>(1, missing.size() / progress_lines);
  std::size_t disturbed = 0;
  for (std::size_t i = 0; i < missing.size(); ++i) {
    if (i % stride == 0)
      say(options, fmt::format("{} of {}: {}, {} cells along a beam", i + 1, missing.size(),
                               missing[i].rung.name(), missing[i].cells));
    table.add(missing[i], options.measure(missing[i]));
    if (table.rows().back().figures.share < least_share) ++disturbed;
  }
  if (disturbed > 0)
    say(options,
        fmt::format("{} of {} model configurations were measured while other programs used the processor: "
                    "their cost may be overestimated; they will be measured again at the next start",
                    disturbed, missing.size()));
  return true;
}

/// Adds the rows that another run wrote while this one measured.
void add_missing(const RungTable& other, RungTable& table) {
  for (const RungTable::Row& row : other.rows())
    if (!table.find(row.trial)) table.add(row.trial, row.figures);
}

RungTable table_for(const SceneDesc& scene, const ChoiceOptions& options) {
  std::vector<RungTrial> wanted;
  for (const SoftDesc& desc : scene.soft) {
    if (!chosen_by_need(desc)) continue;
    for (RungTrial& trial : trials_for(desc)) wanted.push_back(std::move(trial));
  }
  RungTable table;
  if (!options.table_file.empty()) {
    FoundTable found = read_table(options.table_file, options.machine);
    if (!found.error.empty())
      say(options, fmt::format("{} {}: measuring again", options.table_file.string(), found.error));
    table = std::move(found.table);
  }
  if (!complete(table, wanted, options) || options.table_file.empty()) return table;
  add_missing(read_table(options.table_file, options.machine).table, table);
  if (!write_table(options.table_file, options.machine, table))
    say(options, fmt::format("the cache {} of measured configurations cannot be written: they will be "
                             "measured again at the next start",
                             options.table_file.string()));
  return table;
}

/// Returns the grading of this name. Throws InputError for another name.
Grading grading_of(std::string_view name) {
  const auto found = std::find(grading_names.begin(), grading_names.end(), name);
  if (found == grading_names.end())
    throw InputError(
        fmt::format("journal: grade is \"{}\"; allowed: {}", name, fmt::join(grading_names, ", ")));
  return static_cast<Grading>(found - grading_names.begin());
}

/// Checks that a choice is within the ranges that the scene file's fields must meet.
void check(const Choice& c) {
  const auto within = [](double x, double low, double high) { return x >= low && x <= high; };
  const Rung& r = c.rung;
  if (!within(r.newton_iterations, 1, 100) || !within(r.solver_iterations, 1, 100000) ||
      !within(r.solver_tolerance, 1e-300, 0.5) || !within(r.substeps, 1, 1000) || !within(c.cell, 5e-4, 1) ||
      !within(c.expected.error, 0, 1e12) || !within(c.expected.ms, 0, 1e12))
    throw InputError(
        fmt::format("journal: the stored model configuration of soft body \"{}\" has a value out of range; "
                    "the journal is damaged",
                    c.body));
}

/// Returns the sources without the callback for progress: notes on a mesh are reported when it is used.
CompileOptions quiet(const ChoiceOptions& options) {
  CompileOptions sources = options.sources;
  sources.progress = {};
  return sources;
}

BodyGeometry mesh_of(const SoftDesc& desc, const SceneDesc& scene, const ChoiceOptions& options) {
  const Anatomy anatomy = soft_anatomy(desc, scene, quiet(options));
  if (soft::mesh_kind(anatomy) != soft::MeshKind::tets)
    throw InputError(
        fmt::format("soft body \"{}\": accuracy and budget need tetrahedra; for sheets and ropes, give model "
                    "and cell instead",
                    desc.name));
  return geometry_of(anatomy.tets);
}

/// Chooses a rung with the mesh of the scene's cell size, then with the mesh of the chosen cell size, until
/// both agree.
class Chooser {
 public:
  Chooser(const SceneDesc& scene, const SoftDesc& desc, const RungTable& table, const ChoiceOptions& options)
      : scene_(scene),
        desc_(desc),
        table_(table),
        options_(options),
        mesh_(mesh_of(desc, scene, options)),
        largest_cell_(cells_across * mesh_.thickness) {}

  Choice choose(const KnownErrors& known) {
    Choice choice = choose_rung(desc_, table_, mesh_, desc_.geometry.cell, largest_cell_, known);
    for (int meshes = 1; meshes < most_meshes && !desc_.choice.fixed.cell; ++meshes) {
      if (std::abs(choice.cell / desc_.geometry.cell - 1) < same_cell) break;
      SoftDesc chosen = desc_;
      chosen.geometry.cell = choice.cell;
      try {
        mesh_ = mesh_of(chosen, scene_, options_);
        desc_ = chosen;
      } catch (const InputError&) {
        largest_cell_ = too_coarse * choice.cell;  // the body is thinner in places than its mean thickness
      }
      choice = choose_rung(desc_, table_, mesh_, desc_.geometry.cell, largest_cell_, known);
    }
    return choice;
  }
  /// Returns the approximate number of elements of the body with cells of that size.
  double elements_at(double cell) const { return mesh_.elements * std::pow(desc_.geometry.cell / cell, 3); }

 private:
  const SceneDesc& scene_;
  SoftDesc desc_;  // with the cell size of `mesh_`
  const RungTable& table_;
  const ChoiceOptions& options_;
  BodyGeometry mesh_;
  double largest_cell_;
};

/// Chooses a rung by trials on the body itself. Its mesh is graded as described.
class TriedBody {
 public:
  TriedBody(const SceneDesc& scene, const SoftDesc& desc, const RungTable& table,
            const ChoiceOptions& options)
      : chooser_(scene, desc, table, options),
        own_({.desc = desc,
              .gravity = scene.gravity,
              .mesh =
                  [&scene, desc, sources = quiet(options)](double cell) {
                    SoftDesc at = desc;
                    at.geometry.cell = cell;
                    return soft_anatomy(at, scene, sources);
                  },
              .cache_dir = options.sources.cache_dir,
              .say = options.sources.progress,
              .prove = options.prove,
              .before_step = options.before_step}) {}

  /// Chooses by the errors known so far, tries the choice on the body, and chooses again, until the choice
  /// has been tried. The first pass assumes that untried candidates are good.
  Choice choose() {
    KnownErrors known;
    known.on_the_body = [&](const std::string& model, const std::string& element, double cell) {
      return own_.at(model, element, cell);
    };
    Choice choice;
    for (const double untried_error_ratio : untried_error_ratios) {
      known.untried_error_ratio = untried_error_ratio;
      choice = chooser_.choose(known);
      for (int i = 0; i < most_attempts && learn(&OwnErrors::attempt, choice); ++i)
        choice = chooser_.choose(known);
    }
    return choice;
  }
  /// Verifies the choice with a larger reference. Returns whether that gave new errors.
  bool prove(const Choice& choice) { return learn(&OwnErrors::prove, choice); }

 private:
  using Judge = bool (OwnErrors::*)(const std::string& model, const std::string& element, double cell,
                                    double elements);
  bool learn(Judge judge, const Choice& c) {
    return (own_.*judge)(c.rung.model, c.rung.element, c.cell, chooser_.elements_at(c.cell));
  }

  Chooser chooser_;
  OwnErrors own_;
};

/// Chooses with and without smaller elements at the rims of attachments, unless the author fixed that. The
/// better choice is verified, and made again with the errors found.
Choice choose(const SceneDesc& scene, const SoftDesc& desc, const RungTable& table,
              const ChoiceOptions& options) {
  if (!options.on_the_body) return Chooser(scene, desc, table, options).choose({});
  struct Tried {
    std::unique_ptr<TriedBody> body;
    Choice choice;
  };
  std::vector<Tried> tried;
  const auto add = [&](const SoftDesc& way) {
    auto body = std::make_unique<TriedBody>(scene, way, table, options);
    Choice choice = body->choose();
    tried.push_back({std::move(body), std::move(choice)});
  };
  add(desc);
  if (!desc.choice.fixed.grade && !desc.attach.empty()) {
    SoftDesc graded = desc;
    graded.geometry.grade = Grading::rims;
    try {
      add(graded);
    } catch (const InputError&) {  // a mesh that can't be graded
    }
  }
  for (int proofs = 0;; ++proofs) {
    Tried& best =
        tried.size() > 1 && serves_better(desc, tried[1].choice, tried[0].choice) ? tried[1] : tried[0];
    if (proofs == most_proofs || !best.body->prove(best.choice)) return best.choice;
    best.choice = best.body->choose();
  }
}

}  // namespace

std::vector<Choice> choose_rungs(SceneDesc& scene, const ChoiceOptions& options) {
  std::vector<Choice> out;
  if (std::none_of(scene.soft.begin(), scene.soft.end(), chosen_by_need)) return out;
  const RungTable table = table_for(scene, options);
  for (SoftDesc& desc : scene.soft) {
    if (!chosen_by_need(desc)) continue;
    out.push_back(choose(scene, desc, table, options));
    adopt(out.back(), desc);
    say(options, fmt::format("{}: {}", desc.name, explain(out.back(), desc)));
  }
  return out;
}

void adopt(const std::vector<Choice>& choices, SceneDesc& scene) {
  for (SoftDesc& desc : scene.soft) {
    const auto choice =
        std::find_if(choices.begin(), choices.end(), [&](const Choice& c) { return c.body == desc.name; });
    if (choice != choices.end())
      adopt(*choice, desc);
    else if (chosen_by_need(desc))
      throw InputError(
          fmt::format("journal: no choice of a model configuration is stored for soft body \"{}\"; the "
                      "journal does not match its scene",
                      desc.name));
  }
}

std::string encode(const std::vector<Choice>& choices) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const Choice& c : choices) {
    nlohmann::ordered_json row = {{"body", c.body}};
    row.update(rung_to_json(c.rung));
    row.update(nlohmann::ordered_json{{"cell", c.cell},
                                      {"grade", grading_names[static_cast<std::size_t>(c.grade)]},
                                      {"expected_error", c.expected.error},
                                      {"expected_ms", c.expected.ms},
                                      {"good_enough", c.good_enough}});
    for (const ActError& act : c.acts) row["acts"][act.act] = act.error;
    out.push_back(std::move(row));
  }
  return out.dump();
}

std::vector<Choice> decode_choices(const std::string& text) {
  try {
    std::vector<Choice> out;
    for (const auto& row : nlohmann::ordered_json::parse(text)) {
      Choice& c = out.emplace_back();
      row.at("body").get_to(c.body);
      c.rung = rung_from_json(row);
      row.at("cell").get_to(c.cell);
      c.grade = grading_of(row.value(
          "grade", std::string(grading_names[0])));  // missing in journals from before meshes were graded
      row.at("expected_error").get_to(c.expected.error);
      row.at("expected_ms").get_to(c.expected.ms);
      row.at("good_enough").get_to(c.good_enough);
      if (row.contains("acts"))  // missing in journals of choices by the table alone
        for (const auto& [act, error] : row.at("acts").items()) c.acts.push_back({act, error.get<double>()});
      check(c);
    }
    return out;
  } catch (const nlohmann::json::exception&) {
    throw InputError("journal: its stored choices of model configurations are damaged, so it cannot be used");
  }
}

}  // namespace prosector
