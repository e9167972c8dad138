#include "tests/camera/tag_errors.h"

#include <algorithm>
#include <limits>

#include "drivers/camera/straightener.h"

namespace prosector {
namespace {

/// Adds what hides the board's left side: grey, a little before it, carried with it.
void cover(SyntheticScene& scene, std::size_t carrier, const Board& board, double share) {
  Eigen::AlignedBox2d box;
  for (const BoardTag& tag : board.tags)
    for (const Vec3& corner : tag.corners()) box.extend(corner.head<2>());
  FlatThing hand;
  hand.carrier = carrier;
  hand.width = share * box.sizes().x() + 0.04;
  hand.height = 2 * box.sizes().y();
  hand.pose.p = {box.min().x() - 0.04 + hand.width / 2, 0, 0.01};
  hand.both_sides = true;
  hand.texture =
      std::make_shared<Texture>(Image{1, 1, {190, 140, 120}}, false, Response(scene.sensor.response));
  scene.things.push_back(hand);
}

}  // namespace

TagErrors tag_errors(const TagCase& what) {
  Random random(11);
  const Lens lens = usual_lens();
  const Straightener straightener(lens);
  const TagFinder finder(what.finder);
  TagErrors out;
  for (int k = 0; k < what.places; ++k) {
    SyntheticScene scene = usual_scene(lens);
    scene.sensor.response = what.response;
    scene.sensor.noise = what.noise;
    scene.sensor.seed = static_cast<unsigned>(k + 1);
    scene.exposure = what.exposure;
    Carrier carrier;
    const Pose middle = board_before_camera(random, what.distance, 0, what.most_tilt);
    carrier.pose = middle;
    if (what.speed > 0) {
      // Keyframes are passed with 15/8 of the mean speed in the middle between them.
      constexpr double span = 0.2;
      const Vec3 half = Vec3(what.speed * span / 2 / 1.875, 0, 0);
      carrier.motion.emplace();
      carrier.motion->add(0, scene.seconds_of(0) - span / 2, Pose{middle.p - half, middle.q});
      carrier.motion->add(0, scene.seconds_of(0) + span / 2, Pose{middle.p + half, middle.q});
    }
    const std::size_t index = scene.add_board(what.board, carrier);
    if (what.covered > 0) cover(scene, index, what.board, what.covered);
    const GreyImage picture = grey_of(ScenePainter(scene).paint(0));
    const auto tags = finder.find(straightener.straight(picture));
    const auto poses = solve_board(corners_seen(what.board, tags), straightener.lens());
    if (poses.empty()) continue;
    std::vector<int> codes;
    for (const SeenTag& tag : tags) codes.push_back(tag.code);
    const auto fit = fit_edges(picture, lens, what.board, codes, poses.front().camera_board, what.assumed);
    if (!fit) continue;
    ++out.seen;
    const Pose truth = device_camera * middle;
    const Vec3 off = 1e3 * (fit->camera_board.p - truth.p);
    out.depth.push_back(std::abs(off.z()));
    out.lateral.push_back(off.head<2>().norm());
    out.turn.push_back(fit->camera_board.q.angularDistance(truth.q));
    out.told.push_back(1e3 * std::sqrt(fit->covariance(5, 5)));
  }
  return out;
}

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::infinity();
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

}  // namespace prosector
