#include "drivers/fitting/glove_guide.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prosector {
namespace {

constexpr double hold_seconds = 0.7;
constexpr std::size_t least_window = 20;
constexpr double still_share = 0.1, other_share = 0.5;  // shares of the least span: largest motion at rest;
                                                        // least difference from the previous pose

double most_apart(const GloveCounts& a, const GloveCounts& b) {
  double most = 0;
  for (std::size_t f = 0; f < fingers; ++f) most = std::max(most, std::abs(a[f] - b[f]));
  return most;
}

}  // namespace

GloveGuide::GloveGuide(std::size_t hand, double least_span) : hand_(hand), least_span_(least_span) {}

double GloveGuide::least_span_of(const std::string& address) {
  constexpr double usb = 50, serial = 30;  // counts of the least span
  return address.starts_with("5dt-usb:") ? usb : serial;
}

PoseCounts GloveGuide::between(std::size_t first, std::size_t end) const {
  std::vector<std::array<std::uint16_t, fingers>> counts;
  for (std::size_t i = first; i < end; ++i) counts.push_back(window_[i].counts);
  return pose_counts(counts);
}

double GloveGuide::filled() const {
  if (window_.empty()) return 0;
  return std::min(
      1.0, 1e-9 * static_cast<double>(window_.back().time_ns - window_.front().time_ns) / hold_seconds);
}

void GloveGuide::take(const DeviceSample& sample) {
  if (!sample.has_flexion || held_.size() == glove_poses().size()) return;
  window_.push_back({sample.time_ns, sample.raw_flexion});
  const auto span_ns = static_cast<std::int64_t>(1e9 * hold_seconds);
  while (window_.size() > 2 && sample.time_ns - window_[1].time_ns >= span_ns) window_.pop_front();
  if (window_.size() < least_window || filled() < 1) return;
  const std::size_t half = window_.size() / 2;
  const PoseCounts a = between(0, half), b = between(half, window_.size());
  if (most_apart(a.median, b.median) > still_share * least_span_) return;
  const PoseCounts whole = between(0, window_.size());
  if (!held_.empty() && most_apart(whole.median, held_.back().median) < other_share * least_span_) return;
  held_.push_back(whole);
  window_.clear();
}

GuideStep GloveGuide::step() const {
  GuideStep out = step_at(held_.size(), glove_poses().size());
  if (out.done) return out;
  out.instruction = glove_poses()[out.index].instruction;
  out.progress = filled();
  return out;
}

void GloveGuide::back() {
  if (!held_.empty()) held_.pop_back();
}

GuideOutcome GloveGuide::outcome() const {
  const GloveFit f = fit();
  const std::string glove = hand_ == left_hand ? "glove.left." : "glove.right.";
  constexpr double degrees = 180 / std::numbers::pi;
  GuideOutcome out;
  constexpr std::array<const char*, fingers> names = {"thumb", "index", "middle", "ring", "little"};
  for (std::size_t i = 0; i < fingers; ++i)
    out.words.push_back(
        fmt::format("{:<6} {:5.0f} counts open, {:5.0f} closed; error of the joint angle {:.1f}° RMS",
                    names[i], f.calibration.open[i], f.calibration.closed[i], degrees * f.joint_error[i]));
  for (const std::string& doubt : f.doubts) out.words.push_back("look: " + doubt);
  const auto& [open, closed] = f.calibration;
  out.changes = {{glove + "open", std::vector<double>(open.begin(), open.end())},
                 {glove + "closed", std::vector<double>(closed.begin(), closed.end())},
                 {glove + "falls_on_bending", f.falls_on_bending}};
  return out;
}

}  // namespace prosector
