// Shipped scenes load, and no mutation of them does worse than an InputError.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "tests/folders.h"
#include "tests/scene/scene_texts.h"

namespace prosector {
namespace {

std::vector<std::filesystem::path> shipped() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(source_path("deploy/scenes")))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// The beginning of something that nests up to 300,000 levels deep, seldom so many.
std::string nest(std::mt19937_64& random) {
  static constexpr const char* levels[] = {"a.", "[", "{a=", "[a."};
  const std::string level = levels[random() % std::size(levels)];
  std::string out = random() % 2 == 0 ? "\n" : "\n[";
  for (std::size_t n = random() % 50 == 0 ? 300'000 : random() % 100; n > 0; --n) out += level;
  return out + "a]=1\n";
}

std::string mutated(std::string text, std::mt19937_64& random) {
  static constexpr const char* pieces[] = {"nan", "-1", "1e999", "[[",     "]]",   "\"",
                                           "=",   "\n", "{",     "[soft]", "\xff", "99999999999999999999",
                                           "'''", ".",  "true",  "\\u0000"};
  const std::size_t edits = 1 + random() % 4;
  for (std::size_t i = 0; i < edits && !text.empty(); ++i) {
    const std::size_t at = random() % text.size();
    switch (random() % 6) {
      case 0:
        text[at] = static_cast<char>(random());
        break;
      case 1:
        text.erase(at, 1 + random() % 20);
        break;
      case 2:
        text.insert(at, pieces[random() % std::size(pieces)]);
        break;
      case 3:
        text.insert(at, text.substr(random() % text.size(), random() % 200));
        break;
      case 4:
        text.resize(at);
        break;
      case 5:
        text.insert(at, nest(random));
        break;
    }
  }
  return text;
}

TEST(SceneFuzz, ShippedScenesLoad) {
  ASSERT_GE(shipped().size(), 3u);
  for (const auto& file : shipped()) EXPECT_NO_THROW(load_scene(file)) << file;
}

TEST(SceneFuzz, MutatedScenesLoadOrAreRefused) {
  std::mt19937_64 random(7);
  int refused = 0, loaded = 0;
  for (const auto& path : shipped()) {
    std::ifstream file(path);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    for (int i = 0; i < 1500; ++i) (complaint(mutated(text, random)).empty() ? loaded : refused)++;
  }
  EXPECT_GT(refused, 0);
  EXPECT_GT(loaded, 0);
}

}  // namespace
}  // namespace prosector
