// Where pictures go that are kept with a key.

#include "client/app/output/picture_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <map>

namespace prosector {
namespace {

class PictureFile : public testing::Test {
 protected:
  std::filesystem::path home =
      std::filesystem::temp_directory_path() / ("pictures." + std::to_string(getpid()));
  std::map<std::string, std::string> variables{{"HOME", home.string()}};

  void SetUp() override { std::filesystem::create_directories(home / ".config"); }
  void TearDown() override { std::filesystem::remove_all(home); }
  std::filesystem::path folder() const {
    return pictures_folder([&](const char* name) {
      const auto found = variables.find(name);
      return found == variables.end() ? std::string() : found->second;
    });
  }
  void list(const std::string& line) { std::ofstream(home / ".config" / "user-dirs.dirs") << line << '\n'; }
};

TEST_F(PictureFile, GoesWhereTheDesktopSaysElseWhereItIsThere) {
  EXPECT_EQ(folder(), std::filesystem::current_path());
  std::filesystem::create_directories(home / "Pictures");
  EXPECT_EQ(folder(), home / "Pictures");
  list("XDG_PICTURES_DIR=\"$HOME/Bilder\"");
  EXPECT_EQ(folder(), home / "Pictures") << "the listed one is not there";
  std::filesystem::create_directories(home / "Bilder");
  EXPECT_EQ(folder(), home / "Bilder");
  std::filesystem::create_directories(home / "own");
  variables["XDG_PICTURES_DIR"] = (home / "own").string();
  EXPECT_EQ(folder(), home / "own");
}

TEST_F(PictureFile, NeverHasTheNameOfAnother) {
  const auto now = std::chrono::system_clock::now();
  const std::filesystem::path first = free_picture_file(home, now, 742);
  EXPECT_NE(first.string().find("-tick-742.png"), std::string::npos) << first;
  std::ofstream{first} << "kept";
  const std::filesystem::path second = free_picture_file(home, now, 742);
  EXPECT_NE(second, first);
  std::ofstream{second} << "kept";
  EXPECT_FALSE(std::filesystem::exists(free_picture_file(home, now, 742)));
}

}  // namespace
}  // namespace prosector
