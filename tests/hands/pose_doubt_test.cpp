// A hand that turns over in a picture or two is not believed; one that moves as hands do always is.
#include "drivers/camera/hands/jump_filter.h"

#include <gtest/gtest.h>

#include "tests/random.h"

namespace prosector {
namespace {

Quat turned(double angle, const Vec3& axis) {
  return Quat(Eigen::AngleAxisd(angle, axis.normalized()));
}

TEST(JumpFilter, BelievesWhateverHandsDo) {
  Random random(1);
  for (int way = 0; way < 200; ++way) {
    JumpFilter filter;
    Pose palm{random.point(0.5), turned(random.uniform(0, 3), random.point(1))};
    std::int64_t time = 5;
    for (int k = 0; k < 40; ++k) {
      EXPECT_TRUE(filter.accepts_pose(palm, time)) << way << " " << k;
      const double seconds = random.uniform(0.01, 0.07);
      time += static_cast<std::int64_t>(1e9 * seconds);
      palm.p += 4 * seconds * random.point(1).normalized();
      palm.q = (turned(20 * seconds, random.point(1)) * palm.q).normalized();
    }
  }
}

TEST(JumpFilter, PassesOverHandsThatTurnOverOrLeapForLessThanThreePictures) {
  Random random(2);
  for (int way = 0; way < 200; ++way) {
    JumpFilter filter;
    const Pose palm{random.point(0.5), turned(random.uniform(0, 3), random.point(1))};
    Pose stray = palm;
    if (way % 2 == 0)
      stray.q = (turned(random.uniform(2, 3.1), random.point(1)) * palm.q).normalized();
    else
      stray.p += random.uniform(0.6, 1) * random.point(1).normalized();
    std::int64_t time = 0;
    for (int k = 0; k < 30; ++k, time += 33'000'000)
      EXPECT_EQ(filter.accepts_pose(k % 5 == 3 || k % 10 == 4 ? stray : palm, time),
                k % 5 != 3 && k % 10 != 4);
    for (int k = 0; k < 5; ++k, time += 33'000'000) EXPECT_EQ(filter.accepts_pose(stray, time), k >= 2) << k;
    filter.forget();
    EXPECT_TRUE(filter.accepts_pose(palm, time));
  }
}

TEST(JumpFilter, BelievesNoneOfPosesThatAreElsewhereEachTime) {
  Random random(3);
  JumpFilter filter;
  const Pose palm{Vec3(0, 0, 0.5), Quat::Identity()};
  EXPECT_TRUE(filter.accepts_pose(palm, 0));
  for (int k = 1; k < 8; ++k)
    EXPECT_FALSE(filter.accepts_pose({k % 2 == 0 ? palm.p : Vec3(2, 0, 0.5), turned(2.5, Vec3::Unit(k % 3))},
                                     k * 33'000'000));
}

}  // namespace
}  // namespace prosector
