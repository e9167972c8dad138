#include "client/setup/tracker_range.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "client/setup/guided_calibration.h"
#include "client/setup/orthographic_view.h"
#include "common/error.h"
#include "drivers/device/driver_table.h"

namespace prosector {
namespace {

constexpr double exact_within = 0.76, works_within = 3;  // m, of a FASTRAK
constexpr double least_shown = 1;                        // m, from the transmitter to the drawing's border
constexpr std::array<ImU32, 3> trust_shades = {
    {IM_COL32(90, 210, 120, 255), IM_COL32(245, 185, 65, 255), IM_COL32(245, 100, 85, 255)}};
constexpr std::array trust_words = {msg("accurate"), msg("less accurate"), msg("out of range")};

/// Sides of the transmitter with their hemisphere's zenith: X forward, Y right, Z down.
struct Side {
  const char* name;
  Vec3 zenith;
};
const std::array<Side, 6> sides = {{{msg("in front"), {1, 0, 0}},
                                    {msg("behind"), {-1, 0, 0}},
                                    {msg("to its right"), {0, 1, 0}},
                                    {msg("to its left"), {0, -1, 0}},
                                    {msg("above"), {0, 0, -1}},
                                    {msg("below"), {0, 0, 1}}}};

/// Converts a direction from the FASTRAK's frame to ours.
Vec3 ours(const Vec3& v) {
  return {v.y(), -v.z(), -v.x()};
}

std::string receiver_name(const Interface& ui, const ClientConfig& config, std::uint32_t station) {
  constexpr std::array names = {
      "", msg("head"), msg("left hand"), msg("right hand"), msg("instrument"), msg("tablet")};
  const char* const whose = names.at(static_cast<std::size_t>(config.stations[station]));
  return *whose == 0 ? ui.tr("Receiver {}", station + 1)
                     : ui.tr("Receiver {}, {}", station + 1, ui.tr(whose));
}

/// Returns a text with an orientation: yaw, pitch and roll.
std::string orientation_text(const Interface& ui, const Quat& q) {
  constexpr double degrees = 180 / std::numbers::pi;
  const Vec3 ahead = q * -Vec3::UnitZ();
  const double aside = degrees * std::atan2(ahead.x(), -ahead.z());
  const double up = degrees * std::asin(std::clamp(ahead.y(), -1., 1.));
  const double rolled = degrees * std::atan2((q * Vec3::UnitX()).y(), (q * Vec3::UnitY()).y());
  return ui.tr("{:.0f}° {}, {:.0f}° {}, rolled {:.0f}°", std::abs(aside),
               aside < 0 ? ui.tr("left") : ui.tr("right"), std::abs(up), up < 0 ? ui.tr("down") : ui.tr("up"),
               rolled);
}

/// Draws the half of a disk that faces away from a direction.
void draw_dark_half(ImDrawList& list, ImVec2 middle, float radius, ImVec2 to, ImU32 shade) {
  constexpr int corners = 32;
  const double across = std::atan2(to.y, to.x) + std::numbers::pi / 2;
  for (int k = 0; k <= corners; ++k) {
    const double a = across + std::numbers::pi * k / corners;
    list.PathLineTo({middle.x + radius * static_cast<float>(std::cos(a)),
                     middle.y + radius * static_cast<float>(std::sin(a))});
  }
  list.PathFillConvex(shade);
}

}  // namespace

Trust trust_at(double distance, char error) {
  if (error != ' ' || distance > works_within) return Trust::none;
  return distance <= exact_within ? Trust::good : Trust::less;
}

/// Opens only the tracker. Its receivers' poses are in its own frame.
void TrackerRangePanel::begin(const ClientConfig& config) {
  ClientConfig bare;
  bare.tracker = config.tracker;
  bare.tracker_device = config.tracker_device;
  bare.tracker_device.placement.room_device = {};
  bare.tracker_device.placement.mount.fill({});
  bare.tracker_device.placement.field_map.clear();
  watch_ = std::make_unique<DeviceWatch>(bare);
  const std::string driver = driver_of(config.tracker).name;
  knows_range_ = driver == "fastrak" || driver.starts_with("recorded");
  map_.reset();
  try {
    if (!config.tracker_device.placement.field_map.empty())
      map_ = load_field_map(config.tracker_device.placement.field_map);
  } catch (const InputError&) {
    map_.reset();  // the error is reported when a session is entered with this map
  }
}

void TrackerRangePanel::draw(Interface& ui, ConfigDraft& draft, Said& said, std::int64_t now_ns) {
  if (draft.config().tracker.empty()) {
    quiet(ui.tr("No tracker is configured. Choose it on the Devices page."));
    return;
  }
  if (!watch_) begin(draft.config());
  watch_->poll(now_ns);
  const DeviceStatus& status = watch_->devices().front().status;
  if (!status.message.empty()) warning(status.message);
  draw_pictures(ui, draft.config());
  draw_receivers(ui, draft.config());
  ImGui::Separator();
  if (!knows_range_) {
    quiet(
        ui.tr("The range of this tracker is not known. Its hemisphere and forward direction are set in its "
              "own software."));
    return;
  }
  draw_side(ui, draft, said);
  draw_ahead(ui, draft, said);
}

void TrackerRangePanel::draw_pictures(Interface& ui, const ClientConfig& config) const {
  const auto scale = static_cast<float>(ui.scale());
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float wide = (ImGui::GetContentRegionAvail().x - gap) / 2, high = 190 * scale;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  double farthest = least_shown;
  for (const WatchedStation& s : watch_->devices().front().stations)
    farthest = std::max(farthest, std::min(1.15 * s.last.pose.p.norm(), works_within));
  Mat3 above;
  above << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const bool right : {false, true}) {
    const ImVec2 corner = {at.x + (right ? wide + gap : 0), at.y};
    const OrthographicView space = {corner.x + wide / 2, corner.y + high / 2,
                                    static_cast<float>(0.5 * high / farthest),
                                    right ? Mat3(Mat3::Identity()) : above};
    list.PushClipRect(corner, {corner.x + wide, corner.y + high}, true);
    draw_range(space, config.tracker_device.fastrak.hemisphere, scale);
    draw_dots(space, scale);
    list.AddText({corner.x + 6 * scale, corner.y + 3 * scale}, IM_COL32(158, 166, 178, 255),
                 right ? ui.tr("from behind") : ui.tr("view from above, forward is up"));
    list.PopClipRect();
    list.AddRect(corner, {corner.x + wide, corner.y + high}, IM_COL32(255, 255, 255, 30), 4 * scale, 0,
                 scale);
  }
  ImGui::Dummy({2 * wide + gap, high});
  ui.note("range");
}

/// Draws the tracker's range, its unused hemisphere, and the mapped field.
void TrackerRangePanel::draw_range(const OrthographicView& space, const Vec3& hemisphere, float scale) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 middle = {space.x, space.y};
  if (knows_range_) {
    const float works = space.scale * static_cast<float>(works_within);
    list.AddCircleFilled(middle, works, IM_COL32(245, 185, 65, 24), 96);
    list.AddCircleFilled(middle, space.scale * static_cast<float>(exact_within), IM_COL32(90, 210, 120, 44),
                         96);
    const Vec3 zenith = space.view * ours(hemisphere);
    // Seen almost along the zenith, the hemisphere's border is not visible.
    constexpr double min_visible_tilt = 0.3;
    if (zenith.norm() > 0 && zenith.head<2>().norm() > min_visible_tilt * zenith.norm())
      draw_dark_half(list, middle, works, {static_cast<float>(zenith.x()), static_cast<float>(-zenith.y())},
                     IM_COL32(0, 0, 0, 150));
  }
  if (map_) {
    const ImVec2 a = space.at<ImVec2>(map_->centre - map_->half),
                 b = space.at<ImVec2>(map_->centre + map_->half);
    list.AddRect({std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)},
                 IM_COL32(120, 190, 255, 160), 0, 0, scale);
  }
  const float box = 5 * scale;
  list.AddRectFilled({middle.x - box, middle.y - box}, {middle.x + box, middle.y + box},
                     IM_COL32(200, 205, 212, 255), 2 * scale);
}

void TrackerRangePanel::draw_dots(const OrthographicView& space, float scale) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const WatchedStation& s : watch_->devices().front().stations) {
    const ImVec2 dot = space.at<ImVec2>(s.last.pose.p);
    const ImU32 shade = shade_of(s.last);
    list.AddCircleFilled(dot, 5 * scale, shade);
    list.AddText({dot.x + 7 * scale, dot.y - 8 * scale}, shade, std::to_string(s.last.station + 1).c_str());
  }
}

/// Returns the colour of a receiver's accuracy class; white if unknown.
std::uint32_t TrackerRangePanel::shade_of(const DeviceSample& sample) const {
  if (!knows_range_) return IM_COL32(225, 230, 235, 255);
  return trust_shades[static_cast<std::size_t>(trust_at(sample.pose.p.norm(), sample.error))];
}

void TrackerRangePanel::draw_receivers(Interface& ui, const ClientConfig& config) const {
  for (const WatchedStation& s : watch_->devices().front().stations) {
    if (config.stations[s.last.station] == StationRole::none) continue;
    const double distance = s.last.pose.p.norm();
    const bool mapped = map_ && ((s.last.pose.p - map_->centre).cwiseAbs() - map_->half).maxCoeff() <= 0;
    const std::string trusted =
        knows_range_ ? trust_words[static_cast<std::size_t>(trust_at(distance, s.last.error))] : msg("seen");
    ImGui::PushStyleColor(ImGuiCol_Text, shade_of(s.last));
    wrapped(ui.tr("{}: {:.2f} m away, {}{}; {}", receiver_name(ui, config, s.last.station), distance,
                  ui.tr(trusted),
                  !map_    ? ""
                  : mapped ? ui.tr(", in the mapped field")
                           : ui.tr(", outside the mapped field"),
                  orientation_text(ui, s.last.pose.q)));
    ImGui::PopStyleColor();
    ui.note(fmt::format("receiver {} {}", s.last.station + 1, trusted));
  }
}

void TrackerRangePanel::change(ConfigDraft& draft, Said& said, const ConfigChange& what,
                               const std::string& done) {
  const std::string why = draft.change({what});
  said = why.empty() ? Said{done, false} : Said{why, true};
  if (why.empty()) watch_.reset();
}

void TrackerRangePanel::draw_side(Interface& ui, ConfigDraft& draft, Said& said) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(ui.tr("The receivers are on this side of the transmitter:"));
  const Vec3 now = draft.config().tracker_device.fastrak.hemisphere;
  for (const Side& side : sides) {
    ImGui::SameLine();
    if (ImGui::RadioButton(ui.tr(side.name), (now.normalized() - side.zenith).norm() < 1e-3)) {
      const std::vector<double> zenith(side.zenith.data(), side.zenith.data() + 3);
      change(draft, said, {"tracker.hemisphere", zenith},
             ui.tr("The receivers are assumed to be on this side of the transmitter: {}.", ui.tr(side.name)));
    }
    ui.note(side.name);
  }
  quiet(
      ui.tr("A receiver on the other side is reported as its mirror image. Lift it, and check that its dot "
            "moves up."));
}

void TrackerRangePanel::draw_ahead(Interface& ui, ConfigDraft& draft, Said& said) {
  bool boresight = draft.config().tracker_device.fastrak.boresight;
  if (ImGui::Checkbox(ui.tr("use the receivers' orientation at start as forward"), &boresight))
    change(draft, said, {"tracker.boresight", boresight},
           boresight ? msg("Straight ahead is the direction that the receivers had when tracking started.")
                     : msg("Forward is defined by the receivers' housing."));
  ui.note("boresight");
  if (!boresight) return;
  ImGui::SameLine();
  if (ImGui::Button(ui.tr("Set it again"))) {
    watch_.reset();
    said = {msg("The receivers' current orientation is now forward."), false};
  }
  ui.note("boresight now");
}

}  // namespace prosector
