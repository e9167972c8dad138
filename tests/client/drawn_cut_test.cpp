// Cuts that a person at a desk draws through the liver of cut.toml, which is under tension, on machines that
// keep up and on ones that don't.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "common/paths.h"
#include "common/scene/load_scene.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/client/acted_desk.h"
#include "tests/folders.h"
#include "tests/real_data.h"

namespace prosector::test {
namespace {

const Vec3 handle(0.23, 0.91, 0.12), begin(-0.08, 1.03, -0.02), end(0.06, 1.03, -0.02);  // m

/// Returns the farthest that nodes that were one before a cut are apart, m.
double opening(const Simulation& simulation, BodyId body) {
  const std::vector<Vec3>& rest = simulation.soft(body).anatomy().tets.positions;
  const VecX& x = simulation.soft_state(body).motion.x;
  const auto now = [&](std::size_t n) { return x.segment<3>(3 * static_cast<Eigen::Index>(n)); };
  std::map<std::array<double, 3>, std::size_t> first;
  double out = 0;
  for (std::size_t n = 0; n < rest.size(); ++n) {
    const auto [twin, is_first] = first.try_emplace({rest[n].x(), rest[n].y(), rest[n].z()}, n);
    if (!is_first) out = std::max(out, (now(n) - now(twin->second)).norm());
  }
  return out;
}

class DrawnCutUnderTension : public testing::TestWithParam<Haste> {};

TEST_P(DrawnCutUnderTension, IsAsLongAsTheWayGapesAndIsTakenBack) {
  if (find_in_data("liver.inr.gz").empty())
    GTEST_SKIP() << "liver.inr.gz is not below " << default_data_dir();
  CompileOptions options;
  options.threads = 1;
  options.data_dirs = {default_data_dir()};
  Simulation simulation(load_scene(source_path("deploy/scenes/cut.toml")), options);
  const BodyId knife = body_named(simulation, "knife"), liver = body_named(simulation, "liver");
  const std::uint64_t whole = simulation.soft(liver).content_hash();
  ActedDesk desk(simulation, GetParam());
  desk.point_at(handle);
  desk.wait(1);
  desk.press();
  ASSERT_TRUE(desk.waits_until_held(knife, true, 5));
  desk.let_go();
  desk.wait(1.5);
  desk.draw(handle, begin, 1);
  desk.wait(1.5);
  ASSERT_EQ(simulation.revision(liver), 0U) << "cut before the button went down";
  desk.press();
  desk.draw(begin, end, 2);
  desk.let_go();
  for (int k = 0; k < 120 && desk.draws(); ++k) desk.wait(0.5);
  for (int k = 0; k < 40 && desk.strokes().empty(); ++k) desk.wait(0.5);
  EXPECT_TRUE(desk.holds(knife));
  EXPECT_TRUE(desk.messages().empty()) << desk.messages().front();
  ASSERT_EQ(desk.strokes().size(), 1U);
  const StrokeFigures& stroke = desk.strokes()[0];
  EXPECT_GT(stroke.length, 0.09);
  EXPECT_LT(stroke.length, 0.2);
  EXPECT_GT(stroke.depth, 0.006);
  EXPECT_LT(stroke.depth, 0.018);
  EXPECT_GT(opening(simulation, liver), 0.002);
  desk.take_back();
  desk.wait(2);
  EXPECT_EQ(simulation.soft(liver).content_hash(), whole);
  EXPECT_LT(simulation.max_displacement(liver), 0.005);
}

std::string machine_name(const testing::TestParamInfo<Haste>& info) {
  constexpr std::array<const char*, 3> names = {"ThatKeepUp", "ThatStall", "ThatHang"};
  return names[info.index];
}
INSTANTIATE_TEST_SUITE_P(
    Machines, DrawnCutUnderTension,
    testing::Values(Haste{}, Haste{.picture_ms = 30, .tick_ms = 30, .stall_ms = 400},
                    Haste{.picture_ms = 300, .tick_ms = 100, .delay_ms = 100, .stall_ms = 950}),
    machine_name);

}  // namespace
}  // namespace prosector::test
