#pragma once
// Bullet's soft bodies on the same meshes, with Bullet's usual settings.

#include <memory>
#include <string>
#include <vector>

#include "server/calibration/specimen.h"
#include "tests/bench/report.h"

namespace prosector {

struct BulletRung {
  std::string model;   // classic | deformable_linear | deformable_neo_hookean
  int iterations = 1;  // position iterations of the classic body; deformable bodies choose their own
};
std::vector<BulletRung> bullet_rungs();

/// Returns the report columns of the configuration.
ReportRow settings(const BulletRung& rung);

/// Creates a Bullet soft body in single precision, as packaged. The classic body has links of full stiffness
/// on the tetrahedra's edges, without Young's modulus. Mass-proportional damping, which Bullet lacks, is
/// applied after each step.
std::unique_ptr<Specimen> make_specimen(const BulletRung& rung, const TestPiece& piece);

}  // namespace prosector
