// What surface files get wrong, and what becomes of it: by bodies' volumes.

#include "common/anatomy/surface_repair.h"

#include <gtest/gtest.h>

#include <random>

#include "common/anatomy/coincident_points.h"
#include "common/anatomy/mesh_quality.h"
#include "common/anatomy/sources.h"
#include "common/anatomy/surface_check.h"
#include "common/anatomy/surface_field.h"
#include "common/anatomy/surface_formats.h"
#include "common/anatomy/surface_io.h"
#include "common/anatomy/winding_tree.h"
#include "common/error.h"
#include "tests/anatomy/files.h"
#include "tests/anatomy/reported_lines.h"
#include "tests/draft/surface_texts.h"

namespace prosector {
namespace {

using namespace testing_files;

TriangleMesh box(double low, double high) {
  return box_surface(Vec3::Constant(low), Vec3::Constant(high));
}

TriangleMesh turned(TriangleMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
  append(a, b);
  return a;
}

struct Filled {
  double volume = 0;  // ml
  std::string refusal;
  Lines said;
};

/// Fills a surface given in mm.
Filled filled(const TriangleMesh& mesh, double accepted = 0, double cell = 0.008) {
  const TempDir dir;
  write(dir.path / "organ.off", as_off(mesh, 1));
  SoftDesc desc;
  desc.name = "organ";
  desc.geometry.mesh = "organ.off";
  desc.geometry.scale = 1e-3;
  desc.geometry.cell = cell;
  desc.geometry.surface_cell = 0.006;
  desc.geometry.max_volume_error.value = accepted;
  Filled out;
  try {
    out.volume = 1e6 * tet_quality(make_anatomy(desc, {dir.path, {}, {}}, out.said.progress()).tets).volume;
  } catch (const InputError& error) {
    out.refusal = error.what();
  }
  return out;
}

TEST(SurfaceRepair, ShellsWithinShellsAreFilledOrCavities) {
  const Filled nested = filled(together(box(0, 80), box(20, 60)));
  EXPECT_NEAR(nested.volume, 512, 10) << nested.refusal;
  EXPECT_TRUE(nested.said.say(
      "organ: warning: 1 shell is inside another and faces outward like it and encloses nothing"));
  const Filled hollow = filled(together(box(0, 80), turned(box(20, 60))));
  EXPECT_NEAR(hollow.volume, 448, 10) << hollow.refusal;
  EXPECT_TRUE(hollow.said.say("1 shell within another faces inward: a cavity"));
  // The whole file inside out, and a shell in a cavity.
  EXPECT_NEAR(filled(together(turned(box(0, 80)), box(20, 60))).volume, 448, 10);
  const SolidShells stone = solid_shells(together(together(box(0, 80), turned(box(20, 60))), box(30, 50)));
  EXPECT_EQ(stone.solids, (std::vector<double>{448000, 8000}));
}

TEST(SurfaceRepair, SeparateSolidsAreRefusedUnlessAsked) {
  TriangleMesh corner = together(box(0, 40), box(40, 80));  // one vertex is the same, as voxels' corners are
  const Filled refused = filled(corner, 0, 0.012);
  EXPECT_NE(refused.refusal.find("organ: its volume is 6"), std::string::npos) << refused.refusal;
  EXPECT_NE(refused.refusal.find("% less than the 128 ml that its file encloses"), std::string::npos)
      << refused.refusal;
  EXPECT_NE(refused.refusal.find("write separate solids to separate files"), std::string::npos);
  EXPECT_NE(refused.refusal.find("max_volume_error = \"5"), std::string::npos) << refused.refusal;
  EXPECT_TRUE(refused.said.say("2 separate solids in the file: the largest is used, 64 of 128 ml"));
  const Filled asked = filled(corner, 60, 0.012);
  EXPECT_NEAR(asked.volume, 64, 5) << asked.refusal;
  EXPECT_TRUE(asked.said.say("organ: warning: its volume is 6"));
  // One that faces inward beside one that faces outward.
  EXPECT_NEAR(filled(together(box(0, 80), turned(box(100, 120)))).volume, 512, 10);
}

TEST(SurfaceRepair, CrossingShellsAreFilledOnce) {
  const Filled made = filled(together(box(0, 60), box_surface({30, 31, 29}, {80, 81, 79})));
  EXPECT_NEAR(made.volume, 216 + 125 - 30 * 29 * 31 * 1e-3, 8) << made.refusal;
  EXPECT_TRUE(made.said.say("warning: its surface intersects itself"));
  // Edges that meet others' edges don't count as crossing; the volume is right all the same.
  const Filled aligned = filled(together(box(0, 60), box(30, 80)));
  EXPECT_NEAR(aligned.volume, 216 + 125 - 27, 8) << aligned.refusal;
  EXPECT_FALSE(aligned.said.say("separate solids"));
}

TEST(SurfaceRepair, CracksOfRoundingAreClosed) {
  std::mt19937_64 random(3);
  TriangleMesh cracked;
  for (const auto& t : box(0, 60).triangles) {
    for (const std::uint32_t v : t)
      cracked.positions.push_back(box(0, 60).positions[v] + Vec3::NullaryExpr([&] {
                                    return 6e-6 * (static_cast<double>(random() % 3) - 1);
                                  }));
    const auto n = static_cast<std::uint32_t>(cracked.positions.size());
    cracked.triangles.push_back({n - 3, n - 2, n - 1});
  }
  const Filled made = filled(cracked);
  EXPECT_NEAR(made.volume, 216, 6) << made.refusal;
  EXPECT_TRUE(made.said.say("repaired: 28 vertices within")) << made.said.lines.front();
  // What is farther apart than rounding stays open.
  for (std::size_t v = 0; v < 3; ++v) cracked.positions[v] += Vec3(0.1, 0, 0);
  EXPECT_NE(filled(cracked).refusal.find("at the borders of holes"), std::string::npos);
}

TEST(SurfaceRepair, InconsistentWindingIsTurned) {
  TriangleMesh mesh = box(0, 60);
  for (const std::size_t t : {1u, 4u, 10u}) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
  const Filled made = filled(mesh);
  EXPECT_NEAR(made.volume, 216, 6) << made.refusal;
  EXPECT_TRUE(made.said.say("repaired: 3 triangles with inconsistent orientation are flipped"));
  EXPECT_TRUE(repaired(box(0, 60)).notes.empty());
}

TEST(SurfaceRepair, TrianglesThatAreThereTwiceAreDropped) {
  TriangleMesh mesh = box(0, 60);
  mesh.triangles.push_back(mesh.triangles[3]);
  EXPECT_NEAR(filled(mesh).volume, 216, 6);
  // Two boxes with a wall between them, seen from both.
  TriangleMesh two =
      together(box_surface(Vec3::Zero(), {60, 60, 60}), box_surface({60, 0, 0}, {120, 60, 60}));
  const Filled made = filled(two);
  EXPECT_NEAR(made.volume, 432, 8) << made.refusal;
}

TEST(SurfaceRepair, FilesFarFromTheirOriginNameTheRemedy) {
  const TempDir dir;
  TriangleMesh mesh = box(0, 60);
  for (Vec3& x : mesh.positions) x[0] += 2e6;
  write(dir.path / "far.off", as_off(mesh, 1));
  try {
    load_surface(dir.path / "far.off", 1e-3);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("mesh_origin = [2.00003e+06, 30, 30]"), std::string::npos)
        << error.what();
  }
  Lines said;
  const TriangleMesh near =
      load_surface(dir.path / "far.off", 1e-3, {.origin = Vec3(2e6, 0, 0), .report = said.progress()});
  EXPECT_NEAR(enclosed_volume(near), 216e-6, 1e-8);
  EXPECT_TRUE(said.say("single precision rounds them to 0.24, at a size of 60"));
}

TEST(SurfaceRepair, RigidBodiesSayWhatTheirMassIsOff) {
  const TempDir dir;
  RigidDesc desc;
  desc.name = "bone";
  desc.geometry.mesh = "bone.off";
  desc.geometry.scale = 1e-3;
  const auto said_of = [&](const TriangleMesh& mesh) {
    write(dir.path / "bone.off", as_off(mesh, 1));
    Lines said;
    make_surface(desc, {dir.path, {}, {}}, said.progress());
    return said;
  };
  EXPECT_TRUE(
      said_of(together(box(0, 80), box(20, 60))).say("bone: warning: its volume is 576 ml, 12.5 % more"));
  EXPECT_EQ(said_of(box(0, 80)).lines.size(), 1u);
  EXPECT_THROW(said_of(together(box(0, 80), box(2, 78))), InputError);
  TriangleMesh open = box(0, 80);
  open.triangles.pop_back();
  EXPECT_TRUE(said_of(open).say("not closed: the surface has 3 open"));
}

TEST(WindingTree, IsTheSumOfSolidAngles) {
  const TriangleMesh ball = surface_of("ball", Vec3::Constant(0.2), 0.012);
  const WindingTree one(ball), two(together(ball, ball));
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> at(-0.15, 0.15);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 x(at(random), at(random), at(random));
    if (std::abs(x.norm() - 0.1) < 2e-3) continue;
    const double inside = x.norm() < 0.1 ? 1 : 0;
    EXPECT_NEAR(one.at(x), inside, 0.03) << x.transpose();
    EXPECT_NEAR(two.at(x), 2 * inside, 0.06) << x.transpose();
  }
}

TEST(ClosePoints, StandForThoseWithinTheTolerance) {
  const std::vector<Vec3> points = {{0, 0, 0},    {1e-7, 0, 0}, {1, 0, 0},
                                    {0, 2e-6, 0}, {1, 1e-6, 0}, {-1, 0, 0}};
  EXPECT_EQ(coincident_points(points, 1e-6), (std::vector<std::uint32_t>{0, 0, 2, 3, 2, 5}));
  EXPECT_EQ(coincident_points(points, 0), (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_TRUE(coincident_points({}, 1).empty());
  // Against all pairs.
  std::mt19937_64 random(5);
  std::vector<Vec3> many;
  for (int i = 0; i < 400; ++i)
    many.push_back(Vec3::NullaryExpr([&] { return 0.01 * static_cast<double>(random() % 9); }));
  const auto found = coincident_points(many, 1e-9);
  for (std::size_t i = 0; i < many.size(); ++i)
    EXPECT_EQ(found[i], std::ranges::find(many, many[i]) - many.begin());
}

std::string stl_binary(const TriangleMesh& mesh) {
  std::string out = "solid, and binary all the same";
  out.resize(80, ' ');
  const auto put_bytes = [&](auto value) {
    out.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  put_bytes(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) put_bytes(0.f);
    for (const std::uint32_t v : t)
      for (int k = 0; k < 3; ++k) put_bytes(static_cast<float>(mesh.positions[v][k]));
    put_bytes(std::uint16_t{0});
  }
  return out;
}

std::string refusal_of(const auto& parse) {
  try {
    parse();
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Stl, BinaryIsToldByItsSize) {
  const std::string whole = stl_binary(box(0, 2));
  std::vector<std::string> notes;
  EXPECT_NEAR(enclosed_volume(parse_stl(whole, notes)), 8, 1e-9);
  EXPECT_TRUE(notes.empty());
  EXPECT_NEAR(enclosed_volume(parse_stl(whole + "\r\n", notes)), 8, 1e-9);
  EXPECT_EQ(notes, std::vector<std::string>{"2 bytes after its last triangle are ignored"});
  std::string other = whole;
  other[0] = 'x';
  EXPECT_NE(refusal_of([&] {
              parse_stl(other.substr(0, 600), notes);
            }).find("its 12 triangles need 684 bytes, but it has 600"),
            std::string::npos);
  EXPECT_NE(refusal_of([&] { parse_stl("hello", notes); }), "");
  EXPECT_NEAR(enclosed_volume(parse_stl(as_stl(box(0, 2), 1), notes)), 8, 1e-9);
  std::string upper = as_stl(box(0, 2), 1);
  for (char& c : upper) c = static_cast<char>(std::toupper(c));
  EXPECT_NEAR(enclosed_volume(parse_stl(upper, notes)), 8, 1e-9);
}

TEST(Ply, EveryEncodingAndPolygons) {
  const std::string header =
      "comment by a test\nelement vertex 8\nproperty double x\nproperty double y\nproperty double "
      "z\nproperty uchar "
      "red\nelement face 6\nproperty list uchar uint vertex_index\nelement edge 1\nproperty int "
      "a\nend_header\n";
  constexpr std::uint32_t quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  const TriangleMesh cube = box(0, 2);
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    std::string text = fmt::format("ply\nformat {} 1.0\n", format) + header;
    const auto add = [&](auto value) {
      if (format[0] == 'a') {
        text += fmt::format("{} ", static_cast<double>(value));
        return;
      }
      std::string bytes(reinterpret_cast<const char*>(&value), sizeof(value));
      if (format[7] == 'b') std::ranges::reverse(bytes);
      text += bytes;
    };
    for (const Vec3& x : cube.positions) {
      for (int k = 0; k < 3; ++k) add(x[k]);
      add(std::uint8_t{7});
    }
    for (const auto& quad : quads) {
      add(std::uint8_t{4});
      for (const std::uint32_t v : quad) add(v);
    }
    add(std::int32_t{1});
    std::vector<std::string> notes;
    EXPECT_NEAR(enclosed_volume(parse_ply(text, notes)), 8, 1e-9) << format;
    EXPECT_EQ(notes, std::vector<std::string>{"1 elements \"edge\" are not used"});
    for (std::size_t size = 0; size + 1 < text.size(); ++size)
      EXPECT_NE(refusal_of([&] { parse_ply(text.substr(0, size), notes); }), "") << format << size;
  }
}

// Four corners, one of them a dent: no diagonal but the one at the dent splits it.
TEST(Ply, DentedPolygonsAreSplitAtTheDent) {
  std::vector<std::string> notes;
  for (int first = 0; first < 4; ++first) {
    std::string text =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
        "z\nelement face "
        "1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n2 1 0\n0 2 0\n0.5 1 0\n4";
    for (int k = 0; k < 4; ++k) text += fmt::format(" {}", (first + k) % 4);
    const TriangleMesh mesh = parse_ply(text + "\n", notes);
    ASSERT_EQ(mesh.triangles.size(), 2u);
    for (const auto& t : mesh.triangles)
      EXPECT_GT(
          (mesh.positions[t[1]] - mesh.positions[t[0]]).cross(mesh.positions[t[2]] - mesh.positions[t[0]])[2],
          0);
  }
}

}  // namespace
}  // namespace prosector
