// A compiled equilibrium from a damaged cache is found anew: the scene never starts from another state.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "tests/physics/scenes.h"

namespace prosector {
namespace {

struct CachedScene {
  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("prosector-rest." + std::to_string(getpid()));
  std::vector<std::string> said;

  CachedScene() { std::filesystem::create_directories(folder); }
  ~CachedScene() { std::filesystem::remove_all(folder); }

  std::uint64_t compile() {
    said.clear();
    SceneDesc scene;
    scene.rigid = {test::table()};
    scene.soft = {test::block()};
    CompileOptions options = test::options();
    options.cache_dir = folder;
    options.progress = [this](const std::string& line) { said.push_back(line); };
    return Simulation(scene, options).state_hash();
  }
  bool says(const std::string& what) const {
    return std::ranges::any_of(said, [&](const std::string& line) { return line.find(what) != line.npos; });
  }
  std::filesystem::path file() const { return std::filesystem::directory_iterator(folder)->path(); }
};

std::string read(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Cache, ASingleFlippedBitIsNoticedAndTheEquilibriumFoundAnew) {
  CachedScene scene;
  const std::uint64_t hash = scene.compile();
  EXPECT_TRUE(scene.says("equilibrium found"));
  ASSERT_EQ(scene.compile(), hash);
  EXPECT_FALSE(scene.says("equilibrium found"));
  const std::filesystem::path file = scene.file();
  const std::string whole = read(file);
  std::mt19937_64 random(17);
  for (int i = 0; i < 40; ++i) {
    std::string flipped = whole;
    const std::size_t at = random() % flipped.size();
    flipped[at] = static_cast<char>(flipped[at] ^ (1 << random() % 8));
    std::ofstream(file, std::ios::binary) << flipped;
    EXPECT_EQ(scene.compile(), hash) << "byte " << at;
    EXPECT_TRUE(scene.says("damaged")) << "byte " << at;
    EXPECT_EQ(read(file), whole);
  }
}

}  // namespace
}  // namespace prosector
