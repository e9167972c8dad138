#include "tests/hands/hand_pictures.h"

#include <algorithm>
#include <cmath>

#include "common/error.h"
#include "drivers/camera/hands/hand_fit.h"

namespace prosector {
namespace {

constexpr int side = 2;  // rays of a pixel's side
constexpr double hand_length = 0.19;
constexpr double tilt = 0.5;  // rad

float to_byte(float light) {
  return 255 * std::pow(std::clamp(light, 0.F, 1.F), 1 / 2.2F);
}

double normal_number(Random& random) {
  double sum = 0;
  for (int k = 0; k < 6; ++k) sum += random.uniform(-1, 1);
  return sum / std::sqrt(2.0);
}

/// Draws the mean of all rays of each pixel, as light.
std::vector<Rgb> light_of(const HandScene& scene, const MeshDepthBuffer& layer,
                          const std::vector<Eigen::Vector2f>& rays) {
  std::vector<Rgb> out;
  auto ray = rays.begin();
  for (int y = 0; y < scene.lens.height; ++y)
    for (int x = 0; x < scene.lens.width; ++x) {
      Rgb sum{};
      for (int s = 0; s < side * side; ++s) {
        const MeshDepthBuffer::Hit hit = layer.at(*ray++);
        const float fade = 1 - 0.3F * static_cast<float>(y) / static_cast<float>(scene.lens.height);
        for (std::size_t c = 0; c < 3; ++c)
          sum[c] += (std::isfinite(hit.depth) ? hit.light[c] : fade * scene.wall[c]) / (side * side);
      }
      out.push_back(sum);
    }
  return out;
}

std::vector<Eigen::Vector2f> rays_of(const Lens& lens) {
  std::vector<Eigen::Vector2f> out;
  for (int y = 0; y < lens.height; ++y)
    for (int x = 0; x < lens.width; ++x)
      for (int s = 0; s < side * side; ++s) {
        const Vec2 pixel(x + (s % side + 0.5) / side - 0.5, y + (s / side + 0.5) / side - 0.5);
        out.push_back(lens.ray(pixel).head<2>().cast<float>());
      }
  return out;
}

}  // namespace

Lens webcam() {
  Lens out;
  out.k1 = -0.18;
  return out;
}

PosedHand random_hand(Random& random, double nearest, double farthest) {
  PosedHand out;
  out.hand = random.below(2);
  // Fingers up (the camera's −y), the palm or the back to the camera.
  Mat3 upright;
  upright << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  const double turned = random.below(2) ? 0 : 3.14159265;
  const Quat about = Eigen::AngleAxisd(random.uniform(-tilt, tilt), Vec3::UnitZ()) *
                     Eigen::AngleAxisd(random.uniform(-tilt, tilt), Vec3::UnitX()) *
                     Eigen::AngleAxisd(turned + random.uniform(-tilt, tilt), Vec3::UnitY());
  out.camera_wrist.q = (about * Quat(upright)).normalized();
  const double depth = random.uniform(nearest, farthest);
  const Vec3 middle = out.camera_wrist.q * Vec3(0, 0, -0.09);
  out.camera_wrist.p =
      Vec3(random.uniform(-0.2, 0.2) * depth, random.uniform(-0.1, 0.1) * depth, depth) - middle;
  for (double& bend : out.flexion) bend = random.uniform(0, 1);
  out.flexion[0] *= 0.7;  // a thumb that bends all the way shows no hand that people make
  return out;
}

HandScene random_scene(Random& random, const PosedHand& hand) {
  HandScene out;
  out.lens = webcam();
  out.hands = {hand};
  out.light.towards =
      Vec3(random.uniform(-1, 1), random.uniform(-1, 0.2), random.uniform(-1, -0.3)).normalized();
  out.light.ambient = random.uniform(0.3, 0.7);
  const auto tone = static_cast<float>(random.uniform(0.5, 1.2)),
             wall = static_cast<float>(random.uniform(0.05, 0.7));
  out.hands[0].tone = {tone * 0.55F, tone * 0.32F, tone * 0.22F};
  for (float& c : out.wall) c = wall * static_cast<float>(random.uniform(0.7, 1));
  return out;
}

HandPainter::HandPainter(const Lens& lens) : lens_(lens), rays_(rays_of(lens)) {}

Image HandPainter::paint(const HandScene& scene, Random& random) const {
  if (scene.lens != lens_) throw InternalError("a hand painter draws for one lens");
  std::vector<PosedHand> hands = scene.hands;
  for (PosedHand& hand : hands) hand.camera_wrist = scene.camera_rig * hand.camera_wrist;
  MeshDepthBuffer layer(lens_);
  layer_.draw(hands, scene.light, layer);
  Image out{scene.lens.width, scene.lens.height, {}};
  for (const Rgb& light : light_of(scene, layer, rays_))
    for (const float c : light) {
      const double byte = to_byte(c) + scene.noise * normal_number(random) + 0.5;
      out.rgb.push_back(static_cast<std::uint8_t>(std::clamp(byte, 0.0, 255.0)));
    }
  return out;
}

std::array<Vec2, 21> true_points(const HandScene& scene, const PosedHand& hand) {
  std::array<Vec2, 21> out;
  const auto points = points_of_hand(hand.hand, hand.flexion);
  for (std::size_t k = 0; k < out.size(); ++k)
    out[k] = scene.lens.project(scene.camera_rig * hand.camera_wrist * Vec3(hand.size * points[k]));
  return out;
}

double length_in_picture(const HandScene& scene, const PosedHand& hand) {
  const Vec3 middle = scene.camera_rig * hand.camera_wrist * Vec3(0, 0, -0.09);
  return scene.lens.fx * hand_length * hand.size / middle.z();
}

}  // namespace prosector
