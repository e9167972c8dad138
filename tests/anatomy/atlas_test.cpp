// Label maps whose structures are bodies.

#include "common/anatomy/atlas.h"

#include <gtest/gtest.h>

#include <array>

#include "common/anatomy/mesh_quality.h"
#include "common/anatomy/sources.h"
#include "common/error.h"
#include "common/scene/load_scene.h"
#include "tests/anatomy/files.h"
#include "tests/folders.h"
#include "tests/real_data.h"

namespace prosector {
namespace {

using namespace testing_files;

// Two balls of 24 mm and 10 mm radius, labels 7 and 9.
struct Map {
  TempDir dir;
  SourcePaths paths{dir.path, {}, {}};

  Map() {
    write(dir.path / "map.inr", two_balls());
    write(dir.path / "names.csv",
          std::string("id,name,name.de,ta,color\n7,liver,Leber,A05.8.01.001,\n9,rib,Rippe,,#ff0000\n"
                      "12,nowhere,,,\n"));
  }

  SceneDesc scene(const std::string& more) const {
    return parse_scene("name = \"s\"\n[[atlas]]\nvolume = \"map.inr\"\n" + more, dir.path / "s.toml");
  }
  std::string complaint(const std::string& more) const {
    try {
      completed(scene(more), paths, {});
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
};

TEST(Atlas, EachLabelIsABodyByName) {
  const Map map;
  std::string said;
  const SceneDesc s = completed(map.scene("labels = \"names.csv\"\nposition = [0, 1, 0]\n"), map.paths,
                                [&](const std::string& line) { said += line; });
  ASSERT_EQ(s.soft.size(), 1u);
  ASSERT_EQ(s.rigid.size(), 1u);  // bone
  EXPECT_TRUE(s.atlases.empty());
  EXPECT_EQ(s.soft[0].name, "liver");
  EXPECT_EQ(s.soft[0].names, (std::vector<LocalName>{{"de", "Leber"}}));
  EXPECT_EQ(s.soft[0].term, "A05.8.01.001");
  EXPECT_EQ(s.soft[0].geometry.label, 7);
  EXPECT_EQ(s.soft[0].pose.p, Vec3(0, 1, 0));
  EXPECT_TRUE(s.soft[0].part && s.rigid[0].part);
  EXPECT_EQ(s.rigid[0].name, "rib");
  EXPECT_TRUE(s.rigid[0].appearance.color.isApprox(Vec3(1, 0, 0)));
  EXPECT_NE(said.find("2 of 2 labels"), std::string::npos) << said;
  // A body's mesh is its label's, in its place.
  const Anatomy liver = make_anatomy(s.soft[0], map.paths, {});
  const double ml = 1e6 * tet_quality(liver.tets).volume;
  EXPECT_NEAR(ml, 57.9, 6);  // 4/3 π 24³ mm³
  // Done once, it is done.
  EXPECT_EQ(completed(s, map.paths, {}).soft.size(), 1u);
}

TEST(Atlas, WithoutATableLabelsGoByNumber) {
  const Map map;
  const SceneDesc s = completed(map.scene("cell = 0.008\nhold = 0\n"), map.paths, {});
  ASSERT_EQ(s.soft.size(), 2u);
  EXPECT_EQ(s.soft[0].name, "region 7");
  EXPECT_EQ(s.soft[1].name, "region 9");
  EXPECT_EQ(s.soft[0].geometry.cell, 0.008);
  EXPECT_TRUE(s.soft[0].attach.empty());
  EXPECT_NE(s.soft[0].appearance.color, s.soft[1].appearance.color);
}

TEST(Atlas, TakesOnlyAndLeavesOut) {
  const Map map;
  EXPECT_EQ(completed(map.scene("labels = \"names.csv\"\nonly = [\"liver\"]\n"), map.paths, {}).rigid.size(),
            0u);
  EXPECT_EQ(
      completed(map.scene("labels = \"names.csv\"\nleave_out = [\"liver\"]\n"), map.paths, {}).soft.size(),
      0u);
  const SceneDesc s = completed(map.scene("labels = \"names.csv\"\nmaterial = \"brain\"\n"), map.paths, {});
  EXPECT_EQ(s.soft.size(), 2u);  // what it is made of is said: no bone
}

TEST(Atlas, SaysWhatIsWrong) {
  const Map map;
  write(map.dir.path / "grey.inr", inrimage(2, 2, 2, {1, 1, 1}, std::vector<std::uint8_t>(8, 0)));
  write(map.dir.path / "noid.csv", std::string("name\nliver\n"));
  struct {
    const char *more, *what;
  } const table[] = {
      {"labels = \"names.csv\"\nonly = [\"livre\"]\n",
       "\"livre\": no label of names.csv has this name; did you mean \"liver\""},
      {"labels = \"names.csv\"\nonly = [\"nowhere\"]\n",
       "label 12 (\"nowhere\") does not occur in map.inr, which has the labels 7, 9"},
      {"labels = \"names.csv\"\nleave_out = [\"liver\", \"rib\"]\n", "no label remains; map.inr has 7, 9"},
      {"labels = \"gone.csv\"\n", "gone.csv is missing; searched for"},
      {"labels = \"noid.csv\"\n", "\"liver\" has no id"},
      {"only = [\"region 3\"]\n", "no label of map.inr has this name"},
      {"[[rigid]]\nname = \"region 7\"\n[[rigid.part]]\n", "label \"region 7\": another body has this name"},
  };
  for (const auto& row : table) {
    const std::string said = map.complaint(row.more);
    EXPECT_NE(said.find(row.what), std::string::npos) << row.more << said;
    EXPECT_NE(said.find("s.toml: [[atlas]]"), std::string::npos) << said;
  }
  const auto of = [&](const std::string& volume) {
    try {
      completed(
          parse_scene("name = \"s\"\n[[atlas]]\nvolume = \"" + volume + "\"\n", map.dir.path / "s.toml"),
          map.paths, {});
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(of("gone.nii").find("deploy/fetch_anatomy.sh"), std::string::npos);
  EXPECT_NE(of("grey.inr").find("no label except 0"), std::string::npos);
  Bytes half = nifti_header(2, 1, 1, 16);
  put(half, 352, 1.f);
  put(half, 356, 1.5f);
  write(map.dir.path / "half.nii", half);
  EXPECT_NE(of("half.nii").find("not a label map: voxel 1 is 1.5"), std::string::npos) << of("half.nii");
}

TEST(Atlas, SpecksAreLeftOutUnlessAskedFor) {
  const Map map;
  std::vector<std::uint8_t> voxels(20 * 20 * 20);
  for (int k = 5; k < 15; ++k)
    for (int j = 5; j < 15; ++j)
      for (int i = 5; i < 15; ++i) voxels[static_cast<std::size_t>(i + 20 * (j + 20 * k))] = 7;
  voxels[0] = voxels[1] = 9;
  write(map.dir.path / "map.inr", inrimage(20, 20, 20, {2, 2, 2}, voxels));
  std::string said;
  const SceneDesc s =
      completed(map.scene(""), map.paths, [&](const std::string& line) { said += line + "\n"; });
  ASSERT_EQ(s.soft.size(), 1u);
  EXPECT_EQ(s.soft[0].geometry.label, 7);
  EXPECT_NE(said.find("label 9 (\"region 9\") has only 2 voxels: omitted"), std::string::npos) << said;
  EXPECT_EQ(completed(map.scene("only = [\"region 9\"]\n"), map.paths, {}).soft.size(), 1u);
}

TEST(Atlas, ThinStructuresGetFinerCells) {
  const Map map;
  constexpr int n = 24;
  std::vector<std::uint8_t> voxels(n * n * n);
  const auto fill = [&](std::uint8_t label, const std::array<int, 3>& from, const std::array<int, 3>& size) {
    for (int k = 0; k < size[2]; ++k)
      for (int j = 0; j < size[1]; ++j)
        for (int i = 0; i < size[0]; ++i)
          voxels[static_cast<std::size_t>(from[0] + i + n * (from[1] + j + n * (from[2] + k)))] = label;
  };
  fill(1, {1, 1, 1}, {8, 8, 8});
  fill(2, {1, 0, 20}, {22, 23, 1});  // about as much
  write(map.dir.path / "map.inr", inrimage(n, n, n, {2, 2, 2}, voxels));
  const SceneDesc s = completed(map.scene(""), map.paths, {});
  ASSERT_EQ(s.soft.size(), 2u);
  EXPECT_NEAR(s.soft[0].geometry.cell, 0.3 * 0.016, 1e-9);  // by volume: of a cube of 16 mm
  EXPECT_LT(s.soft[1].geometry.cell, 0.9 * s.soft[0].geometry.cell);
  // What fills its map has no faces, and is still a body.
  write(map.dir.path / "map.inr", inrimage(8, 8, 8, {2, 2, 2}, std::vector<std::uint8_t>(512, 3)));
  EXPECT_EQ(completed(map.scene(""), map.paths, {}).soft.size(), 1u);
}

TEST(Atlas, ATableOfNamesIsForTheScenesBodies) {
  const Map map;
  const std::string text =
      "name = \"s\"\nlabels = \"names.csv\"\n[[rigid]]\nname = \"liver\"\n[[rigid.part]]\n";
  EXPECT_EQ(completed(parse_scene(text, map.dir.path / "s.toml"), map.paths, {}).rigid[0].names.size(), 1u);
  std::string said;
  const SourcePaths elsewhere{map.dir.path / "elsewhere", {}, {}};
  const SceneDesc plain = completed(parse_scene(text, map.dir.path / "s.toml"), elsewhere,
                                    [&](const std::string& line) { said = line; });
  EXPECT_TRUE(plain.rigid[0].names.empty());
  EXPECT_NE(said.find("names.csv is missing"), std::string::npos);
}

TEST(Atlas, TheBrainHas116Parts) {
  if (find_in_data("aal.nii.gz").empty()) GTEST_SKIP() << "no aal.nii.gz: deploy/fetch_anatomy.sh";
  const std::filesystem::path file = source_path("deploy/scenes/brain.toml");
  const SceneDesc s = completed(load_scene(file), {file.parent_path(), {default_data_dir()}, {}}, {});
  EXPECT_EQ(s.soft.size(), 116u);
  EXPECT_EQ(s.soft[0].name, "left precentral gyrus");
  EXPECT_EQ(name_in("tr", s.soft[37].name, s.soft[37].names), "sağ hipokampus");
}

}  // namespace
}  // namespace prosector
