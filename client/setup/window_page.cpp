#include "client/setup/window_page.h"

#include <fmt/format.h>
#include <imgui.h>

#include <cmath>
#include <numbers>

#include "client/setup/draft_changes.h"
#include "client/setup/eye_position_view.h"
#include "client/setup/side_by_side.h"
#include "common/error.h"
#include "drivers/device/driver_table.h"

namespace prosector {
namespace {

// held_ns: how long the last detected eyes are shown.
constexpr std::int64_t list_again_ns = 2'000'000'000, held_ns = 500'000'000;
constexpr double mm = 1000;  // per metre
constexpr const char* face_driver = "face:";
const Vec3 far_eyes(-2, -2, 2);  // m, before the screen: the texts for them are long

/// Lists cameras with their face-tracker addresses.
std::vector<FoundDevice> face_cameras() {
  std::vector<FoundDevice> out = found_cameras();
  for (FoundDevice& camera : out)
    for (std::string& address : camera.addresses) address.insert(0, face_driver);
  return out;
}

/// Returns the downward pitch of a camera that faces the user, degrees; nullopt: it has another orientation.
std::optional<double> downward_pitch(const Quat& q) {
  constexpr double least = 1e-6;
  if (std::abs(q.w()) > least || std::abs(q.x()) > least) return std::nullopt;
  return 2 * std::atan(q.z() / q.y()) * 180 / std::numbers::pi;
}

Quat looking_down(double degrees) {
  const double half = degrees * std::numbers::pi / 360;
  return {0, 0, std::cos(half), std::sin(half)};
}

/// Draws an editable number with its description. Returns whether it changed.
bool edit_number(Interface& ui, const char* words, const char* note, double& value, const char* format) {
  ImGui::PushID(note);
  ImGui::SetNextItemWidth(110 * static_cast<float>(ui.scale()));
  const bool changed = ImGui::InputDouble("##number", &value, 0, 0, format);
  ui.note(note);
  ImGui::SameLine();
  ImGui::TextUnformatted(words);
  ImGui::PopID();
  return changed;
}

}  // namespace

void WindowPage::draw(Interface& ui, SetupSession& room, ConfigDraft& draft, std::int64_t now_ns) {
  look(draft, now_ns);
  draw_side_by_side(
      ui, 0.42, [&] { draw_settings(ui, draft); },
      [&] {
        draw_seen(ui, draft.config().window, now_ns);
        if (watch_) draw_display(ui, room.memory.seen);
        ImGui::Separator();
        if (draw_draft_changes(ui, draft, said_)) close();
      });
}

void WindowPage::close() {
  watch_.reset();
  is_read_ = false;
  is_old_ = true;
}

/// Opens the devices of the draft, unless text is being edited, and reads them.
void WindowPage::look(const ConfigDraft& draft, std::int64_t now_ns) {
  const WindowSettings& window = draft.config().window;
  if (!is_read_) address_.text = window.address;
  is_read_ = true;
  if (found_ns_ == 0 || now_ns - found_ns_ > list_again_ns) {
    found_ns_ = now_ns;
    found_ = face_cameras();
  }
  if (is_old_ && !ImGui::IsAnyItemActive()) {
    is_old_ = false;
    watch_.reset();
    ClientConfig seen;
    seen.tracker = window.address;
    seen.tracker_device = window.device;
    if (!window.address.empty()) watch_ = std::make_unique<DeviceWatch>(seen);
  }
  if (watch_) watch_->poll(now_ns);
}

void WindowPage::change(ConfigDraft& draft, const std::vector<ConfigChange>& changes) {
  const std::string why = draft.change(changes);
  said_ = {why, !why.empty()};
  is_old_ |= why.empty();
}

/// Applies the edited address as the camera. If it is also the tracker's camera, assigns its lens.
void WindowPage::name_camera(ConfigDraft& draft) {
  const ClientConfig& config = draft.config();
  std::vector<ConfigChange> changes = {{address_.key, address_.text}};
  try {
    const std::string camera = first_camera(address_.text), &lens = config.tracker_device.camera.lens;
    if (!camera.empty() && camera == first_camera(config.tracker) && !lens.empty())
      changes.push_back({"window.lens", draft.named(lens)});
  } catch (const InputError&) {
    // The draft reports the problem.
  }
  change(draft, changes);
}

void WindowPage::draw_settings(Interface& ui, ConfigDraft& draft) {
  title(ui.tr("The screen as a window"));
  wrapped(ui.tr("A camera tracks your eyes, and the view follows them."));
  if (edit_address(ui, address_, found_, ui.tr("No camera is connected.")) &&
      address_.text != draft.config().window.address)
    name_camera(draft);
  quiet(ui.tr("Enter face: followed by a camera's number, file, stream or synthetic:FILE"));
  if (!draft.problem().empty()) warning(draft.problem());
  if (draft.config().window.address.empty()) return;
  draw_camera(ui, draft);
  ImGui::Separator();
  draw_use(ui, draft);
}

/// Draws the fields for ruler measurements, in millimetres.
void WindowPage::draw_camera(Interface& ui, ConfigDraft& draft) {
  const ClientConfig& config = draft.config();
  const Pose& camera = config.window.device.placement.room_device;
  std::vector<ConfigChange> changes;
  double height = mm * config.window.height, apart = mm * config.window.device.face.eye_distance;
  if (edit_number(ui, ui.tr("mm: height of the image on the screen"), "height", height, "%.0f"))
    changes.push_back({"window.height", height / mm});
  quiet(ui.tr("Distance from the centre of the screen's image to the camera's lens:"));
  constexpr std::array<std::array<const char*, 2>, 3> axes = {{{msg("mm to the right"), "camera right"},
                                                               {msg("mm up"), "camera up"},
                                                               {msg("mm towards you"), "camera near"}}};
  std::vector<double> place(camera.p.data(), camera.p.data() + 3);
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    double there = mm * place[axis];
    if (!edit_number(ui, ui.tr(axes[axis][0]), axes[axis][1], there, "%.0f")) continue;
    place[axis] = there / mm;
    changes.push_back({"window.camera.position", place});
  }
  std::optional<double> down = downward_pitch(camera.q);
  if (!down)
    quiet(ui.tr("The camera's orientation is set in the configuration file: window.camera.orientation"));
  else if (edit_number(ui, ui.tr("° downward tilt"), "looks down", *down, "%.1f"))
    changes.push_back({"window.camera.orientation", written(looking_down(*down))});
  if (edit_number(ui, ui.tr("mm between your pupils"), "eyes apart", apart, "%.1f"))
    changes.push_back({"eyes.distance", apart / mm});
  quiet(config.eyes.distance
            ? ui.tr("An error of 1 % in the pupil distance changes your measured distance from the camera by "
                    "1 %.")
            : ui.tr("Not calibrated: using average adult values. Measure yours with the "
                    "ruler on the Pictures page."));
  if (!changes.empty()) change(draft, changes);
}

void WindowPage::draw_use(Interface& ui, ConfigDraft& draft) {
  const auto choice = [&](const char* name, const char* mode, bool pans) {
    if (ImGui::RadioButton(name, draft.config().window.pans == pans))
      change(draft, {{"window.mode", std::string(mode)}});
    ui.note(fmt::format("mode {}", mode));
  };
  choice(ui.tr("scene behind the screen"), "window", false);
  choice(ui.tr("face rotates the view"), "pan", true);
}

/// Returns the last detected eye position; nullopt: not detected recently.
std::optional<Vec3> WindowPage::eyes(std::int64_t now_ns) const {
  for (const WatchedStation& station : watch_->devices().front().stations)
    if (station.last.station == 0 && station.last.has_pose && now_ns - station.last.time_ns <= held_ns)
      return station.last.pose.p;
  return std::nullopt;
}

void WindowPage::draw_seen(Interface& ui, const WindowSettings& window, std::int64_t now_ns) {
  title(ui.tr("Your eyes"));
  if (!watch_) {
    quiet(ui.tr("Choose a camera to show the detected eye positions here."));
    return;
  }
  const ScreenGeometry screen = {window.height, window.device.placement.room_device.p};
  const std::optional<Vec3> at = eyes(now_ns);
  const std::string& problem = watch_->devices().front().status.message;
  const std::string distance = at ? distance_text(ui.words(), *at, screen) : ui.tr("No eyes detected.");
  // Eyes are lost and found again many times: nothing below their texts moves.
  ImGui::SetWindowFontScale(1.35f);
  wrapped(distance);
  keep_space_for(distance_text(ui.words(), far_eyes, screen));
  ImGui::SetWindowFontScale(1);
  if (at) ui.note("reported: eyes " + distance);
  wrapped(at ? direction_text(ui.words(), *at) : "");
  keep_space_for(direction_text(ui.words(), far_eyes));
  if (ImGui::Button(ui.tr("Restart camera"))) is_old_ = true;
  ui.note("look anew");
  ImGui::SameLine();
  const char* const advice =
      ui.tr("Check with a ruler: distance from the lens to the point between your eyes.");
  if (problem.empty())
    quiet(advice);
  else
    warning(problem);
  keep_space_for(advice);
  ui.note("window trouble: " + problem);
  draw_eye_position(ui, at, screen);
}

/// Shows a warning if the selected display has no window mode.
void WindowPage::draw_display(Interface& ui, DisplaySettings& seen) {
  const DisplaySettings usual;
  if (seen.display == usual.display) return;
  warning(ui.tr("The display is set to {}. Show sessions in a window, or clear the camera field to join.",
                seen.display));
  if (ImGui::Button(ui.tr("Show sessions in a window"))) seen.display = usual.display;
  ui.note("in a window");
}

}  // namespace prosector
