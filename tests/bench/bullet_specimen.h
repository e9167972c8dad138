#pragma once
// Bullet's own soft bodies on the same meshes, as Bullet's users would set them up.

#include <memory>
#include <string>
#include <vector>

#include "server/calibration/specimen.h"
#include "tests/bench/report.h"

namespace prosector {

struct BulletRung {
  std::string model;   // classic | deformable_linear | deformable_neo_hookean
  int iterations = 1;  // of the classic body's positions; the deformable ones choose their own
};
std::vector<BulletRung> bullet_rungs();

/// As the columns of a report.
ReportRow settings(const BulletRung& rung);

/// Single precision, as packaged. The classic body has links of full stiffness on the tetrahedra's edges: it
/// knows no Young's modulus. Mass-proportional damping, which Bullet has not, is applied after each step.
std::unique_ptr<Specimen> make_specimen(const BulletRung& rung, const TestPiece& piece);

}  // namespace prosector
