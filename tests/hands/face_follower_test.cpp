// Which face is the user's: what text and covers are taken for leads no view.
#include "drivers/camera/face/face_follower.h"

#include <gtest/gtest.h>

#include <vector>

namespace prosector {
namespace {

constexpr std::int64_t step_ns = 33'333'333;

PlacedFace face_at(const Vec3& place, double score) {
  PlacedFace out;
  out.score = score;
  out.eyes.head.p = place;
  return out;
}

const Vec3 desk(0.05, 0.02, 0.6);

class FollowedFace : public testing::Test {
 protected:
  /// Shows the same faces for so long. Returns the face that leads at the end.
  std::optional<EyesPose> show(const std::vector<PlacedFace>& faces, double seconds) {
    std::optional<EyesPose> out;
    for (const std::int64_t end_ns = now_ns_ + std::llround(1e9 * seconds); now_ns_ < end_ns;
         now_ns_ += step_ns) {
      out = follower_.follow(faces, now_ns_);
      leads_ += out.has_value();
    }
    return out;
  }

  FaceFollower follower_;
  std::int64_t now_ns_ = 1'000'000'000;
  int leads_ = 0;  // images in which one led
};

TEST_F(FollowedFace, LeadsOnceItWasSeenForHalfASecond) {
  EXPECT_FALSE(show({face_at(desk, 0.95)}, 0.4));
  EXPECT_TRUE(show({face_at(desk, 0.95)}, 0.3));
  EXPECT_TRUE(show({face_at(desk, 0.55)}, 1)) << "it turns away: a known face needs less";
}

TEST_F(FollowedFace, IsNoneWithALowScoreATooOddPlaceOrForAMoment) {
  show({face_at(desk, 0.69)}, 3);
  show({face_at({0, 0, 3.5}, 0.95)}, 3);
  show({face_at({0, 0, 0.1}, 0.95)}, 3);
  PlacedFace lying = face_at(desk, 0.95);
  lying.eyes.roll = 1.5;
  show({lying}, 3);
  for (int k = 0; k < 10; ++k) {  // flickers
    show({face_at(desk, 0.95)}, 0.2);
    show({}, 0.6);
  }
  for (int k = 0; k < 40; ++k)  // leaps
    show({face_at({k % 2 == 0 ? -0.3 : 0.3, 0, 0.6}, 0.95)}, 0.1);
  EXPECT_EQ(leads_, 0);
}

TEST_F(FollowedFace, StaysTheUsersBesideOthers) {
  ASSERT_TRUE(show({face_at(desk, 0.95)}, 1));
  const PlacedFace cover = face_at({-0.2, 0.1, 0.5}, 0.65), bystander = face_at({0.3, 0, 0.8}, 0.95);
  for (int k = 0; k < 60; ++k) {
    const Vec3 moved = desk + Vec3(0.004 * k, 0, 0);
    const auto leads = show({cover, face_at(moved, 0.6), bystander}, 0.04);
    ASSERT_TRUE(leads) << k;
    EXPECT_LT((leads->head.p - moved).norm(), 1e-9) << k;
  }
}

TEST_F(FollowedFace, GivesWayToAMuchNearerOneOrWhenItIsGone) {
  ASSERT_TRUE(show({face_at(desk, 0.95)}, 1));
  const Vec3 near(-0.2, 0, 0.3), far(0.4, 0, 0.9);
  const auto nearer = show({face_at(near, 0.95), face_at(desk, 0.95)}, 0.8);
  ASSERT_TRUE(nearer);
  EXPECT_EQ(nearer->head.p, near);
  EXPECT_FALSE(show({face_at(far, 0.95)}, 0.3)) << "lost, and the other one isn't believed yet";
  const auto next = show({face_at(far, 0.95)}, 0.5);
  ASSERT_TRUE(next);
  EXPECT_EQ(next->head.p, far);
}

}  // namespace
}  // namespace prosector
