#include "client/setup/eye_crosses.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>

#include "client/setup/fields.h"
#include "common/error.h"
#include "drivers/config/tracker_roles.h"

namespace prosector {
namespace {

constexpr std::array<std::size_t, 3> cross_counts = {min_seen_points, 16, max_crosses};

}  // namespace

void EyeCrossCalibration::draw_settings_form(Interface& ui, const ClientConfig& config, Said& said) {
  quiet(ui.tr(
      "Wear the display with the head's receiver on it. Crosses appear one after the other. With one eye "
      "closed, move your head until the cross covers a mark in the room, hold still, and press Space."));
  ImGui::PushItemWidth(270 * static_cast<float>(ui.scale()));
  edit_vector(ui.tr("position of the mark, m"), mark_);
  ui.note("mark");
  if (ImGui::BeginCombo(ui.tr("display"), displays_.empty() ? "" : displays_[display_].name.c_str())) {
    for (std::size_t k = 0; k < displays_.size(); ++k) {
      if (ImGui::Selectable(displays_[k].name.c_str(), k == display_)) display_ = k;
      ui.note(displays_[k].name);
    }
    ImGui::EndCombo();
  }
  ui.note("eyes' display");
  ImGui::PopItemWidth();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(ui.tr("Crosses for each eye:"));
  for (const std::size_t count : cross_counts) {
    ImGui::SameLine();
    if (ImGui::RadioButton(std::to_string(count).c_str(), crosses_ == count)) crosses_ = count;
    ui.note(fmt::format("crosses {}", count));
  }
  quiet(ui.tr("The crosses must fill the display: choose \"full screen\" and the screen's number."));
  if (ImGui::Button(ui.tr("Start"))) begin(config, said);
  ui.note("begin eyes");
}

void EyeCrossCalibration::begin(const ClientConfig& config, Said& said) {
  said = {};
  try {
    if (displays_.empty()) throw InputError(msg("No side-by-side display profile found."));
    const EyeDisplay& display = displays_[display_];
    const ClientConfig seen = config_for_role(config, StationRole::head);
    auto guide = std::make_unique<EyesGuide>(seen, mark_, display.width, display.height, crosses_);
    guide_ = guide.get();
    running_ =
        std::make_unique<GuidedCalibration>(std::move(guide), tracker_of(seen), EyesGuide::device(seen));
    begun_ = true;
  } catch (const InputError& error) {
    said = {error.what(), true};
  }
}

std::optional<GuideOutcome> EyeCrossCalibration::draw_cross(Interface& ui, Said& said) {
  running_->poll();
  const GuideStep step = running_->step();
  if (step.done) {
    std::optional<GuideOutcome> out;
    try {
      out = guide_->outcome();
    } catch (const InputError& error) {
      said = {error.what(), true};
    }
    close();
    return out;
  }
  said = {ui.tr("Cross {} of {}", step.index + 1, step.count), false};
  const ImVec2 all = ImGui::GetIO().DisplaySize;
  const EyeDisplay& display = displays_[display_];
  const float wide = all.x / 2, left = guide_->right_eye() != display.swapped ? wide : 0;
  const float x = left + static_cast<float>(step.pixel->x()) * wide / static_cast<float>(display.width);
  const float y = static_cast<float>(step.pixel->y()) * all.y / static_cast<float>(display.height);
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(all);
  if (begun_) ImGui::SetNextWindowFocus();
  ImGui::PushStyleColor(ImGuiCol_WindowBg, {0, 0, 0, 1});
  ImGui::Begin("crosses", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
  const auto scale = static_cast<float>(ui.scale());
  const float arm = 22 * scale, gap = 4 * scale;
  constexpr ImU32 shade = IM_COL32(120, 255, 140, 255);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const float sign : {-1.f, 1.f}) {
    list.AddLine({x + sign * gap, y}, {x + sign * arm, y}, shade, 2 * scale);
    list.AddLine({x, y + sign * gap}, {x, y + sign * arm}, shade, 2 * scale);
  }
  draw_words(ui, step, left, wide, y > all.y / 2, said);
  ImGui::End();
  ImGui::PopStyleColor();
  begun_ = false;
  return std::nullopt;
}

/// Draws text in the eye's view, away from the cross.
void EyeCrossCalibration::draw_words(Interface& ui, const GuideStep& step, float left, float width,
                                     bool above, Said& said) {
  const auto scale = static_cast<float>(ui.scale());
  const float margin = 24 * scale, height = 190 * scale;
  ImGui::SetCursorPos({left + margin, above ? margin : ImGui::GetIO().DisplaySize.y - margin - height});
  ImGui::BeginChild("words", {width - 2 * margin, height});
  wrapped(ui.tr(step.instruction));
  ImGui::ProgressBar(static_cast<float>(step.progress), {-1, 0},
                     ui.tr("{} of {}", step.index + 1, step.count).c_str());
  const bool covered = ImGui::Button(ui.tr("Aligned (Space)"));
  ui.note("covered");
  ImGui::SameLine();
  const bool again = ImGui::Button(ui.tr("Repeat this step"));
  ui.note("back");
  ImGui::SameLine();
  const bool stops = ImGui::Button(ui.tr("Stop"));
  ui.note("stop");
  if (!step.rejection.empty()) {
    warning(ui.tr(step.rejection));
    ui.note("trouble");
  }
  const DeviceStatus device = running_->device();
  if (device.health != DeviceHealth::streaming && !device.message.empty()) warning(device.message);
  quiet(residuals(ui));
  ImGui::EndChild();
  // Space always confirms the cross, unless it activates another button.
  const bool space = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Space), false);
  if (covered || (space && !again && !stops)) guide_->confirm();
  if (again) running_->back();
  if (!stops) return;
  close();
  said = {msg("Stopped. Nothing was changed."), false};
}

/// Returns a text with the fit's residual for each eye with enough crosses.
std::string EyeCrossCalibration::residuals(const Interface& ui) const {
  std::string out;
  for (const bool right : {false, true}) try {
      const double residual = guide_->fit(right).residual;
      out += (out.empty() ? "" : "; ") + (right ? ui.tr("right eye: residual {:.2f} pixels", residual)
                                                : ui.tr("left eye: residual {:.2f} pixels", residual));
    } catch (const InputError&) {
      continue;  // not enough crosses yet
    }
  return out;
}

}  // namespace prosector
