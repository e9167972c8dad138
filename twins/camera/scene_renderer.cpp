#include <algorithm>
#include <limits>

#include "drivers/camera/base/camera_frames.h"
#include "twins/camera/synthetic_scene.h"

namespace prosector {
namespace {

constexpr float backdrop_top = 0.20f, backdrop_bottom = 0.10f;  // light of the background

std::vector<Pose> seen_from(const SyntheticScene& scene, double seconds) {
  const SyntheticTruth truth = scene.truth(seconds);
  const Pose camera_room = truth.room_camera.inverse();
  std::vector<Pose> out;
  for (const Pose& thing : truth.room_things) out.push_back(camera_room * thing);
  return out;
}

/// Returns the scene's hands at mid-exposure.
std::vector<PosedHand> bent_hands(const SyntheticScene& scene, const SyntheticTruth& truth) {
  std::vector<PosedHand> out;
  for (const SyntheticHand& hand : scene.hands) {
    const Carrier& carrier = scene.carriers[hand.carrier];
    PosedHand& bent = out.emplace_back();
    bent.hand = hand.hand;
    bent.size = hand.size;
    bent.camera_wrist = truth.room_camera.inverse() * truth.room_things[hand.carrier];
    if (carrier.motion) bent.flexion = carrier.motion->flexion(carrier.station, truth.seconds, carrier.loop);
  }
  return out;
}

/// Draws the solid objects where they are in front of the row's flat objects.
void draw_solids(const MeshDepthBuffer& solids, const RayGrid& grid, int y, RayRow& row) {
  for (std::size_t k = 0; k < row.depth.size(); ++k) {
    const MeshDepthBuffer::Hit hit =
        solids.at(grid.direction(static_cast<int>(k / grid.rays()), y, k % grid.rays()));
    if (hit.depth >= row.depth[k]) continue;
    row.depth[k] = hit.depth;
    row.light[k] = hit.light;
  }
}

void apply_fault(CameraFault fault, std::uint64_t number, Image& image) {
  switch (fault) {
    case CameraFault::torn: {  // random bytes in the lower part
      const std::size_t from = image.rgb.size() / 3 * (1 + number % 2);
      std::uint32_t noise = static_cast<std::uint32_t>(number) * 2654435761u + 1;
      for (std::size_t i = from; i < image.rgb.size(); ++i) {
        noise = noise * 1664525u + 1013904223u;
        image.rgb[i] = static_cast<std::uint8_t>(noise >> 24);
      }
      return;
    }
    case CameraFault::black:
      std::fill(image.rgb.begin(), image.rgb.end(), std::uint8_t{0});
      return;
    case CameraFault::upside_down: {
      Image turned = image;
      const std::size_t pixels = image.rgb.size() / 3;
      for (std::size_t i = 0; i < pixels; ++i)
        std::copy_n(image.rgb.begin() + static_cast<std::ptrdiff_t>(3 * i), 3,
                    turned.rgb.begin() + static_cast<std::ptrdiff_t>(3 * (pixels - 1 - i)));
      image = std::move(turned);
      return;
    }
    case CameraFault::resized: {  // keeps every other pixel
      Image half{image.width / 2, image.height / 2, {}};
      for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x)
          half.rgb.insert(half.rgb.end(), image.pixel(2 * x, 2 * y), image.pixel(2 * x, 2 * y) + 3);
      image = std::move(half);
      return;
    }
    case CameraFault::slow:
    case CameraFault::unplugged:
      return;  // handled by SyntheticCamera
  }
}

}  // namespace

SceneRenderer::SceneRenderer(SyntheticScene scene)
    : scene_(std::move(scene)), grid_(scene_.lens, scene_.rays) {
  if (!scene_.hands.empty()) hands_.emplace();
}

/// Draws the objects that aren't flat; returns nothing if the scene has none.
std::optional<MeshDepthBuffer> SceneRenderer::solids(const SyntheticTruth& truth, const Lamp& lamp) const {
  if (!hands_ && scene_.faces.empty()) return std::nullopt;
  MeshDepthBuffer out(scene_.lens);
  if (hands_) hands_->draw(bent_hands(scene_, truth), lamp, out);
  for (const SyntheticFace& face : scene_.faces)
    out.draw(face.mesh->painted(), truth.room_camera.inverse() * truth.room_things[face.carrier], lamp);
  return out;
}

Image SceneRenderer::paint(std::uint64_t number) const {
  return paint_at(scene_.seconds_of(number), number);
}

Image SceneRenderer::paint_at(double seconds, std::uint64_t number) const {
  const Exposure exposure{seconds, scene_.exposure, scene_.readout};
  const SyntheticTruth truth = scene_.truth(seconds);
  const Lamp lamp{truth.room_camera.q.conjugate() * scene_.to_lamp, scene_.ambient};
  const QuadRenderer painter(
      grid_, scene_.things, [this](double at) { return seen_from(scene_, at); }, exposure, lamp);
  const std::optional<MeshDepthBuffer> solid = solids(truth, lamp);
  const int width = scene_.lens.width, height = scene_.lens.height;
  const std::size_t rays = grid_.rays(), in_row = rays * static_cast<std::size_t>(width);
  RayRow row;
  std::vector<Rgb> light;
  light.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    const float share = static_cast<float>(y) / static_cast<float>(height);
    const float behind = backdrop_top + share * (backdrop_bottom - backdrop_top);
    row.light.assign(in_row, {behind, behind, behind});
    row.depth.assign(in_row, std::numeric_limits<float>::infinity());
    painter.draw(y, row);
    if (solid) draw_solids(*solid, grid_, y, row);
    for (std::size_t pixel = 0; pixel < static_cast<std::size_t>(width); ++pixel) {
      Rgb sum{};
      for (std::size_t ray = 0; ray < rays; ++ray)
        for (std::size_t c = 0; c < 3; ++c) sum[c] += row.light[pixel * rays + ray][c];
      for (float& c : sum) c /= static_cast<float>(rays);
      light.push_back(sum);
    }
  }
  Image image = expose(scene_.sensor, width, height, std::move(light), number);
  for (const CameraFaultSpan& span : scene_.faults)
    if (seconds >= span.from && seconds < span.to) apply_fault(span.fault, number, image);
  return image;
}

}  // namespace prosector
