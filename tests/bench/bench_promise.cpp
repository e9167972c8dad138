// Validation of predicted accuracies. Random bodies request an accuracy, and the server's choice is checked
// against a finer reference, with presses at other points than the choice used and with tilted gravity.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>

#include "common/error.h"
#include "server/physics/stations/compile/sources.h"
#include "tests/bench/bench_choice.h"
#include "tests/bench/subjects.h"
#include "tests/bench/text_table.h"
#include "tests/random.h"

namespace prosector {
namespace {

constexpr const char* shapes[] = {"block", "ball", "beam", "liver", "kidney", "CT liver", "CT kidney"};
constexpr double ratios[] = {0, 0.2, 0.3, 0.4, 0.45, 0.49, 0.499, 0.4999};
constexpr double asked[] = {30, 10, 5, 3};      // %
constexpr int ct_liver = 255, ct_kidney = 127;  // labels of liver.inr.gz
constexpr double ct_cell = 0.02;                // m
constexpr double leaning = 0.3;                 // sideways component, as a fraction of gravity

template <class T, std::size_t n>
const T& one_of(const T (&all)[n], Random& random) {
  return all[random.below(n)];
}

/// Takes the body's geometry from the CT volume; without the volume a built-in shape is used.
void image(SoftDesc& desc) {
  desc.geometry.volume = "liver.inr.gz";
  desc.geometry.label = desc.geometry.shape == "CT liver" ? ct_liver : ct_kidney;
  desc.geometry.fallback = desc.geometry.shape.substr(3);
  desc.geometry.shape.clear();
  desc.geometry.cell = desc.geometry.label == ct_liver ? ct_cell : ct_cell / 2;
}

/// Returns a readable description of the body's shape.
std::string shape_of(const SoftDesc& desc) {
  return desc.geometry.volume.empty() ? desc.geometry.shape : "CT " + desc.geometry.fallback;
}

SceneDesc drawn(int number, Random& random) {
  SceneDesc scene;
  scene.name = "promise";
  SoftDesc& desc = scene.soft.emplace_back();
  desc.name = fmt::format("body {}", number);
  desc.geometry.shape = one_of(shapes, random);
  desc.geometry.size = Vec3(random.uniform(0.06, 0.25), random.uniform(0.06, 0.2), random.uniform(0.06, 0.2));
  desc.material.youngs_modulus = std::pow(10, random.uniform(3.3, 6));
  desc.material.poisson_ratio = one_of(ratios, random);
  desc.geometry.cell = desc.geometry.size.minCoeff() / 3;
  if (desc.geometry.shape.starts_with("CT ")) image(desc);
  if (random.below(2) == 0) {
    AttachDesc tie;
    tie.center = Vec3(-desc.geometry.size.x() / 2, 0, 0);
    tie.radius = random.uniform(0.3, 0.8) * desc.geometry.size.minCoeff();
    tie.stiffness = random.below(2) == 0 ? 1e12 : 2e7;
    desc.attach.push_back(tie);
  }
  if (random.below(3) == 0) {
    RegionDesc region;
    region.center = Vec3(desc.geometry.size.x() / 4, 0, 0);
    region.radius = desc.geometry.size.minCoeff() / 3;
    region.youngs_modulus = desc.material.youngs_modulus * (random.below(2) == 0 ? 0.2 : 5);
    desc.material.regions.push_back(region);
  }
  desc.choice.accuracy.value = one_of(asked, random);
  if (random.below(2) == 0) desc.choice.accuracy_of = {"shape"};
  return scene;
}

/// Returns the error under each evaluated load, including presses and a gravity that the choice did not use.
/// Empty if the reference is not accurate enough to judge the choice.
std::vector<ActError> true_errors(const SceneDesc& scene, const Choice& choice,
                                  const PromiseBenchOptions& options, const CompileOptions& sources) {
  SoftDesc desc = scene.soft.front();
  desc.geometry.cell = choice.cell;
  desc.geometry.grade = choice.grade;
  const bool touched =
      std::count(desc.choice.accuracy_of.begin(), desc.choice.accuracy_of.end(), "touch") > 0;
  const Vec3 leans = scene.gravity + leaning * scene.gravity.norm() * Vec3(0.6, 0, 0.8);
  const BodyTrial trial(desc, leans, soft_anatomy(desc, scene, sources),
                        {.most_tets = options.finest_reference, .presses = touched ? 8 : 0, .tilts = false});
  if (choice.rung.element == "tet10" && !trial.judges_quadratic()) return {};
  return trial.measure(choice.rung.model, choice.rung.element);
}

ReportRow judged(const SceneDesc& scene, const Choice& choice, const std::vector<ActError>& acts) {
  const ActError found = acts.empty() ? ActError{"", std::nan("")} : worst(acts);
  const double error = found.error;
  const SoftDesc& desc = scene.soft.front();
  const double promised = choice.good_enough ? desc.choice.accuracy.value / 100 : choice.expected.error;
  return {{"body", desc.name},
          {"shape", shape_of(desc)},
          {"youngs_modulus", desc.material.youngs_modulus},
          {"poisson_ratio", desc.material.poisson_ratio},
          {"held", desc.attach.empty() ? "free" : "tied"},
          {"judged_by", desc.choice.accuracy_of.size() == 1 ? "shape" : "all"},
          {"asked", desc.choice.accuracy.value / 100},
          {"promised", promised},
          {"expected", choice.expected.error},
          {"error_continuum", error},
          {"true_over_expected", error / choice.expected.error},
          {"model", choice.rung.model},
          {"element", choice.rung.element},
          {"cell_mm", 1e3 * choice.cell},
          {"grade", choice.grade},
          {"act", found.act},
          {"unsettled", found.unsettled},
          {"ms_per_frame", choice.expected.ms},
          {"verdict", std::isnan(error)    ? "not judged"
                      : error >= collapsed ? (promised >= collapsed ? "kept" : "collapsed")
                      : error <= promised  ? "kept"
                      : error - 2 * found.unsettled <= promised ? "not settled"
                      : error <= 2 * promised                   ? "missed"
                                                                : "over 2 times"}};
}

}  // namespace

Report bench_promise(const PromiseBenchOptions& options) {
  Report report("promise");
  report.note("seed", options.seed);
  fmt::print("seed {}\n", options.seed);
  const TextTable table({{Column::Kind::text, "shape", "body", 9},
                         {Column::Kind::number, "youngs_modulus", "E, Pa", 8},
                         {Column::Kind::number, "poisson_ratio", "ratio", 6},
                         {Column::Kind::text, "held", "held", 4},
                         {Column::Kind::text, "judged_by", "judged by", 9},
                         {Column::Kind::percent, "asked", "requested", 9},
                         {Column::Kind::percent, "promised", "promised", 9},
                         {Column::Kind::percent, "error_continuum", "true", 7},
                         {Column::Kind::number, "true_over_expected", "true/expected", 13},
                         {Column::Kind::text, "verdict", "verdict", 18},
                         {Column::Kind::text, "model", "model", 17},
                         {Column::Kind::text, "element", "element", 7},
                         {Column::Kind::number, "cell_mm", "cell, mm", 8},
                         {Column::Kind::text, "grade", "grade", 5},
                         {Column::Kind::text, "act", "act", 18},
                         {Column::Kind::percent, "unsettled", "unsettled", 9}});
  table.print_header();
  RungMeter meter;
  ChoiceOptions choice = choice_options(options.cache, meter);
  choice.prove = true;  // as the server does while a session runs
  if (options.verbose) choice.sources.progress = [](const std::string& line) { fmt::print("  {}\n", line); };
  for (const std::string& folder : options.data) choice.sources.data_dirs.emplace_back(folder);
  Random random(options.seed);
  int kept = 0, judged_cases = 0;
  for (int i = 1; i <= options.cases; ++i) {
    SceneDesc scene = drawn(i, random);
    const SceneDesc asks = scene;
    try {
      const Choice chosen = choose_rungs(scene, choice).front();
      const std::vector<ActError> acts = true_errors(asks, chosen, options, choice.sources);
      if (options.verbose && !acts.empty()) fmt::print("  body {}: true errors {}\n", i, in_words(acts));
      const ReportRow row = judged(asks, chosen, acts);
      table.print(row);
      std::fflush(stdout);
      report.add(row);
      judged_cases += !setting(row, "verdict").starts_with("not ");
      kept += setting(row, "verdict") == "kept";
    } catch (const InputError& error) {
      fmt::print("body {}: {}\n", i, error.what());
    }
  }
  fmt::print("{} of {} predicted accuracies met\n", kept, judged_cases);
  report.note("kept", kept);
  report.note("judged", judged_cases);
  return report;
}

}  // namespace prosector
