// What a user at a desk first sees of a shipped scene, and while a hand points and touches: the anatomy, not
// the hand.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <span>

#include "common/paths.h"
#include "common/scene/load_scene.h"
#include "tests/client/picture.h"
#include "tests/client/seated_user.h"
#include "tests/folders.h"

namespace prosector::test {
namespace {

constexpr double most_at_start = 0.15, most_touching = 0.35;  // of the anatomy's pixels

using Size = std::array<int, 2>;
constexpr std::array<Size, 3> gate_sizes = {{{800, 600}, {1280, 720}, {1080, 1920}}};
constexpr std::array<Size, 8> all_sizes = {{{800, 600},
                                            {1024, 600},
                                            {1280, 720},
                                            {1920, 1080},
                                            {3440, 1440},
                                            {3840, 2160},
                                            {600, 800},
                                            {1080, 1920}}};

/// Where the pointer goes: what share of the anatomy's pixels is above it.
constexpr std::array<double, 2> gate_places = {0.1, 0.6};
constexpr std::array<double, 5> all_places = {0.02, 0.1, 0.3, 0.6, 0.9};

/// Those that the lessons begin with, which each change is judged by at several sizes; the others at one.
const std::set<std::string> lessons_scenes = {"abdomen", "touch"};
constexpr std::array<Size, 1> usual_size = {{{1280, 720}}};
constexpr std::array<double, 1> usual_place = {0.3};

std::vector<std::string> shipped_scenes() {
  std::vector<std::string> out;
  for (const auto& entry : std::filesystem::directory_iterator(source_path("deploy/scenes")))
    if (entry.path().extension() == ".toml") out.push_back(entry.path().stem().string());
  std::ranges::sort(out);
  return out;
}

/// Returns the anatomy's pixel that this share of its pixels is above, in the middle of its row.
Eigen::Vector2d pixel_below(const AnatomyPixels& pixels, double share) {
  AnatomyPixels row;
  const double y = pixels.at(static_cast<std::size_t>(share * static_cast<double>(pixels.size()))).y();
  std::ranges::copy_if(pixels, std::back_inserter(row), [&](const auto& p) { return p.y() == y; });
  return row.at(row.size() / 2);
}

/// A user of a shipped scene, whose pictures are judged at a resolution.
class JudgedUser {
 public:
  JudgedUser(Simulation& simulation, int longest) : user_(simulation), longest_(longest) {}

  void judge(const Size& size, std::span<const double> places) {
    user_.join(size[0], size[1]);
    AnatomyPixels seen;
    ASSERT_GT(user_.cover(longest_, &seen).pixels, 100U);
    expect_seen(size, "first", most_at_start);
    user_.wait(0.3);
    expect_seen(size, "at rest", most_at_start);
    for (const double place : places) {
      user_.point_at(pixel_below(seen, place));
      user_.wait(0.6);
      expect_seen(size, fmt::format("points {}", place), most_touching);
      user_.press(true);
      user_.wait(0.6);
      expect_seen(size, fmt::format("{} {}", user_.holds() ? "holds" : "touches", place), most_touching);
      user_.press(false);
      user_.wait(0.2);
    }
  }

 private:
  SeatedUser user_;
  int longest_;

  void expect_seen(const Size& size, const std::string& when, double most) {
    const Cover cover = user_.cover(longest_);
    const std::string at = fmt::format("{}x{} {}: {:.3f} by items ({:.3f} if opaque), {:.3f} by texts",
                                       size[0], size[1], when, cover.by_items, cover.opaque, cover.by_texts);
    EXPECT_LE(cover.all(), most) << at;
    EXPECT_TRUE(cover.near.empty()) << at << ": the near plane cuts item " << cover.near.front();
    keep_picture(size, when);
    if (std::getenv("PROSECTOR_PICTURES") != nullptr) fmt::print("{}\n", at);
  }

  /// Keeps a picture where somebody wants to look at it.
  void keep_picture(const Size& size, const std::string& when) const {
    const char* folder = std::getenv("PROSECTOR_PICTURES");
    if (folder == nullptr || *folder == '\0') return;
    write_png(picture_of(user_.picture(), size[0], size[1]),
              std::filesystem::path(folder) /
                  fmt::format("{}-{}x{}-{}.png", user_.scene(), size[0], size[1], when));
  }
};

class FirstView : public testing::TestWithParam<std::string> {
 protected:
  void judge(std::span<const Size> sizes, std::span<const double> places, int longest) {
    CompileOptions options;
    options.threads = 1;
    options.data_dirs = {default_data_dir()};
    options.cache_dir = default_cache_dir();
    Simulation simulation(load_scene(source_path("deploy/scenes/" + GetParam() + ".toml")), options);
    JudgedUser user(simulation, longest);
    for (const Size& size : sizes) user.judge(size, places);
  }
};

TEST_P(FirstView, ShowsTheAnatomyRatherThanOnesOwnHand) {
  if (lessons_scenes.contains(GetParam()))
    judge(gate_sizes, gate_places, 160);
  else
    judge(usual_size, usual_place, 160);
}

TEST_P(FirstView, OfEverySizeShowsTheAnatomy) {
  judge(all_sizes, all_places, 640);
}

INSTANTIATE_TEST_SUITE_P(Scenes, FirstView, testing::ValuesIn(shipped_scenes()),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace prosector::test
