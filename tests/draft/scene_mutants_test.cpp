// Scenes with numbers that nobody means: each is refused, or runs without anything that is no number.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <string>
#include <vector>

#include "common/error.h"
#include "common/scene/load_scene.h"
#include "server/physics/simulation.h"
#include "tests/anatomy/files.h"
#include "tests/random.h"

namespace prosector {
namespace {

using namespace testing_files;

/// One of each kind of body that a scene without files can have. Cells stay as they are: how large a mesh may
/// get has its own tests.
constexpr const char* scene_text = R"(name = "mutant"
gravity = [0, -9.81, 0]
tick_rate = 60
contact_stiffness = 20
[hand]
mass = 0.4
stiffness = 400
[camera]
eye = [0.2, 1.25, 0.4]
target = [0, 0.95, 0]
fov = 0.8
[patient]
right = [-1, 0, 0]
head = [0, 0, -1]
[[rigid]]
name = "table"
fixed = true
friction = 0.8
  [[rigid.part]]
  size = [0.6, 0.04, 0.6]
  position = [0, 0.88, 0]
  rounding = 0.005
[[rigid]]
name = "block"
position = [0.2, 0.95, 0]
rotation = [1, 0, 0, 0]
density = 1200
restitution = 0.2
  [[rigid.part]]
  size = [0.06, 0.06, 0.06]
  position = [0, 0, 0]
[[soft]]
name = "ball"
shape = "ball"
size = [0.12, 0.12, 0.12]
position = [0, 0.96, 0]
cell = 0.03
density = 1000
youngs_modulus = 5000
poisson_ratio = 0.45
damping_mass = 2
damping_stiffness = 0.015
friction = 0.4
  [[soft.attach]]
  center = [0, 0.92, 0]
  radius = 0.03
  stiffness = 1e6
[[light]]
name = "lamp"
kind = "spot"
position = [0.1, 1.9, 0.2]
direction = [-0.1, -1, -0.2]
cone = 0.5
intensity = 0.9
)";

bool is_number_at(const std::string& text, std::size_t at) {
  const auto digit = [&](std::size_t k) { return std::isdigit(static_cast<unsigned char>(text[k])) != 0; };
  return digit(at) && std::string(" [-").find(text[at - 1]) != std::string::npos;
}

/// Returns where the scene's numbers begin, but for those of cells.
std::vector<std::size_t> numbers_of(const std::string& text) {
  std::vector<std::size_t> out;
  for (std::size_t line = 0; line < text.size(); line = text.find('\n', line) + 1) {
    const std::size_t end = text.find('\n', line);
    if (text.compare(line, 4, "cell") == 0) continue;
    for (std::size_t at = line + 1; at < end; ++at)
      if (is_number_at(text, at)) out.push_back(at);
  }
  return out;
}

std::string odd_number(double before, Random& random) {
  static constexpr const char* odd[] = {"0",   "1e-9", "1e-300", "1e9",  "1e300",
                                        "inf", "nan",  "1",      "1000", "0.4999999"};
  const double sign = random.below(3) == 0 ? -1 : 1;
  if (random.below(2) == 0) return odd[random.below(std::size(odd))];
  return fmt::format("{:.6g}", sign * (before + 1e-3) * std::pow(10, random.uniform(-4, 4)));
}

std::string mutant(Random& random) {
  std::string text = scene_text;
  for (std::size_t edits = 1 + random.below(4); edits > 0; --edits) {
    const std::vector<std::size_t> numbers = numbers_of(text);
    std::size_t at = numbers[random.below(numbers.size())];
    const std::size_t end = text.find_first_of(",]\n #", at);
    const double before = std::strtod(text.c_str() + at, nullptr);
    if (text[at - 1] == '-') --at;
    text.replace(at, end - at, odd_number(before, random));
  }
  return text;
}

/// Returns whether the scene was refused in words.
bool is_refused(const std::filesystem::path& folder) {
  CompileOptions options;
  options.threads = 1;
  options.cache_dir = folder / "cache";
  try {
    Simulation simulation(load_scene(folder / "scene.toml"), options);
    for (int tick = 0; tick < 5; ++tick) simulation.step({});
    for (BodyId b = 0; b < simulation.body_count(); ++b)
      if (simulation.kind(b) == BodyKind::soft)
        EXPECT_TRUE(simulation.soft_state(b).motion.x.allFinite()) << simulation.name(b);
      else
        EXPECT_TRUE(is_finite(simulation.rigid_state(b).pose)) << simulation.name(b);
  } catch (const InputError& error) {
    const std::string said = error.what();
    EXPECT_TRUE(said.find("scene.toml:") != said.npos || said.starts_with("ball: ")) << said;
    return true;
  }
  return false;
}

void try_mutants(unsigned seed, std::size_t count) {
  const TempDir dir;
  Random random(seed);
  std::size_t refused = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string text = mutant(random);
    write(dir.path / "scene.toml", text);
    refused += is_refused(dir.path);
    if (::testing::Test::HasFailure()) FAIL() << "mutant " << i << " of seed " << seed << ":\n" << text;
  }
  EXPECT_GT(refused, count / 10);
  EXPECT_LT(refused, count);
}

TEST(SceneMutants, OfAFixedSeed) {
  try_mutants(20261128, 40);
}

// The nightly run's: PROSECTOR_MUTANTS of them.
TEST(SceneMutants, OfAnySeed) {
  try_mutants(test_seed(false), number("PROSECTOR_MUTANTS", 2000));
}

}  // namespace
}  // namespace prosector
