// The scenes that can be hosted from the set-up window.
#include "client/setup/scene_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "common/error.h"
#include "tests/folders.h"
#include "tests/session/temporary_file.h"

namespace prosector::test {
namespace {

TEST(SceneList, HasEachShippedSceneWithWordsAboutIt) {
  const SceneList list(source_path("deploy/scenes"), "/nowhere");
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(source_path("deploy/scenes")))
    files += entry.path().extension() == ".toml" ? 1 : 0;
  EXPECT_EQ(list.scenes().size(), files);
  EXPECT_GE(files, 10u);
  for (const ListedScene& scene : list.scenes()) {
    EXPECT_FALSE(scene.name.empty()) << scene.file;
    EXPECT_FALSE(scene.description.empty()) << scene.file;
  }
  EXPECT_TRUE(std::is_sorted(list.scenes().begin(), list.scenes().end(),
                             [](const auto& a, const auto& b) { return a.name < b.name; }));
}

TEST(SceneList, AnOwnFileIsAddedOnce) {
  SceneList list("/nowhere", "/nowhere");
  EXPECT_TRUE(list.scenes().empty());
  const std::filesystem::path own = source_path("deploy/scenes/minimal.toml");
  EXPECT_EQ(list.add(own), 0u);
  EXPECT_EQ(list.add(own), 0u);
  EXPECT_EQ(list.scenes().size(), 1u);
}

TEST(SceneList, AFileThatIsNoSceneIsNamed) {
  SceneList list("/nowhere", "/nowhere");
  const TemporaryFile broken("broken.toml");
  std::ofstream(broken.path) << "name = \n";
  for (const std::filesystem::path& file : {broken.path, std::filesystem::path("/nowhere.toml")}) {
    try {
      list.add(file);
      FAIL() << file;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(file.string()), std::string::npos) << error.what();
    }
  }
  EXPECT_TRUE(list.scenes().empty());
}

}  // namespace
}  // namespace prosector::test
