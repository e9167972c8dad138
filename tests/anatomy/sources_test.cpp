#include "common/anatomy/sources.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>

#include "common/anatomy/mesh_quality.h"
#include "common/anatomy/surface_check.h"
#include "common/error.h"
#include "tests/anatomy/files.h"
#include "tests/anatomy/reported_lines.h"

namespace prosector {
namespace {

using namespace testing_files;

SoftDesc ball_of(int label) {
  SoftDesc d;
  d.name = "ball";
  d.geometry.volume = "balls.inr";
  d.geometry.label = label;
  d.geometry.cell = 0.008;
  d.geometry.surface_cell = 0.004;
  return d;
}

TEST(Sources, VolumeToTheRoomsFrameAtThePose) {
  const TempDir dir;
  write(dir.path / "balls.inr", two_balls());
  const SourcePaths paths{"/nonexistent", {"/also/nonexistent", dir.path}, {}};
  Lines said;
  SoftDesc d = ball_of(7);
  d.pose = {{1, 2, 3}, Quat(Eigen::AngleAxisd(1.0, Vec3(1, 2, 2).normalized()))};
  const Anatomy a = make_anatomy(d, paths, said.progress());
  const SurfaceReport report = check_surface(a.surface);
  EXPECT_NEAR((report.center_of_mass - d.pose * (0.002 * (Vec3(15, 18, 20) - Vec3::Constant(19.5)))).norm(),
              0, 1e-4);
  EXPECT_NEAR(report.volume, 4.0 / 3 * M_PI * 0.024 * 0.024 * 0.024, 0.05 * report.volume);
  EXPECT_EQ(report.warning(), "");
  for (std::size_t i = 0; i < a.surface.positions.size(); ++i)
    EXPECT_EQ(a.surface.positions[i], a.embedding.apply(i, a.tets.positions[0].data()));
  EXPECT_TRUE(said.say("only the largest of 2 separate pieces is used (1 voxels dropped)"));
  EXPECT_TRUE(said.say("dihedral"));
}

TEST(Sources, MissingFileFallsBackOrSaysWhereItLooked) {
  const SourcePaths paths{"/nowhere/scenes", {"/nowhere/data"}, {}};
  SoftDesc d = ball_of(7);
  try {
    make_anatomy(d, paths, {});
    FAIL();
  } catch (const InputError& e) {
    const std::string what = e.what();
    EXPECT_NE(what.find("/nowhere/scenes/balls.inr, /nowhere/data/balls.inr"), std::string::npos) << what;
  }
  d.geometry.fallback = "kidney";
  Lines said;
  EXPECT_FALSE(make_anatomy(d, paths, said.progress()).tets.tets.empty());
  EXPECT_TRUE(said.say("balls.inr is missing: using the implicit shape \"kidney\" instead"));

  RigidDesc r;
  r.name = "bone";
  r.geometry.mesh = "femur.off";
  EXPECT_THROW(make_surface(r, paths, {}), InputError);
  r.geometry.fallback = "femur";
  EXPECT_EQ(check_surface(make_surface(r, paths, said.progress())).open_edges, 0u);
  EXPECT_TRUE(said.say("femur.off is missing"));
  SoftDesc nothing;
  nothing.name = "nothing";
  EXPECT_THROW(make_anatomy(nothing, paths, {}), InputError);
}

// Neither fetched anew nor replaced by a shape: it is there, and can't be read.
TEST(Sources, PipesFoldersAndDevicesAreNotMissing) {
  const TempDir dir;
  ASSERT_EQ(mkfifo((dir.path / "pipe.nii").c_str(), 0600), 0);
  std::filesystem::create_directory(dir.path / "folder.obj");
  std::filesystem::create_symlink("/dev/null", dir.path / "device.stl");
  const SourcePaths paths{"/nowhere", {dir.path}, {}};
  const auto complaint_of = [&](const std::string& volume, const std::string& mesh) {
    SoftDesc d;
    d.name = "organ";
    d.geometry.volume = volume;
    d.geometry.mesh = mesh;
    d.geometry.fallback = "kidney";
    try {
      make_anatomy(d, paths, {});
      return std::string("accepted");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_NE(complaint_of("pipe.nii", "").find("pipe.nii: is a pipe; allowed: a regular file"),
            std::string::npos);
  EXPECT_NE(complaint_of("", "folder.obj").find("folder.obj: is a folder"), std::string::npos);
  EXPECT_NE(complaint_of("", "device.stl").find("device.stl: is a device"), std::string::npos);
  EXPECT_EQ(complaint_of("", "gone.stl"), "accepted");
}

/// A volume of label 1 in the voxels that `inside` chooses.
template <class Inside>
Bytes labelled(int n, Inside&& inside) {
  std::vector<std::uint8_t> voxels;
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) voxels.push_back(inside(i, j, k) ? 1 : 0);
  return inrimage(n, n, n, {2, 2, 2}, voxels);
}

std::string complaint(const SoftDesc& desc, const SourcePaths& paths, Lines* said = nullptr) {
  try {
    make_anatomy(desc, paths, said != nullptr ? said->progress() : Progress());
    return "";
  } catch (const InputError& e) {
    return e.what();
  }
}

// Each time, also from the cache: a label in two halves, a hollow one, one thinner than a voxel is long.
TEST(Sources, VolumesFarFromTheirLabelsAreRefusedUnlessAsked) {
  const TempDir dir;
  write(dir.path / "halves.inr", labelled(40, [](int i, int j, int k) {
          return (i < 18 || i > 21) && i > 3 && i < 36 && j > 8 && j < 30 && k > 8 && k < 30;
        }));
  write(dir.path / "hollow.inr", labelled(40, [](int i, int j, int k) {
          const double r = (Vec3(i, j, k) - Vec3::Constant(19.5)).norm();
          return r < 16 && r > 12;
        }));
  write(dir.path / "thin.inr",
        labelled(40, [](int i, int j, int k) { return k == 20 && i > 4 && i < 35 && j > 4 && j < 35; }));
  const SourcePaths paths{dir.path, {}, dir.path / "cache"};
  for (const bool cached : {false, true}) {
    SCOPED_TRACE(cached);
    SoftDesc d = ball_of(1);
    d.geometry.volume = "halves.inr";
    const std::string halves = complaint(d, paths);
    EXPECT_NE(halves.find("% less than the 98.78 ml of its voxels"), std::string::npos) << halves;
    EXPECT_NE(halves.find("If a label has several pieces, the largest is used"), std::string::npos) << halves;
    d.geometry.volume = "hollow.inr";
    const std::string hollow = complaint(d, paths);
    EXPECT_NE(hollow.find("% more than the"), std::string::npos) << hollow;
    d.geometry.max_volume_error.value = 100;
    Lines said;
    EXPECT_EQ(complaint(d, paths, &said), "");
    EXPECT_TRUE(said.say("ball: warning: its volume is"));
    d.geometry.max_volume_error.value = 0;
    d.geometry.volume = "thin.inr";
    d.geometry.smoothing = 0.5;
    d.geometry.cell = 0.003;
    const std::string thin = complaint(d, paths);
    EXPECT_NE(thin.find("than the 7.2 ml of its voxels"), std::string::npos) << thin;
    EXPECT_NE(thin.find("parts as thin as a voxel need a finer volume"), std::string::npos) << thin;
  }
}

TEST(Sources, CacheGivesTheSameBitsAndSurvivesDamage) {
  const TempDir dir;
  write(dir.path / "balls.inr", two_balls());
  const SourcePaths paths{dir.path, {}, dir.path / "cache"};
  SoftDesc d = ball_of(9);
  d.geometry.max_volume_error.value = 40;  // its cells are coarse
  const Anatomy first = make_anatomy(d, paths, {});
  const auto same = [&](const Anatomy& a) {
    return a.tets.positions == first.tets.positions && a.tets.tets == first.tets.tets &&
           a.surface.positions == first.surface.positions && a.surface.triangles == first.surface.triangles;
  };
  const auto cached = [&] {
    std::vector<std::filesystem::path> out;
    for (const auto& entry : std::filesystem::directory_iterator(paths.cache_dir))
      out.push_back(entry.path());
    return out;
  };
  ASSERT_EQ(cached().size(), 1u);
  Lines said;
  EXPECT_TRUE(same(make_anatomy(d, paths, said.progress())));
  EXPECT_TRUE(said.say("(cached)"));

  const auto file = cached().front();
  const auto size = std::filesystem::file_size(file);
  for (const auto damage : {0u, 10u, 1000u}) {  // truncated
    std::filesystem::resize_file(file, damage);
    Lines again;
    EXPECT_TRUE(same(make_anatomy(d, paths, again.progress())));
    EXPECT_FALSE(again.say("(cached)"));
    EXPECT_EQ(std::filesystem::file_size(file), size);
  }
  {
    std::fstream f(file, std::ios::in | std::ios::out | std::ios::binary);
    f.seekp(static_cast<std::streamoff>(size / 2));
    f.put('\x55');
    f.put('\x2a');
  }
  Lines flipped;
  EXPECT_TRUE(same(make_anatomy(d, paths, flipped.progress())));
  EXPECT_TRUE(flipped.say("its cached mesh is damaged: rebuilt"));
  // Another parameter is another file; the pose is not part of it.
  SoftDesc finer = d;
  finer.geometry.cell = 0.006;
  make_anatomy(finer, paths, {});
  EXPECT_EQ(cached().size(), 2u);
  SoftDesc moved = d;
  moved.pose.p = {1, 0, 0};
  EXPECT_FALSE(same(make_anatomy(moved, paths, {})));
  EXPECT_EQ(cached().size(), 2u);
  // A cache that can't be written is no reason to fail.
  EXPECT_TRUE(same(make_anatomy(d, {dir.path, {}, "/proc/nowhere"}, {})));
}

// Two tetrahedra that stand in each other, as a surface and as a mesh: said each time, cached or not.
TEST(Sources, ASelfIntersectingSurfaceIsSaidEachTime) {
  const TempDir dir;
  write(dir.path / "crossed.off", std::string("OFF\n8 8 0\n"
                                              "0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                              "0.1 0.1 -0.5\n1.1 0.1 -0.5\n0.1 1.1 -0.5\n0.1 0.1 0.5\n"
                                              "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"
                                              "3 4 6 5\n3 4 5 7\n3 4 7 6\n3 5 6 7\n"));
  write(dir.path / "crossed.vtk",
        std::string("# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 float\n"
                    "0 0 0 1 0 0 0 1 0 0 0 1 .1 .1 -.5 1.1 .1 -.5 .1 1.1 -.5 .1 .1 .5\n"
                    "CELLS 2 10\n4 0 1 2 3\n4 4 5 6 7\nCELL_TYPES 2\n10\n10\n"));
  const SourcePaths paths{dir.path, {}, dir.path / "cache"};
  RigidDesc rigid;
  rigid.name = "crossed bone";
  rigid.geometry.mesh = "crossed.off";
  SoftDesc soft;
  soft.name = "crossed organ";
  soft.geometry.mesh = "crossed.vtk";
  for (const bool cached : {false, true}) {
    Lines said;
    make_surface(rigid, paths, said.progress());
    make_anatomy(soft, paths, said.progress());
    EXPECT_TRUE(said.say("crossed bone: warning: intersects itself: ")) << cached;
    EXPECT_TRUE(said.say("crossed organ: warning: intersects itself: ")) << cached;
    EXPECT_EQ(said.say("(cached)"), cached);
  }
}

TEST(Sources, AStructureOfAVolumeAsARigidSurface) {
  const TempDir dir;
  write(dir.path / "balls.inr", two_balls());
  const SourcePaths paths{dir.path, {}, dir.path / "cache"};
  RigidDesc d;
  d.name = "stone";
  d.geometry.volume = "balls.inr";
  d.geometry.surface_cell = 0.004;
  const double small = 4.0 / 3 * M_PI * 0.010 * 0.010 * 0.010;  // label 9, and all above 8
  const double large = 4.0 / 3 * M_PI * 0.024 * 0.024 * 0.024;  // label 7
  const auto volume = [&] { return check_surface(make_surface(d, paths, {})).volume; };
  d.geometry.label = 9;
  EXPECT_NEAR(volume(), small, 0.1 * small);
  d.geometry.label = -1;
  d.geometry.threshold = 8;
  EXPECT_NEAR(volume(), small, 0.1 * small);
  d.geometry.label = 7;
  EXPECT_NEAR(volume(), large, 0.05 * large);
  EXPECT_NEAR(volume(), large, 0.05 * large);  // from the cache
  d.geometry.surface_cell = 0;                 // the voxels' size
  EXPECT_NEAR(volume(), large, 0.05 * large);
  d.geometry.volume = "missing.nii";
  EXPECT_THROW(make_surface(d, paths, {}), InputError);
  d.geometry.fallback = "ball";
  EXPECT_GT(volume(), 0);
}

TEST(Sources, ShapesScaleToTheirSize) {
  SoftDesc d;
  d.name = "liver";
  d.geometry.shape = "liver";
  d.geometry.size = {0.2, 0.15, 0.14};
  const Anatomy a = make_anatomy(d, {}, {});
  const TetQuality q = tet_quality(a.tets);
  EXPECT_GT(q.tets, 1000u);
  EXPECT_GE(q.min_dihedral_deg, 10);
  d.geometry.shape = "teapot";
  EXPECT_THROW(make_anatomy(d, {}, {}), InputError);
}

TEST(Sources, WhatIsRefusedNamesTheBody) {
  const TempDir dir;
  write(dir.path / "balls.inr", two_balls());
  write(dir.path / "organ.obj", std::string("v 0 0 0\n"));
  const SourcePaths paths{dir.path, {}, {}};
  EXPECT_NE(complaint(ball_of(8), paths).find("ball: "), std::string::npos);
  SoftDesc coarse;
  coarse.name = "thin one";
  coarse.geometry.shape = "cylinder";
  coarse.geometry.size = {0.01, 0.3, 0.01};
  coarse.geometry.cell = 0.3;
  EXPECT_EQ(complaint(coarse, paths).rfind("thin one: mesh: a cell of 300 mm gives no tetrahedra", 0), 0u)
      << complaint(coarse, paths);
  SoftDesc surface;
  surface.name = "liver";
  write(dir.path / "open.obj",
        std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\n"));
  write(dir.path / "organ.xyz", std::string("v 0 0 0\n"));
  struct {
    const char *file, *why;
  } const table[] = {{"organ.obj", "organ.obj: not a surface"},
                     {"open.obj", "open.obj: not closed: 3 edges at the borders of holes"},
                     {"organ.xyz", "organ.xyz: not a tetrahedral mesh; allowed: .msh (Gmsh), .vtk"}};
  for (const auto& row : table) {
    surface.geometry.mesh = row.file;
    const std::string said = complaint(surface, paths);
    EXPECT_EQ(said.rfind("liver: ", 0), 0u) << said;
    EXPECT_NE(said.find(row.why), std::string::npos) << said;
  }
}

TEST(Sources, LabelsAreListedInOrderAndInRanges) {
  const TempDir dir;
  // As voxels come, the large labels are first.
  std::vector<std::uint8_t> voxels(8 * 8 * 4);
  for (std::size_t v = 0; v < voxels.size(); ++v) voxels[v] = static_cast<std::uint8_t>(255 - v);
  for (const std::uint8_t gone : std::initializer_list<std::uint8_t>{4, 7, 8})
    std::replace(voxels.begin(), voxels.end(), gone, std::uint8_t{0});
  write(dir.path / "balls.inr", inrimage(8, 8, 4, {1, 1, 1}, voxels));
  EXPECT_NE(complaint(ball_of(4), {dir.path, {}, {}})
                .find("label 4 does not occur; allowed: 1 to 3, 5 to 6, 9 to 255"),
            std::string::npos)
      << complaint(ball_of(4), {dir.path, {}, {}});
}

TEST(Sources, ManyTetrahedraAreAnnounced) {
  SoftDesc d;
  d.name = "ball";
  d.geometry.shape = "ball";
  d.geometry.size = Vec3::Constant(0.1);
  d.geometry.cell = 0.1 / 38;
  d.geometry.surface_cell = 0.02;
  Lines said;
  make_anatomy(d, {}, said.progress());
  EXPECT_TRUE(said.lines.front().find("ball: meshing with about 2.2e+05 tetrahedra, which takes a while") ==
              0)
      << said.lines.front();
}

// Quadratic elements have a node on each edge: a surface of corners alone would load none of those.
TEST(Sources, MeshFilesOfQuadraticElementsHaveASurfaceVertexOnEachEdge) {
  const TempDir dir;
  std::ofstream(dir.path / "one.msh") << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n"
                                         "3 0 1 0\n4 0 0 1\n$EndNodes\n$Elements\n1\n1 4 2 0 1 1 2 3 4\n"
                                         "$EndElements\n";
  const SourcePaths paths{dir.path, {}, dir.path / "cache"};
  SoftDesc d;
  d.name = "one";
  d.geometry.mesh = "one.msh";
  for (int again = 0; again < 2; ++again) {  // made, then from the cache
    d.configuration.element = "tet4";
    EXPECT_EQ(make_anatomy(d, paths, {}).surface.positions.size(), 4u);
    d.configuration.element = "tet10";
    const Anatomy a = make_anatomy(d, paths, {});
    EXPECT_EQ(a.surface.positions.size(), 10u);
    EXPECT_EQ(a.surface.triangles.size(), 16u);
    EXPECT_EQ(check_surface(a.surface).open_edges, 0u);
    EXPECT_NEAR(check_surface(a.surface).volume, 1. / 6, 1e-12);
    EXPECT_EQ(a.tets.positions.size(), 4u) << "nodes on edges are the element's own";
    for (std::size_t i = 4; i < 10; ++i)
      EXPECT_NEAR(*std::max_element(a.embedding.rows[i].weight.begin(), a.embedding.rows[i].weight.end()),
                  0.5, 1e-12)
          << i;
  }
}

}  // namespace
}  // namespace prosector
