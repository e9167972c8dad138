// The CT volume and the bones that the set-up fetches, where they are there.

#include <gtest/gtest.h>

#include "common/anatomy/mesh_quality.h"
#include "common/anatomy/sources.h"
#include "common/anatomy/surface_check.h"
#include "common/paths.h"

namespace prosector {
namespace {

std::string find_in_data(const std::string& name) {
  std::error_code error;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(default_data_dir(), error))
    if (entry.path().filename() == name) return entry.path().string();
  return "";
}

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
      d.volume = file;
      d.label = organ.label;
      d.cell = cell;
      d.surface_cell = cell / 2;
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

TEST(RealData, Bones) {
  for (const char* name : {"femur.off", "bones.off"}) {
    const std::string file = find_in_data(name);
    if (file.empty()) GTEST_SKIP() << name << " is not below " << default_data_dir();
    RigidDesc d;
    d.name = name;
    d.mesh = file;
    EXPECT_EQ(check_surface(make_surface(d, {}, {})).open_edges, 0u) << name;
  }
}

}  // namespace
}  // namespace prosector
