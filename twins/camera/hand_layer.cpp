#include "twins/camera/hand_layer.h"

#include <cmath>

#include "common/smooth_normals.h"

namespace prosector {
namespace {

// Relative changes of the skin's tone.
constexpr float palm_light = 0.18F, palm_fold = 0.25F, back_fold = 0.1F, knuckle_red = 0.12F;
constexpr double fold_width = 0.003;  // m
constexpr Rgb nail = {1.15F, 1.25F, 1.3F};

/// Position of a vertex on the nearest finger segment.
struct OnFinger {
  std::size_t joint = 0;
  double along = 0;     // m from the joint
  double back = 0;      // −1 to 1: component of its normal out of the hand's back
  double distance = 1;  // m from the segment's centre
};

OnFinger find_on_finger(const std::array<Pose, hand_joints>& joints, std::size_t hand, const Vec3& x,
                        const Vec3& normal) {
  const auto& segments = hand_segments(hand);
  OnFinger out;
  for (std::size_t j = 0; j < hand_joints; ++j) {
    const double far = (x - joints[j] * Vec3(0, 0, -segments[j].length / 2)).norm();
    if (far >= out.distance) continue;
    out = {j, -(joints[j].inverse() * x).z(), (joints[j].q.conjugate() * normal).y(), far};
  }
  return out;
}

bool is_nail(const OnFinger& at, std::size_t hand) {
  const bool tip = at.joint == 1 || (at.joint >= 2 && at.joint % 3 == 1);
  const double share = at.along / hand_segments(hand)[at.joint].length;
  return tip && at.back > 0.6 && share > 0.45 && share < 0.95 && at.distance < 0.02;
}

}  // namespace

HandRenderer::HandRenderer()
    : skins_(make_hand_skins()),
      paints_{paint(skins_[left_hand], left_hand), paint(skins_[right_hand], right_hand)} {}

/// Returns the skin's colours: palms are lighter than backs, joints are redder with folds, nails are light.
HandRenderer::Paint HandRenderer::paint(const HandSkin& skin, std::size_t hand) {
  std::vector<Eigen::Vector3f> normals;
  smooth_normals(skin.rest(), skin.triangles(), normals);
  const auto joints = hand_pose(hand, {});
  Paint out;
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const OnFinger at =
        find_on_finger(joints, hand, skin.rest()[v].cast<double>(), normals[v].cast<double>());
    const auto fold = static_cast<float>(std::exp(-std::pow(at.along / fold_width, 2)));
    const bool inside = at.back<-0.2, outside = at.back> 0.4;
    const float light = 1 + (inside ? palm_light - palm_fold * fold : 0) - (outside ? back_fold * fold : 0);
    const float red = outside ? 1 + knuckle_red * fold : 1;
    out.of_tone.push_back(is_nail(at, hand) ? nail : Rgb{light * red, light, light});
  }
  return out;
}

void HandRenderer::draw(std::span<const PosedHand> hands, const Lamp& lamp, MeshDepthBuffer& layer) const {
  for (const PosedHand& hand : hands) {
    const HandSkin& skin = skins_.at(hand.hand);
    SkinnedHand bent = skin_hand(skin, hand.flexion);
    for (auto& x : bent.positions) x *= static_cast<float>(hand.size);
    std::vector<Rgb> colours = paints_[hand.hand].of_tone;
    for (Rgb& colour : colours)
      for (std::size_t c = 0; c < 3; ++c) colour[c] *= hand.tone[c];
    layer.draw({bent.positions, bent.normals, skin.triangles(), colours}, hand.camera_wrist, lamp);
  }
}

}  // namespace prosector
