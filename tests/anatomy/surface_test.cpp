#include <gtest/gtest.h>

#include <numbers>

#include "common/anatomy/implicit.h"
#include "common/anatomy/isosurface.h"
#include "common/anatomy/mesh_quality.h"
#include "common/anatomy/simplify.h"
#include "common/anatomy/surface_check.h"
#include "common/anatomy/surface_io.h"
#include "common/error.h"
#include "tests/anatomy/files.h"

namespace prosector {
namespace {

using namespace testing_files;

const std::string cube_off = R"(OFF
8 12 0
0 0 0
2 0 0
2 1 0
0 1 0
0 0 3
2 0 3
2 1 3
0 1 3
3 0 2 1
3 0 3 2
3 4 5 6
3 4 6 7
3 0 1 5
3 0 5 4
3 2 3 7
3 2 7 6
3 1 2 6
3 1 6 5
3 0 4 7
3 0 7 3
)";

std::string as_obj(const TriangleMesh& m) {
  std::string out;
  for (const Vec3& x : m.positions)
    out += "v " + std::to_string(x[0]) + " " + std::to_string(x[1]) + " " + std::to_string(x[2]) + "\n";
  for (const auto& t : m.triangles)
    out += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " + std::to_string(t[2] + 1) +
           "\n";
  return out;
}

std::string as_stl(const TriangleMesh& m) {
  std::string out = "solid s\n";
  for (const auto& t : m.triangles) {
    out += "facet normal 0 0 0\nouter loop\n";
    for (const auto v : t) {
      const Vec3& x = m.positions[v];
      out +=
          "vertex " + std::to_string(x[0]) + " " + std::to_string(x[1]) + " " + std::to_string(x[2]) + "\n";
    }
    out += "endloop\nendfacet\n";
  }
  return out + "endsolid s\n";
}

std::string as_ply(const TriangleMesh& m) {
  std::string out = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(m.positions.size()) +
                    "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                    std::to_string(m.triangles.size()) +
                    "\nproperty list uchar int vertex_index\nend_header\n";
  for (const Vec3& x : m.positions)
    out += std::to_string(x[0]) + " " + std::to_string(x[1]) + " " + std::to_string(x[2]) + "\n";
  for (const auto& t : m.triangles)
    out += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + "\n";
  return out;
}

TEST(Surface, EveryTextFormatGivesTheSameCuboid) {
  const TempDir dir;
  write(dir.path / "cube.off", cube_off);
  const TriangleMesh off = load_surface(dir.path / "cube.off", 1);
  write(dir.path / "cube.obj", as_obj(off));
  write(dir.path / "cube.stl", as_stl(off));
  write(dir.path / "cube.ply", as_ply(off));
  for (const char* name : {"cube.off", "cube.obj", "cube.stl", "cube.ply"}) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = load_surface(dir.path / name, 0.1);
    EXPECT_EQ(mesh.positions.size(), 8u);  // merged: STL repeats them
    EXPECT_EQ(mesh.triangles.size(), 12u);
    const SurfaceReport report = check_surface(mesh);
    EXPECT_EQ(report.warning(), "");
    EXPECT_NEAR(report.volume, 0.2 * 0.1 * 0.3, 1e-8);
    EXPECT_NEAR((report.center_of_mass - Vec3(0.1, 0.05, 0.15)).norm(), 0, 1e-7);
    EXPECT_NEAR(report.inertia(0, 0), report.volume * (0.01 + 0.09) / 12, 1e-9);
    EXPECT_NEAR(report.inertia(1, 1), report.volume * (0.04 + 0.09) / 12, 1e-9);
    EXPECT_NEAR(report.inertia(0, 1), 0, 1e-9);
  }
}

TEST(Surface, GltfTransformsAreApplied) {
  const TempDir dir;
  Bytes bin;
  const float x[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::uint16_t faces[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  for (std::size_t n = 0; n < 12; ++n) put(bin, 4 * n, x[n / 3][n % 3]);
  for (std::size_t n = 0; n < 12; ++n) put(bin, 48 + 2 * n, faces[n]);
  write(dir.path / "t.bin", bin);
  write(dir.path / "t.gltf", std::string(R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
    "nodes":[{"mesh":0,"translation":[1,2,3],"scale":[2,2,2]}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,1]},
                 {"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}],
    "bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],
    "buffers":[{"uri":"t.bin","byteLength":72}]})"));
  const SurfaceReport report = check_surface(load_surface(dir.path / "t.gltf", 1));
  EXPECT_NEAR(report.volume, 8.0 / 6, 1e-6);
  EXPECT_NEAR((report.center_of_mass - Vec3(1.5, 2.5, 3.5)).norm(), 0, 1e-6);
  EXPECT_EQ(report.open_edges, 0u);
}

TEST(Surface, BadFilesAreRefused) {
  const TempDir dir;
  EXPECT_THROW(load_surface(dir.path / "missing.obj", 1), InputError);
  write(dir.path / "garbage.obj", std::string("this is not a mesh\n"));
  EXPECT_THROW(load_surface(dir.path / "garbage.obj", 1), InputError);
  write(dir.path / "empty.off", std::string("OFF\n0 0 0\n"));
  EXPECT_THROW(load_surface(dir.path / "empty.off", 1), InputError);
  write(dir.path / "nan.obj", std::string("v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  EXPECT_THROW(load_surface(dir.path / "nan.obj", 1), InputError);
  write(dir.path / "cube.off", cube_off);
  EXPECT_THROW(load_surface(dir.path / "cube.off", 1000), InputError);  // 3 km
  EXPECT_THROW(load_surface(dir.path / "cube.off", 1e-6), InputError);
  EXPECT_THROW(load_surface(dir.path / "cube.off", 0), InputError);
  EXPECT_THROW(load_surface(dir.path / "cube.off", -1), InputError);
}

TEST(Surface, CheckNamesWhatIsWrong) {
  TriangleMesh ball = isosurface(implicit_shape("ball", Vec3::Constant(0.1)), 0.01);
  EXPECT_EQ(check_surface(ball).warning(), "");
  TriangleMesh open = ball;
  open.triangles.pop_back();
  EXPECT_EQ(check_surface(open).open_edges, 3u);
  TriangleMesh inward = ball;
  for (auto& t : inward.triangles) std::swap(t[0], t[1]);
  EXPECT_NE(check_surface(inward).warning().find("inward"), std::string::npos);
  TriangleMesh twice = ball;
  const auto n = static_cast<std::uint32_t>(ball.positions.size());
  for (const Vec3& x : ball.positions) twice.positions.push_back(x + Vec3(0.04, 0.003, 0.001));
  for (const auto& t : ball.triangles) twice.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  EXPECT_GT(check_surface(twice).intersecting_pairs, 10u);
}

TEST(Surface, SimplifyKeepsClosedSurfacesClosedAndNear) {
  for (const char* name : {"liver", "kidney", "femur"}) {
    SCOPED_TRACE(name);
    const SolidField field = implicit_shape(name, natural_size(name));
    const double fine = natural_size(name).minCoeff() / 16;
    const TriangleMesh before = isosurface(field, fine);
    const TriangleMesh after = simplify(before, 2 * fine);
    EXPECT_LT(after.triangles.size(), before.triangles.size() / 2);
    const SurfaceReport a = check_surface(after), b = check_surface(before);
    EXPECT_EQ(a.open_edges, 0u);
    EXPECT_NEAR(a.volume, b.volume, 0.08 * b.volume);
  }
}

}  // namespace
}  // namespace prosector
