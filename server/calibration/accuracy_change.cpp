#include "server/calibration/accuracy_change.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/error.h"
#include "common/percent_text.h"
#include "common/surface_files.h"
#include "server/physics/mechanics/soft/laws/constitutive_law.h"

namespace prosector {
namespace {

constexpr double offered[] = {30, 10, 5, 3, 1};  // %: errors offered
constexpr double worth_offering = 0.9;           // of the error before: larger errors are not offered

}  // namespace

SoftDesc without_fixed_rung(SoftDesc desc) {
  const bool names_a_law = desc.choice.fixed.model && soft::is_law(desc.configuration.model);
  const bool from_a_file = !desc.geometry.mesh.empty() && !is_surface_file(desc.geometry.mesh);
  desc.choice.fixed = {.model = names_a_law, .cell = from_a_file};
  desc.choice.accuracy = desc.choice.budget = {};
  return desc;
}

AccuracyChange::AccuracyChange(const SceneDesc& scene, const std::string& body, ChoiceOptions options)
    : scene_(scene), options_(std::move(options)) {
  const auto of_that_name = [&](const SoftDesc& desc) { return desc.name == body; };
  const auto found = std::find_if(scene.soft.begin(), scene.soft.end(), of_that_name);
  if (found == scene.soft.end())
    throw InputError(
        fmt::format("{} is not a [[soft]] body of the scene file: its model is unchanged. Accuracy can be "
                    "set only for bodies listed as [[soft]]",
                    body));
  scene_.soft = {without_fixed_rung(*found)};
}

Choice AccuracyChange::choose(double percent) const {
  SceneDesc scene = scene_;
  scene.soft.front().choice.accuracy.value = percent;
  return choose_rungs(scene, options_).front();
}

std::vector<Price> AccuracyChange::prices() const {
  std::vector<Price> out;
  for (const double percent : offered) {
    const Choice choice = choose(percent);
    const Price price{choice.expected.error, choice.expected.ms};
    if (price.error >= collapsed) continue;
    if (out.empty() || price.error < worth_offering * out.back().error) out.push_back(price);
    if (!choice.good_enough) break;
  }
  return out;
}

std::string in_words(const std::vector<Price>& prices) {
  std::string out;
  for (const Price& price : prices)
    out += fmt::format("{}{} for {:.2g} ms per frame", out.empty() ? "" : ", ", percent_text(price.error),
                       price.ms);
  return out;
}

}  // namespace prosector
