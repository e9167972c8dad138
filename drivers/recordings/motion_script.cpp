#include "drivers/recordings/motion_script.h"

#include <algorithm>
#include <cmath>

#include "drivers/recordings/sample_columns.h"

namespace prosector {
namespace {

double ease(double u) {
  return u * u * u * (10 + u * (6 * u - 15));
}

Pose mix(const Pose& a, const Pose& b, double s) {
  return {a.p + s * (b.p - a.p), a.q.slerp(s, b.q)};
}

std::array<double, fingers> mix(const std::array<double, fingers>& a, const std::array<double, fingers>& b,
                                double s) {
  std::array<double, fingers> out{};
  for (std::size_t i = 0; i < fingers; ++i) out[i] = a[i] + s * (b[i] - a[i]);
  return out;
}

template <class Keys, class T>
T interpolate(const Keys& keys, double time, const T& none) {
  if (keys.empty()) return none;
  const auto next = std::find_if(keys.begin(), keys.end(), [&](const auto& key) { return key.time > time; });
  if (next == keys.begin()) return next->value;
  const auto before = next - 1;
  if (next == keys.end()) return before->value;
  return mix(before->value, next->value, ease((time - before->time) / (next->time - before->time)));
}

}  // namespace

MotionScript MotionScript::load(const std::filesystem::path& file) {
  const CsvTable table(file, sample_columns());
  MotionScript script;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double time = table.required(i, "time");
    const std::uint32_t s = read_station(table, i);
    const auto pose = read_pose(table, i);
    const auto flexion = read_flexion(table, i);
    if (!pose && !flexion) table.fail(i, "needs a pose or flexions");
    if ((pose && !script.poses_[s].empty() && time <= script.poses_[s].back().time) ||
        (flexion && !script.flexions_[s].empty() && time <= script.flexions_[s].back().time))
      table.fail(i, "time: must increase from row to row of the same station");
    if (pose) script.add(s, time, *pose);
    if (flexion) script.add(s, time, *flexion);
  }
  return script;
}

double MotionScript::duration() const {
  double last = 0;
  for (const auto& keys : poses_)
    if (!keys.empty()) last = std::max(last, keys.back().time);
  for (const auto& keys : flexions_)
    if (!keys.empty()) last = std::max(last, keys.back().time);
  return last;
}

double MotionScript::wrapped(double time, bool loop) const {
  return loop && duration() > 0 ? std::fmod(time, duration()) : time;
}

Pose MotionScript::pose(std::size_t station, double time, bool loop) const {
  return interpolate(poses_[station], wrapped(time, loop), Pose{});
}

std::array<double, fingers> MotionScript::flexion(std::size_t station, double time, bool loop) const {
  return interpolate(flexions_[station], wrapped(time, loop), std::array<double, fingers>{});
}

}  // namespace prosector
