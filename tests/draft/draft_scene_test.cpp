// What `prosector-scene new` writes runs: over many inputs, drafted, loaded, compiled, stepped.

#include "common/draft/draft_scene.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>

#include "common/anatomy/mesh_quality.h"
#include "common/anatomy/sources.h"
#include "common/anatomy/surface_field.h"
#include "common/error.h"
#include "common/scene/load_scene.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "server/physics/simulation.h"
#include "tests/anatomy/files.h"
#include "tests/draft/surface_texts.h"

namespace prosector {
namespace {

using namespace testing_files;

const Vec3 liver_size(0.22, 0.12, 0.16);

/// Loads, compiles and steps a scene that was written into the folder.
void run(const SceneDesc& scene, const std::filesystem::path& folder, std::size_t bodies) {
  CompileOptions options;
  options.threads = 1;
  options.cache_dir = folder / "cache";
  Simulation simulation(scene, options);
  EXPECT_EQ(simulation.body_count(), bodies);
  for (int tick = 0; tick < 10; ++tick) simulation.step({});
  for (BodyId b = 0; b < simulation.body_count(); ++b)
    if (simulation.kind(b) == BodyKind::soft)
      EXPECT_TRUE(simulation.soft_state(b).motion.x.allFinite() && simulation.max_displacement(b) < 0.01)
          << simulation.name(b);
    else
      EXPECT_TRUE(simulation.rigid_state(b).pose.p.allFinite()) << simulation.name(b);
}

SceneDesc drafted(const std::filesystem::path& source, const std::filesystem::path& folder,
                  const DraftOptions& options = {}) {
  const Draft draft = draft_scene(source, folder, options);
  EXPECT_FALSE(draft.notes.empty());
  write(folder / "scene.toml", draft.toml);
  return load_scene(folder / "scene.toml");
}

std::string complaint(const std::filesystem::path& source, const DraftOptions& options = {}) {
  try {
    draft_scene(source, source.parent_path(), options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

struct Case {
  const char *file, *shape;
  Vec3 size;
  double per_metre;  // the file's unit
  double edge;
};

TEST(DraftScene, SurfacesOfEveryFormatAndUnitRun) {
  const Case table[] = {
      {"liver.obj", "liver", liver_size, 1000, 0.012},
      {"Left_Kidney.stl", "kidney", {0.06, 0.11, 0.05}, 1000, 0.008},
      {"kidney.ply", "kidney", {0.06, 0.11, 0.05}, 100, 0.008},
      {"gallbladder.off", "gallbladder", {0.09, 0.04, 0.04}, 1, 0.006},
      {"femur.obj", "femur", {0.1, 0.15, 0.08}, 1000, 0.01},
      {"thing.STL", "block", {0.2, 0.05, 0.15}, 1000, 0.01},
  };
  for (const Case& c : table) {
    SCOPED_TRACE(c.file);
    const TempDir dir;
    const TriangleMesh mesh = surface_of(c.shape, c.size, c.edge);
    write(dir.path / c.file, as_text(c.file, mesh, c.per_metre));
    const SceneDesc scene = drafted(dir.path / c.file, dir.path);
    const bool bone = std::string(c.file) == "femur.obj";
    ASSERT_EQ(scene.soft.size(), bone ? 0u : 1u);
    const double scale = bone ? scene.rigid[1].geometry.scale : scene.soft[0].geometry.scale;
    EXPECT_NEAR(scale * c.per_metre, 1, 1e-9);
    EXPECT_FALSE(scene.lights.empty());
    run(scene, dir.path, bone ? 2 : 3);  // and the table, and a scalpel for what can be cut
    if (bone) continue;
    // As large as it was, and standing on the table.
    const Anatomy made = make_anatomy(scene.soft[0], {dir.path, {}, {}}, {});
    Eigen::AlignedBox3d box;
    for (const Vec3& x : made.surface.positions) box.extend(x);
    const double volume = std::abs(enclosed_volume(mesh));
    EXPECT_NEAR(tet_quality(made.tets).volume, volume, 0.1 * volume);
    EXPECT_NEAR(box.min()[1], 0.902, 0.004);
    EXPECT_NEAR(box.center()[0], 0, 0.005);
  }
}

TEST(DraftScene, AFolderIsABodyEach) {
  const TempDir dir;
  std::filesystem::create_directory(dir.path / "patient");
  const auto put_part = [&](const char* name, const std::string& shape, const Vec3& size, const Vec3& at) {
    TriangleMesh mesh = surface_of(shape, size, 0.012);
    for (Vec3& x : mesh.positions) x += at;
    write(dir.path / "patient" / name, as_text(name, mesh, 1000));
  };
  put_part("liver.stl", "liver", liver_size, {0.1, 1.2, 0.3});
  put_part("kidney.stl", "kidney", {0.06, 0.11, 0.05}, {-0.1, 1.2, 0.2});
  put_part("rib.obj", "cylinder", {0.03, 0.2, 0.03}, {0.2, 1.2, 0.1});
  write(dir.path / "patient" / "notes.txt", std::string("not a surface"));
  const SceneDesc scene = drafted(dir.path / "patient", dir.path);
  EXPECT_EQ(scene.name, "patient");
  ASSERT_EQ(scene.soft.size(), 2u);
  ASSERT_EQ(scene.rigid.size(), 3u);
  EXPECT_EQ(scene.rigid[1].name, "rib");
  EXPECT_EQ(scene.soft[0].name, "kidney");
  EXPECT_GT(scene.soft[0].material.youngs_modulus, scene.soft[1].material.youngs_modulus);  // by material
  EXPECT_EQ(scene.soft[0].pose.p, scene.soft[1].pose.p);  // they stay as they lie to each other
  EXPECT_TRUE(scene.rigid[1].part);
  run(scene, dir.path, 5);
}

TEST(DraftScene, ALabelMapIsAnAtlas) {
  for (const bool named : {false, true}) {
    const TempDir dir;
    write(dir.path / "map.inr", two_balls());
    if (named) write(dir.path / "map.csv", std::string("id,name\n7,liver\n9,kidney\n"));
    const SceneDesc scene = drafted(dir.path / "map.inr", dir.path);
    ASSERT_EQ(scene.atlases.size(), 1u);
    EXPECT_EQ(scene.atlases[0].labels, named ? "map.csv" : "");
    run(scene, dir.path, 4);
  }
}

/// The axes of a NIfTI file that says how it lies are the patient's; those of other files aren't known.
TEST(DraftScene, ALabelMapThatSaysHowItLiesHasAPatient) {
  const TempDir dir;
  write(dir.path / "plain.inr", two_balls());
  EXPECT_FALSE(drafted(dir.path / "plain.inr", dir.path).patient);
  Bytes file = nifti_header(two_balls_side, two_balls_side, two_balls_side, 2);
  put<std::int16_t>(file, 254, 1);
  for (std::size_t r = 0; r < 3; ++r) put(file, 280 + 20 * r, 2.f);
  const std::vector<std::uint8_t> voxels = two_balls_voxels();
  file.insert(file.end(), voxels.begin(), voxels.end());
  write(dir.path / "map.nii", file);
  const SceneDesc scene = drafted(dir.path / "map.nii", dir.path);
  ASSERT_TRUE(scene.patient);
  EXPECT_NEAR((scene.patient->right - Vec3::UnitX()).norm(), 0, 1e-6);
  EXPECT_NEAR((scene.patient->head - Vec3::UnitY()).norm(), 0, 1e-6) << "the volume's z is up";
  const SceneDesc lying = drafted(dir.path / "map.nii", dir.path, {.z_up = false});
  EXPECT_NEAR((lying.patient->head - Vec3::UnitZ()).norm(), 0, 1e-6);
}

TEST(DraftScene, AScalpelLiesOnTheTableBesideWhatCanBeCut) {
  const TempDir dir;
  const auto file = dir.path / "thing.obj";
  write(file, as_obj(box_surface(Vec3::Zero(), {0.1, 0.2, 0.3}), 1));
  const RigidDesc scalpel = drafted(file, dir.path).rigid.back();
  EXPECT_EQ(scalpel.name, "scalpel");
  EXPECT_EQ(scalpel.edges.size(), 2u);
  EXPECT_FALSE(scalpel.fixed);
  EXPECT_GT(scalpel.pose.p[0], 0.05 + 0.04) << "beside the box";
  EXPECT_LT(scalpel.pose.p[0], 0.3) << "on the table";
  for (const DraftOptions& without : {DraftOptions{.scalpel = false}, DraftOptions{.rigid = true}})
    EXPECT_EQ(drafted(file, dir.path, without).rigid.back().edges.size(), 0u);
  const auto named = dir.path / "scalpel.obj";
  write(named, as_obj(box_surface(Vec3::Zero(), {0.1, 0.2, 0.3}), 1));
  EXPECT_NE(complaint(named).find("--no-scalpel"), std::string::npos);
  EXPECT_EQ(drafted(named, dir.path, {.scalpel = false}).soft[0].name, "scalpel");
}

TEST(DraftScene, TetrahedralMeshesRunAsTheyAre) {
  // A block of six tetrahedra around a diagonal, 60 mm long.
  std::string gmsh = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n8\n";
  std::string vtk = "# vtk DataFile Version 3.0\nblock\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 double\n";
  for (int k = 0; k < 8; ++k) {
    const std::string point = fmt::format("{} {} {}\n", 60 * (k & 1), 40 * (k >> 1 & 1), 50 * (k >> 2 & 1));
    gmsh += fmt::format("{} {}", k + 1, point);
    vtk += point;
  }
  gmsh += "$EndNodes\n$Elements\n6\n";
  vtk += "CELLS 6 30\n";
  const int corners[6][2] = {{1, 3}, {3, 2}, {2, 6}, {6, 4}, {4, 5}, {5, 1}};
  for (int k = 0; k < 6; ++k) {
    gmsh += fmt::format("{} 4 2 0 1 1 {} {} 8\n", k + 1, corners[k][0] + 1, corners[k][1] + 1);
    vtk += fmt::format("4 0 {} {} 7\n", corners[k][0], corners[k][1]);
  }
  gmsh += "$EndElements\n";
  vtk += "CELL_TYPES 6\n10\n10\n10\n10\n10\n10\n";
  for (const auto& [name, text] :
       {std::pair<std::string, std::string>{"kidney.msh", gmsh}, {"femur.vtk", vtk}}) {
    SCOPED_TRACE(name);
    const TempDir dir;
    write(dir.path / name, text);
    const SceneDesc scene = drafted(dir.path / name, dir.path);
    ASSERT_EQ(scene.soft.size(), 1u);
    EXPECT_EQ(scene.soft[0].geometry.mesh, name);
    EXPECT_NEAR(scene.soft[0].geometry.scale, 1e-3, 1e-12);
    const Anatomy made = make_anatomy(scene.soft[0], {dir.path, {}, {}}, {});
    EXPECT_EQ(made.tets.tets.size(), 6u);
    EXPECT_NEAR(tet_quality(made.tets).volume, 1.2e-4, 1e-9);
    run(scene, dir.path, 3);
    EXPECT_NE(complaint(dir.path / name, {.rigid = true}).find("--rigid is for surfaces"), std::string::npos);
  }
}

TEST(DraftScene, WhatIsSaidIsDone) {
  const TempDir dir;
  const auto file = dir.path / "thing.obj";
  TriangleMesh open = box_surface(Vec3::Zero(), {0.1, 0.2, 0.3});
  write(file, as_obj(open, 1));
  EXPECT_EQ(drafted(file, dir.path, {.unit = 1e-2}).soft[0].geometry.scale, 1e-2);
  EXPECT_TRUE(drafted(file, dir.path, {.z_up = true})
                  .soft[0]
                  .pose.q.isApprox(Quat(std::sqrt(0.5), -std::sqrt(0.5), 0, 0), 1e-6));
  open.triangles.pop_back();
  write(file, as_obj(open, 1));
  EXPECT_EQ(drafted(file, dir.path, {.rigid = true}).rigid.size(), 2u);
  // From elsewhere the file is named in full.
  const TempDir other;
  EXPECT_EQ(drafted(file, other.path, {.rigid = true}).rigid[1].geometry.mesh,
            std::filesystem::canonical(file));
}

std::string notes_on(const std::filesystem::path& source) {
  std::string out;
  for (const std::string& note : draft_scene(source, source.parent_path(), {}).notes) out += note + "\n";
  return out;
}

TEST(DraftScene, LongNamesAreCut) {
  const TempDir dir;
  const std::string long_name =
      "Segment_1_left_kidney_cortex_and_medulla_without_vessels,_as_f\u00fcr_mich.off";
  write(dir.path / long_name, as_off(box_surface(Vec3::Zero(), {60, 40, 90}), 1));
  EXPECT_EQ(drafted(dir.path / long_name, dir.path).soft.at(0).name,
            "Segment 1 left kidney cortex and medulla without vessels, as f");
  EXPECT_NE(notes_on(dir.path / long_name)
                .find("the body's name is longer than 63 bytes: shortened to \"Segment 1"),
            std::string::npos);
}

TEST(DraftScene, VolumesAreThoseThatAreFilled) {
  const TempDir dir;
  TriangleMesh nested = box_surface(Vec3::Zero(), Vec3::Constant(80));
  append(nested, box_surface(Vec3::Constant(20), Vec3::Constant(60)));
  write(dir.path / "organ.off", as_off(nested, 1));
  const std::string notes = notes_on(dir.path / "organ.off");
  EXPECT_NE(notes.find("organ: 512 ml"), std::string::npos) << notes;
  EXPECT_NE(notes.find("organ: warning: 1 shell is inside another"), std::string::npos) << notes;
  run(drafted(dir.path / "organ.off", dir.path), dir.path, 3);
}

TEST(DraftScene, FilesFarFromTheirOriginAreBroughtToTheTable) {
  const TempDir dir;
  TriangleMesh far = box_surface(Vec3::Zero(), {60, 40, 90});
  for (Vec3& x : far.positions) x[0] += 2e6;
  write(dir.path / "far.off", as_off(far, 1));
  const SceneDesc scene = drafted(dir.path / "far.off", dir.path);
  ASSERT_EQ(scene.soft.size(), 1u);
  EXPECT_EQ(scene.soft[0].geometry.mesh_origin, Vec3(2000030, 20, 45));
  const Anatomy made = make_anatomy(scene.soft[0], {dir.path, {}, {}}, {});
  Eigen::AlignedBox3d box;
  for (const Vec3& x : made.surface.positions) box.extend(x);
  EXPECT_NEAR(box.min()[1], 0.902, 0.004);
  EXPECT_NEAR(box.center()[0], 0, 0.005);
  EXPECT_NEAR(tet_quality(made.tets).volume, 216e-6, 5e-6);
}

TEST(DraftScene, EndingsInCapitalsAreTheSame) {
  const TempDir dir;
  write(dir.path / "MAP.INR", two_balls());
  write(dir.path / "MAP.csv", std::string("id,name\n7,liver\n9,kidney\n"));
  EXPECT_EQ(drafted(dir.path / "MAP.INR", dir.path).atlases.at(0).labels, "MAP.csv");
}

TEST(DraftScene, GuessesTheUnitBySize) {
  struct {
    double usual, extent, unit;
  } const table[] = {{0.2, 210, 1e-3}, {0.2, 21, 1e-2}, {0.2, 0.21, 1},    {0.1, 60, 1e-3},
                     {0.1, 10, 1e-2},  {0.1, 0.08, 1},  {1.7, 1750, 1e-3}, {1.7, 1.8, 1}};
  for (const auto& row : table) EXPECT_EQ(guess_unit({row.usual}, {row.extent}), row.unit) << row.extent;
}

TEST(DraftScene, SaysWhatItCantUse) {
  const TempDir dir;
  const auto refused = [&](const char* name, const std::string& content, const char* why) {
    write(dir.path / name, content);
    const std::string said = complaint(dir.path / name);
    EXPECT_NE(said.find(why), std::string::npos) << name << ": " << said;
    EXPECT_NE(said.find(name), std::string::npos) << said;
  };
  TriangleMesh open = box_surface(Vec3::Zero(), Vec3::Constant(100));
  open.triangles.pop_back();
  refused("open.obj", as_obj(open, 1), "3 edges at the borders of holes");
  open.positions.emplace_back(50, 50, 200);
  open.triangles.push_back({0, 3, 8});  // a fin on an edge of two
  refused("crowded.obj", as_obj(open, 1), "more than two triangles");
  refused("page.html", "<html>", "unsupported; allowed: a surface (.obj");
  refused("bad.stl", "nothing", "not a surface");
  std::vector<std::uint8_t> grey;
  for (int i = 0; i < 8000; ++i) grey.push_back(static_cast<std::uint8_t>(1 + i * 7 % 50));
  const Bytes picture = inrimage(20, 20, 20, {1, 1, 1}, grey);
  refused("grey.inr", std::string(picture.begin(), picture.end()), "as in grey values");
  refused(
      "empty.inr",
      [] {
        const Bytes bytes = inrimage(2, 2, 2, {1, 1, 1}, std::vector<std::uint8_t>(8, 0));
        return std::string(bytes.begin(), bytes.end());
      }(),
      "no label has 64 voxels or more");
  EXPECT_NE(complaint(dir.path / "gone.obj").find("no such file"), std::string::npos);
  std::filesystem::create_directory(dir.path / "void");
  EXPECT_NE(complaint(dir.path / "void").find("contains no surface or tetrahedral mesh"), std::string::npos);
  TriangleMesh halves = box_surface(Vec3::Zero(), Vec3::Constant(40));
  append(halves, box_surface(Vec3::Constant(40), Vec3::Constant(80)));
  refused("halves.off", as_off(halves, 1),
          "contains 2 separate solids, the largest with 50 % of their volume");
  // A folder names all that is wrong in it.
  const auto folder = dir.path / "several";
  std::filesystem::create_directory(folder);
  write(folder / "a.obj", as_obj(open, 1));
  write(folder / "a.off", as_off(box_surface(Vec3::Zero(), Vec3::Constant(100)), 1));
  const std::string said = complaint(folder);
  EXPECT_NE(said.find("a.obj: not closed"), std::string::npos) << said;
  EXPECT_NE(said.find("a.off: another body is called \"a\""), std::string::npos) << said;
  write(folder / "bad\xff.off", std::string("OFF\n"));
  write(folder / "c.ply", std::string("ply\n"));
  write(folder / "._c.ply", std::string("what another system keeps beside its files"));
  const std::string more = complaint(folder);
  EXPECT_NE(more.find("the file's name becomes the body's name"), std::string::npos) << more;
  EXPECT_NE(more.find("c.ply: not a surface (line"), std::string::npos) << more;
  EXPECT_EQ(more.find("._c.ply"), std::string::npos) << more;
  EXPECT_EQ(std::ranges::count(more, '\n'), 3) << more;
  ASSERT_EQ(mkfifo((dir.path / "pipe.off").c_str(), 0600), 0);
  EXPECT_NE(complaint(dir.path / "pipe.off").find("is a pipe; allowed: a regular file"), std::string::npos);
}

}  // namespace
}  // namespace prosector
