#include "client/setup/camera_page.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <chrono>

#include "client/setup/draft_changes.h"
#include "client/setup/side_by_side.h"
#include "common/error.h"
#include "drivers/camera/calibration/camera_report.h"
#include "drivers/camera/tags/standard_boards.h"
#include "drivers/device/driver_table.h"

namespace prosector {
namespace {

constexpr std::int64_t list_again_ns = 2'000'000'000, picture_due_ns = 1'500'000'000;
constexpr const char* lens_file = "camera.toml";  // next to the configuration file
constexpr const char* shown_board = "calibration";
constexpr ImU32 tag_shade = IM_COL32(110, 255, 140, 255), cell_shade = IM_COL32(60, 200, 110, 60);

/// Returns the camera that a configuration uses: the tracker's, else that of the window's face tracker.
std::string known_camera(const ClientConfig& config) {
  const std::string tracker = first_camera(config.tracker);
  return tracker.empty() ? first_camera(config.window.address) : tracker;
}

}  // namespace

std::vector<ConfigChange> lens_changes(const ClientConfig& config, const std::string& camera) {
  const std::string lens = lens_file;
  std::vector<ConfigChange> out;
  if (first_camera(config.window.address) == camera) out.push_back({"window.lens", lens});
  if (first_camera(config.tracker) == camera) out.push_back({"tracker.lens", lens});
  if (out.empty() && config.tracker.empty())
    out = {{"tracker.lens", lens}, {"tracker.address", "tags:" + camera}};
  return out;
}

void CameraPage::draw(Interface& ui, ConfigDraft& draft, std::int64_t now_ns) {
  if (found_ns_ == 0 || now_ns - found_ns_ > list_again_ns) {
    if (found_ns_ == 0) address_ = known_camera(draft.config());
    found_ns_ = now_ns;
    found_ = found_cameras();
  }
  if (watch_) seen_ = watch_->picture();
  if (fit_.valid() && fit_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
    take_fit(ui, draft);
  draw_side_by_side(
      ui, 0.36,
      [&] {
        draw_choice(ui, now_ns);
        ImGui::Separator();
        draw_steps(ui);
        ImGui::Separator();
        draw_draft_changes(ui, draft, said_);
      },
      [&] {
        draw_error(ui, now_ns);
        draw_picture(ui);
      });
}

void CameraPage::close() {
  watch_.reset();
  guides_ = false;
  seen_ = {};
  shown_ = 0;
}

void CameraPage::open(const std::string& address, std::int64_t now_ns) {
  close();
  address_ = address;
  outcome_.clear();
  said_ = {};
  if (address.empty()) return;
  opened_ns_ = now_ns;
  watch_ = std::make_unique<CameraWatch>(address);
}

void CameraPage::draw_choice(Interface& ui, std::int64_t now_ns) {
  title(ui.tr("Camera"));
  for (const FoundDevice& camera : found_) {
    const std::string& address = camera.addresses.front();
    if (ImGui::Selectable(camera.name.c_str(), watch_ && address_ == address)) open(address, now_ns);
    ui.note(address);
  }
  if (found_.empty()) quiet(ui.tr("No camera is connected."));
  quiet(ui.tr("Or enter a camera's number, file, stream or synthetic:FILE"));
  ImGui::SetNextItemWidth(-1);
  const bool entered = ImGui::InputText("##camera", &address_, ImGuiInputTextFlags_EnterReturnsTrue);
  ui.note("camera address");
  const bool looks = ImGui::Button(ui.tr("View image"));
  ui.note("look");
  if (entered || looks) open(address_, now_ns);
  if (!watch_) return;
  ImGui::SameLine();
  if (ImGui::Button(ui.tr("Release camera"))) close();
  ui.note("let go");
}

void CameraPage::draw_steps(Interface& ui) {
  title(ui.tr("Lens"));
  if (fit_.valid()) {
    wrapped(ui.tr("Fitting the lens: this takes a few seconds."));
    return;
  }
  if (guides_) {
    draw_guide(ui);
    return;
  }
  if (outcome_.empty())
    quiet(ui.tr("Print the board \"calibration\" with: prosector-board calibration --out board.pdf"));
  for (const std::string& line : outcome_) wrapped(line);
  if (!watch_) return;
  if (ImGui::Button(
          fmt::format("{}###calibrate", outcome_.empty() ? ui.tr("Calibrate") : ui.tr("Repeat")).c_str())) {
    outcome_.clear();
    watch_->guide(find_board(shown_board));
    guides_ = true;
    said_ = {};
  }
  ui.note("calibrate");
}

void CameraPage::draw_guide(Interface& ui) {
  const LensGuideStep& step = seen_.step;
  ImGui::SetWindowFontScale(1.35f);
  wrapped(step.instruction.empty() ? ui.tr("show the camera the board") : ui.tr(step.instruction));
  ImGui::SetWindowFontScale(1);
  const std::string views = ui.tr("{} of {} views", step.views, recommended_views);
  ImGui::ProgressBar(std::min(1.f, static_cast<float>(step.views) / static_cast<float>(recommended_views)),
                     {-1, 0}, views.c_str());
  ui.note(fmt::format("reported: views {}", step.views));
  const std::string covered = ui.tr("{:.0f} % covered", 100 * step.covered);
  ImGui::ProgressBar(static_cast<float>(step.covered), {-1, 0}, covered.c_str());
  bool fits = step.done;
  if (step.views >= min_views) {
    fits |= ImGui::Button(ui.tr("Fit now"));
    ui.note("fit now");
    ImGui::SameLine();
  }
  const bool stops = ImGui::Button(ui.tr("Stop"));
  ui.note("stop");
  if (fits) begin_fit();
  if (!stops) return;
  watch_->stop_guide();
  guides_ = false;
  said_ = {msg("Stopped. Nothing was changed."), false};
}

/// Starts the fit on a separate thread. The views are copied, so that the camera may be closed meanwhile.
void CameraPage::begin_fit() {
  fit_ends_ = std::stop_source();
  fit_ = std::async(std::launch::async,
                    [views = watch_->views(), camera = watch_->identity(), stop = fit_ends_.get_token()] {
                      return fit_lens(find_board(shown_board), views, camera, stop);
                    });
  fitted_ = address_;
  watch_->stop_guide();
  guides_ = false;
  said_ = {msg("Fitting …"), false};
}

/// Applies the result to the draft. A lens is a separate file, which the configuration names.
void CameraPage::take_fit(const Interface& ui, ConfigDraft& draft) {
  try {
    const LensFit fit = fit_.get();
    const Lens& lens = fit.calibration.lens;
    GuideOutcome outcome = {
        {ui.tr("Lens error {:.3f} px in views not used for the fit.", fit.held_out),
         ui.tr("Focal lengths {:.1f} and {:.1f} px; the views cover {:.0f} % of the image.", lens.fx, lens.fy,
               100 * fit.covered)},
        {}};
    if (!fit.by_edges) outcome.words.push_back(ui.tr(coarse_lens_warning));
    const std::string& tracker = draft.config().tracker;
    const std::string& known_lens = draft.config().tracker_device.camera.lens;
    outcome.changes = lens_changes(draft.config(), fitted_);
    if (outcome.changes.empty() && !known_lens.ends_with(lens_file))
      outcome.words.push_back(
          ui.tr("The tracker is {}, not this camera. To use this camera for see-through, set tracker.lens to "
                "the file.",
                tracker));
    outcome_ = outcome.words;
    said_ = apply_outcome(draft, outcome);
    if (!said_.wrong) draft.add_companion_file(lens_file, write_calibration(fit.calibration));
  } catch (const std::exception& error) {  // exceptions of other types come from libraries
    said_ = {error.what(), true};
  }
}

void CameraPage::draw_error(Interface& ui, std::int64_t now_ns) const {
  if (!watch_) {
    quiet(ui.tr("Choose a camera to show its image here."));
    return;
  }
  const CameraState state = watch_->state();
  std::string words;
  if (!state.problem.empty())
    words = state.problem;
  else if (now_ns - std::max(opened_ns_, state.last_ns) > picture_due_ns)
    words = msg("No image received.");
  else if (seen_.image && seen_.brightness < least_light)
    words = msg("Too dark: add light.");
  else if (seen_.image && seen_.tags.empty())
    words = msg("No board detected.");
  if (words.empty())
    quiet(ui.tr("{} tags detected.", seen_.tags.size()));
  else
    warning(ui.tr(words));
  ui.note("camera trouble: " + words);
}

/// Draws the image as large as possible, with its tags and the cells covered by views.
void CameraPage::draw_picture(Interface& ui) {
  if (!watch_ || !seen_.image) return;
  const auto scale = static_cast<float>(ui.scale());
  if (shown_ != seen_.number) texture_ = ui.texture_of(*seen_.image, texture_);
  shown_ = seen_.number;
  quiet(ui.tr("{} × {} pixels, {:.0f} images per second, brightness {:.0f} of 255", seen_.image->width,
              seen_.image->height, seen_.rate, seen_.brightness));
  const auto wide = static_cast<float>(seen_.image->width), high = static_cast<float>(seen_.image->height);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float zoom = std::min(room.x / wide, std::max(room.y, 240 * scale) / high);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::Image(texture_, {zoom * wide, zoom * high});
  ui.note("camera picture");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float cell_wide = zoom * wide / cells_across, cell_high = zoom * high / cells_down;
  for (const auto& [column, row] : seen_.covered) {
    const ImVec2 low = {at.x + static_cast<float>(column) * cell_wide,
                        at.y + static_cast<float>(row) * cell_high};
    list.AddRectFilled(low, {low.x + cell_wide, low.y + cell_high}, cell_shade);
  }
  for (const DetectedTag& tag : seen_.tags) {
    for (const Vec2& corner : tag.corners)
      list.PathLineTo(
          {at.x + zoom * static_cast<float>(corner.x()), at.y + zoom * static_cast<float>(corner.y())});
    list.PathStroke(tag_shade, ImDrawFlags_Closed, 2 * scale);
  }
}

}  // namespace prosector
