#pragma once
// Choosing rungs by need for a whole scene: the table that it takes, measured where it is missing, then a
// choice for each body that asks for one.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "server/calibration/choose_rung.h"
#include "server/physics/simulation.h"

namespace prosector {

struct ChoiceOptions {
  std::filesystem::path table_file;  // kept from run to run; empty: not kept
  std::string machine;               // what a kept table must hold for: machine_and_build()
  std::function<RungFigures(const RungTrial&)> measure;  // by a RungMeter, or what a test says
  bool on_the_body = true;                               // false: errors are the table's beam's
  CompileOptions sources;                                // where meshes come from, and who hears of progress
  bool prove = false;  // judge what is chosen once more, by large references; false: by proofs that are kept
  std::function<void()> before_step = {};  // called before each step of a trial; may throw to give up
};

/// Chooses for every body with `accuracy` or `budget`, puts the choices into the scene, and says each in one
/// line. Meshes each such body once or twice to count its elements. Throws InputError for what no rung fits.
std::vector<Choice> choose_rungs(SceneDesc& scene, const ChoiceOptions& options);

/// Puts choices made earlier into the scene, also those of bodies that don't ask for one. Throws InputError
/// when a body that needs one has none.
void adopt(const std::vector<Choice>& choices, SceneDesc& scene);

/// Encodes choices as text, for a journal; decode_choices() decodes them, and throws InputError.
std::string encode(const std::vector<Choice>& choices);
std::vector<Choice> decode_choices(const std::string& text);

}  // namespace prosector
