// The CT volume and the bones that the set-up fetches, where they are there.

#include <gtest/gtest.h>

#include "common/anatomy/mesh_quality.h"
#include "common/anatomy/sources.h"
#include "common/anatomy/surface_check.h"
#include "tests/real_data.h"

namespace prosector {
namespace {

struct Organ {
  const char* name;
  int label;
  double volume;  // m³
  std::vector<double> cells;
};

TEST(RealData, OrgansOfTheAbdominalCt) {
  const std::string file = find_in_data("liver.inr.gz");
  if (file.empty()) GTEST_SKIP() << "liver.inr.gz is not below " << default_data_dir();
  for (const Organ& organ :
       {Organ{"liver", 255, 1.605e-3, {0.014}}, Organ{"right kidney", 127, 0.160e-3, {0.01}},
        Organ{"gallbladder", 85, 8.5e-6, {0.004, 0.006}}})
    for (const double cell : organ.cells) {
      SCOPED_TRACE(std::string(organ.name) + " at " + std::to_string(cell));
      SoftDesc d;
      d.name = organ.name;
      d.geometry.volume = file;
      d.geometry.label = organ.label;
      d.geometry.cell = cell;
      d.geometry.surface_cell = cell / 2;
      const Anatomy a = make_anatomy(d, {}, {});
      const TetQuality q = tet_quality(a.tets);
      EXPECT_GE(q.min_dihedral_deg, 10);
      EXPECT_EQ(q.non_manifold_edges, 0u);
      EXPECT_EQ(q.components, 1u);
      EXPECT_NEAR(q.volume, organ.volume, 0.2 * organ.volume);
      const SurfaceReport surface = check_surface(a.surface);
      EXPECT_EQ(surface.warning(), "");
      EXPECT_NEAR(surface.volume, organ.volume, 0.05 * organ.volume);
    }
}

// Thresholds of deploy/scenes/head.toml. An adult's skull without jaw holds about 0.5 to 0.9 l of bone, a
// brain 1.1 to 1.7 l.
TEST(RealData, SkullAndBrainByThreshold) {
  const std::string ct = find_in_data("head.nii"), mri = find_in_data("brain.nii.gz");
  if (ct.empty() || mri.empty())
    GTEST_SKIP() << "head.nii or brain.nii.gz is not below " << default_data_dir();
  RigidDesc skull;
  skull.name = "skull";
  skull.geometry.volume = ct;
  skull.geometry.threshold = 170;
  skull.geometry.surface_cell = 0.006;
  const TriangleMesh bone = make_surface(skull, {}, {});
  const SurfaceReport report = check_surface(bone);
  EXPECT_EQ(report.open_edges, 0u);
  EXPECT_GT(report.volume, 0.5e-3);
  EXPECT_LT(report.volume, 0.9e-3);
  Vec3 low = bone.positions.front(), high = low;
  for (const Vec3& x : bone.positions) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  // x right, y front, z up: a head is longer than wide, and the scan ends below at the upper jaw.
  EXPECT_GT(high.y() - low.y(), high.x() - low.x());
  EXPECT_NEAR(low.z(), -0.5 * 108 * 0.0015, 0.002);

  SoftDesc brain;
  brain.name = "brain";
  brain.geometry.volume = mri;
  brain.geometry.threshold = 60;
  brain.geometry.cell = 0.013;
  brain.geometry.surface_cell = 0.006;
  const TetQuality quality = tet_quality(make_anatomy(brain, {}, {}).tets);
  EXPECT_GE(quality.min_dihedral_deg, 10);
  EXPECT_GT(quality.volume, 1.1e-3);
  EXPECT_LT(quality.volume, 1.7e-3);
}

TEST(RealData, Bones) {
  for (const char* name : {"femur.off", "bones.off"}) {
    const std::string file = find_in_data(name);
    if (file.empty()) GTEST_SKIP() << name << " is not below " << default_data_dir();
    RigidDesc d;
    d.name = name;
    d.geometry.mesh = file;
    EXPECT_EQ(check_surface(make_surface(d, {}, {})).open_edges, 0u) << name;
  }
}

}  // namespace
}  // namespace prosector
