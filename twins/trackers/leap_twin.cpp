#include "twins/trackers/leap_twin.h"

#include "common/hand.h"
#include "common/ids.h"
#include "twins/base/web_socket_bytes.h"

namespace prosector {
namespace {

constexpr std::size_t longest_request = 4096;
constexpr double carpus_behind = 0.06;  // m: distance of the carpus from the knuckle, along the straight
                                        // finger

}  // namespace

leap::Hand simulated_hand(bool left, const Pose& wrist, const std::array<double, fingers>& flexion) {
  const std::size_t side = left ? left_hand : right_hand;
  const auto& segments = hand_segments(side);
  const auto poses = hand_pose(side, flexion);
  leap::Hand out;
  out.left = left;
  out.wrist = wrist.p;
  out.direction = wrist.q * -Vec3::UnitZ();
  out.palm_normal = wrist.q * -Vec3::UnitY();
  for (std::size_t f = 0; f < fingers; ++f) {
    const std::size_t first = f == 0 ? 0 : 2 + 3 * (f - 1), bones = f == 0 ? 2 : 3;
    const Vec3 behind = segments[first].origin + segments[first].rest * Vec3(0, 0, carpus_behind);
    std::vector<Vec3> places = {behind};
    if (f == 0) places.push_back(behind);  // the thumb has one bone less
    for (std::size_t k = 0; k < bones; ++k) places.push_back(poses[first + k].p);
    const std::size_t last = first + bones - 1;
    places.push_back(poses[last] * Vec3(0, 0, -segments[last].length));
    for (std::size_t k = 0; k < places.size(); ++k) out.joints[f][k] = wrist * places[k];
  }
  return out;
}

void LeapTwin::receive(std::span<const std::uint8_t> bytes, std::int64_t now_ns,
                       std::vector<TwinOutput>& out) {
  if (talks_ || request_.size() > longest_request) return;
  request_.append(bytes.begin(), bytes.end());
  const auto answer = web_socket_answer(request_);
  if (!answer) return;
  talks_ = true;
  auto& said = out.emplace_back().bytes;
  said.assign(answer->begin(), answer->end());
  leap::Text greeting;
  greeting.version = leap::known_version + (clock_.sends_wrong_version(now_ns) ? 1 : 0);
  put_web_socket_text(said, leap::text_of(greeting, 0));
}

void LeapTwin::produce(std::int64_t now_ns, std::vector<TwinOutput>& out) {
  if (!talks_ || !clock_.due(now_ns)) return;
  leap::Text frame;
  for (std::size_t hand = 0; hand < hands_; ++hand)
    frame.hands.push_back(simulated_hand(hand == 1, clock_.pose(hand, now_ns), clock_.flexion(hand, now_ns)));
  TwinOutput& record = out.emplace_back();
  record.is_record = true;
  record.record = records_++;
  const Pose wrist = leap::wrist_of(frame.hands.front());
  record.values = record_values(wrist.p, wrist.q);
  put_web_socket_text(record.bytes, leap::text_of(frame, static_cast<std::int64_t>(record.record)));
}

void LeapTwin::reset_client() {
  request_.clear();
  talks_ = false;
}

}  // namespace prosector
