#include "client/setup/glove_live.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "client/setup/fields.h"
#include "client/setup/orthographic_view.h"
#include "common/hand.h"
#include "drivers/config/client_config_table.h"
#include "drivers/device/gesture.h"
#include "drivers/fitting/glove_guide.h"

namespace prosector {
namespace {

constexpr double min_span_share = 0.8;  // fraction of the calibrated range
constexpr std::array finger_words = {msg("thumb"), msg("index"), msg("middle"), msg("ring"), msg("little")};

/// A bone, or an edge of the palm, as drawn.
struct Stroke {
  Vec3 from, to;
  double radius;
  double nearness;
};

std::vector<Stroke> strokes_of(std::size_t hand, const std::array<double, fingers>& flexion,
                               const OrthographicView& space) {
  std::vector<Stroke> out;
  const auto add = [&](const Vec3& from, const Vec3& to, double radius) {
    out.push_back({from, to, radius, space.nearness((from + to) / 2)});
  };
  const std::array<Pose, hand_joints> poses = hand_pose(hand, flexion);
  const auto& segments = hand_segments(hand);
  for (std::size_t k = 0; k < hand_joints; ++k)
    add(poses[k].p, poses[k] * Vec3(0, 0, -segments[k].length), segments[k].radius);
  // The palm: lines from the wrist to the bases of the fingers.
  const Palm palm = hand_palm(hand);
  for (std::size_t k = 0; k < hand_joints; ++k)
    if (segments[k].parent < 0) {
      Vec3 root = palm.center;
      root.z() += 0.9 * palm.half_extents.z();
      root.x() += 0.5 * (poses[k].p.x() - palm.center.x());
      add(root, poses[k].p, std::max(segments[k].radius, 0.9 * palm.half_extents.y()));
    }
  std::sort(out.begin(), out.end(), [](const Stroke& a, const Stroke& b) { return a.nearness < b.nearness; });
  return out;
}

}  // namespace

void ObservedRanges::take(const std::array<std::uint16_t, fingers>& counts) {
  for (std::size_t f = 0; f < fingers; ++f) {
    least_[f] = any_ ? std::min(least_[f], counts[f]) : counts[f];
    most_[f] = any_ ? std::max(most_[f], counts[f]) : counts[f];
  }
  any_ = true;
}

double ObservedRanges::span(std::size_t finger) const {
  return most_[finger] - least_[finger];
}

double ObservedRanges::share(std::size_t finger, const std::optional<GloveCalibration>& calibration) const {
  if (!calibration) return 1;
  const double open = calibration->open[finger], closed = calibration->closed[finger];
  const double low = std::max<double>(std::min(open, closed), least_[finger]);
  const double high = std::min<double>(std::max(open, closed), most_[finger]);
  return std::clamp((high - low) / std::abs(closed - open), 0., 1.);
}

void GloveTestPanel::close() {
  watch_.reset();
  spans_ = {};
  made_.clear();
}

void GloveTestPanel::begin(const ClientConfig& config) {
  ClientConfig bare;
  bare.gloves[hand_] = config.gloves[hand_];
  watch_ = std::make_unique<DeviceWatch>(bare);
}

void GloveTestPanel::draw(Interface& ui, ConfigDraft& draft, Said&, std::int64_t now_ns) {
  const ClientConfig& config = draft.config();
  const std::size_t before = hand_;
  edit_hand(ui, hand_);
  if (hand_ != before) close();
  const GloveSettings& glove = config.gloves[hand_];
  if (glove.address.empty()) {
    quiet(ui.tr("This glove is not configured. Choose it on the Devices page."));
    return;
  }
  if (!watch_) begin(config);
  watch_->poll(now_ns);
  const WatchedDevice& device = watch_->devices().front();
  if (!device.status.message.empty()) warning(device.status.message);
  if (device.stations.empty() || !device.stations.front().last.has_flexion) {
    quiet(ui.tr("No data received yet."));
    return;
  }
  const DeviceSample& sample = device.stations.front().last;
  spans_.take(sample.raw_flexion);
  if (sample.gesture != Gesture::none) made_[sample.gesture] = true;
  draw_hand(ui, sample);
  ImGui::SameLine();
  ImGui::BeginGroup();
  draw_bars(ui, sample, glove);
  ImGui::EndGroup();
  ImGui::Separator();
  draw_gestures(ui, sample, config);
}

void GloveTestPanel::draw_hand(Interface& ui, const DeviceSample& sample) const {
  const auto scale = static_cast<float>(ui.scale());
  const float size = 250 * scale;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  OrthographicView space;
  space.scale = size / 0.21f;
  space.view = seen_from(0.9, hand_ == right_hand ? 0.35 : -0.35);
  space.x = at.x + 0.42f * size;
  space.y = at.y + 0.86f * size;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + size, at.y + size}, IM_COL32(255, 255, 255, 8), 4 * scale);
  list.PushClipRect(at, {at.x + size, at.y + size}, true);
  for (const bool rim : {true, false})
    for (const Stroke& stroke : strokes_of(hand_, sample.flexion, space)) {
      const auto radius = static_cast<float>(stroke.radius) * space.scale + (rim ? 1.5f * scale : 0.f);
      const auto light = static_cast<float>(std::clamp(0.75 + 3 * stroke.nearness, 0.45, 1.));
      const ImU32 shade =
          rim ? IM_COL32(40, 26, 22, 255)
              : ImGui::ColorConvertFloat4ToU32({0.93f * light, 0.74f * light, 0.64f * light, 1});
      const ImVec2 from = space.at<ImVec2>(stroke.from), to = space.at<ImVec2>(stroke.to);
      list.AddLine(from, to, shade, 2 * radius);
      list.AddCircleFilled(from, radius, shade);
      list.AddCircleFilled(to, radius, shade);
    }
  list.PopClipRect();
  ImGui::Dummy({size, size});
  ui.note("hand");
}

void GloveTestPanel::draw_bars(Interface& ui, const DeviceSample& sample, const GloveSettings& glove) const {
  const double least = GloveGuide::least_span_of(glove.address);
  const float wide = 0.45f * ImGui::GetContentRegionAvail().x;
  for (std::size_t f = 0; f < fingers; ++f) {
    ImGui::ProgressBar(static_cast<float>(sample.flexion[f]), {wide, 0},
                       fmt::format("{} {:.2f}", ui.tr(finger_words[f]), sample.flexion[f]).c_str());
    const bool counts =
        std::any_of(sample.raw_flexion.begin(), sample.raw_flexion.end(), [](auto c) { return c > 0; });
    if (!counts) continue;  // the device reports no counts
    ImGui::SameLine();
    const double span = spans_.span(f), share = spans_.share(f, glove.device.glove.calibration);
    const bool enough = span >= least && share >= min_span_share;
    const std::string words =
        span < least ? ui.tr("{}: {:.0f} counts of at least {:.0f}", sample.raw_flexion[f], span, least)
        : glove.device.glove.calibration
            ? ui.tr("{}: {:.0f} % of the calibrated range", sample.raw_flexion[f], 100 * share)
            : ui.tr("{}: range {:.0f} counts", sample.raw_flexion[f], span);
    if (enough)
      wrapped(words);
    else
      warning(words);
    ui.note(fmt::format("span {} {}", finger_words[f], enough ? "good" : "short"));
  }
  if (!glove.device.glove.calibration)
    quiet(ui.tr("Not calibrated: the range is learnt again at each start. Calibrate the glove to store it."));
}

void GloveTestPanel::draw_gestures(Interface& ui, const DeviceSample& sample,
                                   const ClientConfig& config) const {
  const bool none = sample.gesture == Gesture::none;
  ImGui::SetWindowFontScale(1.35f);
  title(none ? ui.tr("no gesture") : gesture_name(sample.gesture));
  ImGui::SetWindowFontScale(1);
  bool first = true;
  for (const GestureRow& row : gesture_table()) {
    if (row.gesture == Gesture::none) continue;
    const auto asked = find_config_key(fmt::format("gestures.{}", row.name))->get(config);
    std::string event = asked ? std::get<std::string>(*asked) : "none";
    const Gesture plain = without_thumb(row.gesture);
    if (event == "none" && plain != row.gesture) event = fmt::format("as {}", gesture_name(plain));
    const bool was_made = made_.contains(row.gesture);
    const std::string words =
        fmt::format("{}{}{}", row.name, event == "none" ? "" : ": " + event, was_made ? ", made" : "");
    const float wide = ImGui::CalcTextSize(words.c_str()).x + 2 * ImGui::GetStyle().ItemSpacing.x;
    if (!first) ImGui::SameLine();
    if (!first && ImGui::GetContentRegionAvail().x < wide) ImGui::NewLine();
    first = false;
    if (was_made)
      ImGui::TextColored({0.35f, 0.8f, 0.45f, 1}, "%s", words.c_str());
    else
      ImGui::TextDisabled("%s", words.c_str());
    ui.note(fmt::format("{} {}", row.name, was_made ? "made" : "not made"));
  }
}

}  // namespace prosector
