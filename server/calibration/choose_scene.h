#pragma once
// Choice of rungs by need for a whole scene: measures the rows that the table lacks, then chooses for each
// body that asks for a choice.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "server/calibration/choose_rung.h"
#include "server/physics/simulation.h"

namespace prosector {

struct ChoiceOptions {
  std::filesystem::path table_file;  // cached from run to run; empty: not cached
  std::string machine;               // machine and build that a cached table must be of: machine_and_build()
  std::function<RungFigures(const RungTrial&)> measure;  // measured by a RungMeter, or given by a test
  bool on_the_body = true;                               // false: errors are those of the table's beam
  CompileOptions sources;                                // sources of meshes, and the callback for progress
  bool prove = false;  // verify choices with large references; false: use only verifications that are cached
  std::function<void()> before_step = {};  // called before each step of a trial; may throw to abort it
};

/// Chooses a configuration for every body with `accuracy` or `budget`, writes the choices into the scene, and
/// reports each in one line. Meshes each such body at least once to count its elements. Throws InputError if
/// no configuration agrees with what the scene fixed.
std::vector<Choice> choose_rungs(SceneDesc& scene, const ChoiceOptions& options);

/// Writes earlier choices of configurations into the scene, including those of bodies that don't request one.
/// Throws InputError if a body that needs a choice has none.
void adopt(const std::vector<Choice>& choices, SceneDesc& scene);

/// Encodes choices of configurations as text for a session's journal. decode_choices() decodes them, and
/// throws InputError for damaged text.
std::string encode(const std::vector<Choice>& choices);
std::vector<Choice> decode_choices(const std::string& text);

}  // namespace prosector
