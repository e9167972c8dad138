#include "client/setup/window_page.h"

#include <fmt/format.h>
#include <imgui.h>

#include <cmath>
#include <numbers>

#include "client/setup/beside.h"
#include "client/setup/draft_changes.h"
#include "client/setup/eyes_shown.h"
#include "common/error.h"

namespace prosector {
namespace {

constexpr std::int64_t list_again_ns = 2'000'000'000, held_ns = 500'000'000;  // eyes are shown as last seen
constexpr double mm = 1000;                                                   // of a metre
constexpr const char* face_driver = "face:";

/// Lists cameras by the addresses at which they see a face.
std::vector<FoundDevice> face_cameras() {
  std::vector<FoundDevice> out = found_cameras();
  for (FoundDevice& camera : out)
    for (std::string& address : camera.addresses) address.insert(0, face_driver);
  return out;
}

/// Returns by how much a camera looks down that is turned to the user, degrees; none: it is turned otherwise.
std::optional<double> looks_down(const Quat& q) {
  constexpr double least = 1e-6;
  if (std::abs(q.w()) > least || std::abs(q.x()) > least) return std::nullopt;
  return 2 * std::atan(q.z() / q.y()) * 180 / std::numbers::pi;
}

Quat looking_down(double degrees) {
  const double half = degrees * std::numbers::pi / 360;
  return {0, 0, std::cos(half), std::sin(half)};
}

/// Shows a number and what it is. Returns whether it was changed.
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

void WindowPage::draw(Interface& ui, Anteroom& room, ConfigDraft& draft, std::int64_t now_ns) {
  look(draft, now_ns);
  draw_beside(
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

/// Opens what the draft names, once nothing is being typed, and reads it.
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

/// Takes what was typed as the camera. One that is the tracker's, too, has its lens.
void WindowPage::name_camera(ConfigDraft& draft) {
  const ClientConfig& config = draft.config();
  std::vector<ConfigChange> changes = {{address_.key, address_.text}};
  try {
    const std::string camera = first_camera(address_.text), &lens = config.tracker_device.lens;
    if (!camera.empty() && camera == first_camera(config.tracker) && !lens.empty())
      changes.push_back({"window.lens", draft.named(lens)});
  } catch (const InputError&) {
    // The draft says what is wrong with it.
  }
  change(draft, changes);
}

void WindowPage::draw_settings(Interface& ui, ConfigDraft& draft) {
  title(ui.tr("The screen as a window"));
  wrapped(ui.tr("A camera sees your eyes, and the view follows them."));
  if (edit_address(ui, address_, found_, ui.tr("No camera is plugged in.")) &&
      address_.text != draft.config().window.address)
    name_camera(draft);
  quiet(ui.tr("face: and a camera's number, file, stream or synthetic:FILE"));
  if (!draft.problem().empty()) warning(draft.problem());
  if (draft.config().window.address.empty()) return;
  draw_camera(ui, draft);
  ImGui::Separator();
  draw_use(ui, draft);
}

/// Asks for what a ruler tells, in millimetres.
void WindowPage::draw_camera(Interface& ui, ConfigDraft& draft) {
  const ClientConfig& config = draft.config();
  const Pose& camera = config.window.device.room_device;
  std::vector<ConfigChange> changes;
  double height = mm * config.window.height, apart = mm * config.window.device.eye_distance;
  if (edit_number(ui, ui.tr("mm high, the picture on the screen"), "height", height, "%.0f"))
    changes.push_back({"window.height", height / mm});
  quiet(ui.tr("From the picture's middle to the camera's lens:"));
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
  std::optional<double> down = looks_down(camera.q);
  if (!down)
    quiet(ui.tr("How it is turned stands in the file: window.camera.orientation"));
  else if (edit_number(ui, ui.tr("° that it looks down"), "looks down", *down, "%.1f"))
    changes.push_back({"window.camera.orientation", written(looking_down(*down))});
  if (edit_number(ui, ui.tr("mm between your pupils"), "eyes apart", apart, "%.1f"))
    changes.push_back({"eyes.distance", apart / mm});
  quiet(config.eyes.distance
            ? ui.tr("A per cent off is a per cent of your distance.")
            : ui.tr("Nobody measured them: these are people's in the mean. The page of pictures finds "
                    "yours by a ruler."));
  if (!changes.empty()) change(draft, changes);
}

void WindowPage::draw_use(Interface& ui, ConfigDraft& draft) {
  const auto choice = [&](const char* name, const char* mode, bool pans) {
    if (ImGui::RadioButton(name, draft.config().window.pans == pans))
      change(draft, {{"window.mode", std::string(mode)}});
    ui.note(fmt::format("mode {}", mode));
  };
  choice(ui.tr("what is drawn lies behind the screen"), "window", false);
  choice(ui.tr("your face turns the view"), "pan", true);
}

/// Returns where the eyes were seen last; none: not for a while.
std::optional<Vec3> WindowPage::eyes(std::int64_t now_ns) const {
  for (const WatchedStation& station : watch_->devices().front().stations)
    if (station.last.station == 0 && station.last.has_pose && now_ns - station.last.time_ns <= held_ns)
      return station.last.pose.p;
  return std::nullopt;
}

void WindowPage::draw_seen(Interface& ui, const WindowSettings& window, std::int64_t now_ns) {
  title(ui.tr("Your eyes"));
  if (!watch_) {
    quiet(ui.tr("Name a camera, and where it sees your eyes is shown here."));
    return;
  }
  const ScreenPlace screen = {window.height, window.device.room_device.p};
  const std::optional<Vec3> at = eyes(now_ns);
  const std::string& trouble = watch_->devices().front().status.message;
  const std::string distance = at ? distance_words(ui.words(), *at, screen) : ui.tr("No eyes are seen.");
  ImGui::SetWindowFontScale(1.35f);
  wrapped(distance);
  ImGui::SetWindowFontScale(1);
  if (at) ui.note("told: eyes " + distance);
  wrapped(at ? direction_words(ui.words(), *at) : "");
  if (ImGui::Button(ui.tr("Look anew"))) is_old_ = true;
  ui.note("look anew");
  ImGui::SameLine();
  // Beside the button, trouble that comes and goes moves nothing below.
  if (trouble.empty())
    quiet(ui.tr("Check it with a ruler: from the lens to between your eyes."));
  else
    warning(trouble);
  ui.note("window trouble: " + trouble);
  draw_eyes_before(ui, at, screen);
}

/// Says where the way in which sessions are seen has no window into the room.
void WindowPage::draw_display(Interface& ui, SeenAs& seen) {
  const SeenAs usual;
  if (seen.display == usual.display) return;
  warning(
      ui.tr("You see sessions by {}: none is entered while a camera is named here. See them in a "
            "window, or name none.",
            seen.display));
  if (ImGui::Button(ui.tr("See them in a window"))) seen.display = usual.display;
  ui.note("in a window");
}

}  // namespace prosector
