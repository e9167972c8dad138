#include "client/setup/calibrate_page.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <array>
#include <utility>

#include "client/setup/draft_changes.h"
#include "client/setup/fields.h"
#include "client/setup/side_by_side.h"
#include "common/error.h"

namespace prosector {
namespace {

constexpr std::size_t words_at_once = 7;  // lines of a result; the others are shown on request

}  // namespace

void CalibratePage::draw(Interface& ui, ConfigDraft& draft, std::int64_t now_ns) {
  draw_side_by_side(
      ui, 0.26, [&] { draw_choice(ui); }, [&] { draw_chosen(ui, draft, now_ns); });
}

void CalibratePage::draw_chosen(Interface& ui, ConfigDraft& draft, std::int64_t now_ns) {
  title(ui.tr(chosen_ == nullptr ? live_->name() : chosen_->name));
  wrapped(ui.tr(chosen_ == nullptr ? live_->about() : chosen_->about));
  ImGui::Separator();
  if (chosen_ == nullptr)
    live_->draw(ui, draft, said_, now_ns);
  else if (running_)
    draw_running(ui, draft);
  else if (shows_outcome_)
    draw_outcome(ui);
  else
    draw_settings_form(ui, draft);
  ImGui::Separator();
  if (!draw_draft_changes(ui, draft, said_)) return;
  live_->close();
  shape_.clear();
}

void CalibratePage::close() {
  running_.reset();
  live_->close();
  shape_.clear();
}

void CalibratePage::choose(const ProcedureRow* row) {
  if (row == chosen_) return;
  close();
  chosen_ = row;
  shows_outcome_ = row != nullptr && outcomes_.contains(row->name);
  said_ = {};
}

void CalibratePage::draw_choice(Interface& ui) {
  title(ui.tr(heading_));
  if (ImGui::Selectable(ui.tr(live_->name()), chosen_ == nullptr)) choose(nullptr);
  ui.note(live_->name());
  for (const ProcedureRow& row : rows_) {
    if (ImGui::Selectable(ui.tr(row.name), &row == chosen_)) choose(&row);
    ui.note(row.name);
    const auto outcome = outcomes_.find(row.name);
    if (outcome == outcomes_.end()) continue;
    quiet(outcome->second.front());
    ui.note("reported: " + outcome->second.front());
  }
}

void CalibratePage::draw_settings_form(Interface& ui, ConfigDraft& draft) {
  if (!std::exchange(knows_role_, true)) calibration_settings_.role = pointer_role(draft.config());
  ImGui::PushItemWidth(330 * static_cast<float>(ui.scale()));
  for (const CalibrationSetting asked : chosen_->asked) switch (asked) {
      case CalibrationSetting::role:
        edit_role(ui, calibration_settings_.role);
        break;
      case CalibrationSetting::hand:
        edit_hand(ui, calibration_settings_.hand);
        break;
      case CalibrationSetting::points:
        quiet(ui.tr("Points to touch, in this order: x to the right, y up, z towards you, m."));
        draw_points(ui, calibration_settings_.points);
        break;
      case CalibrationSetting::grid:
        draw_grid(ui);
        break;
      case CalibrationSetting::seconds:
        ImGui::InputDouble(ui.tr("seconds"), &calibration_settings_.seconds, 0, 0, "%.0f");
        ui.note("seconds");
        calibration_settings_.seconds = std::clamp(calibration_settings_.seconds, 2., 600.);
        break;
      case CalibrationSetting::against:
        ImGui::InputText(ui.tr("second device, DRIVER:PATH"), &calibration_settings_.against);
        ui.note("against");
        break;
      case CalibrationSetting::shape:
        draw_shape(ui, draft);
        break;
      case CalibrationSetting::landmarks:
        quiet(ui.tr(
            "Points of the shape to touch, in this order and on all sides, in the shape's own frame, m."));
        draw_points(ui, calibration_settings_.landmarks);
        edit_vector(ui.tr("target: point whose error is reported"), calibration_settings_.target);
        ui.note("target");
        break;
    }
  ImGui::PopItemWidth();
  if (ImGui::Button(ui.tr("Start"))) begin(draft);
  ui.note("begin");
}

void CalibratePage::draw_points(Interface& ui, std::vector<Vec3>& points) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::string name = fmt::format("point {}", k + 1);
    edit_vector(fmt::format("{}###{}", ui.tr("point {}", k + 1), name).c_str(), points[k]);
    ui.note(name);
  }
  if (ImGui::Button(ui.tr("Add a point"))) points.push_back(points.back());
  ui.note("one more");
  ImGui::SameLine();
  if (ImGui::Button(ui.tr("Remove a point")) && points.size() > 3) points.pop_back();
  ui.note("one less");
}

/// Returns the draft's settings of the phantom's shape.
std::vector<CalibratePage::TypedKey> CalibratePage::shape_of(const ConfigDraft& draft) {
  const PhantomSettings& phantom = draft.config().phantom;
  return {{"phantom.body", msg("scene body with the phantom's shape"), phantom.body},
          {"phantom.mesh", msg("or a shape file"), draft.named(phantom.mesh)},
          {"phantom.board", msg("board fixed to the phantom; none: it does not move"),
           draft.named(phantom.board)}};
}

void CalibratePage::draw_shape(Interface& ui, const ConfigDraft& draft) {
  if (shape_.empty()) shape_ = shape_of(draft);
  for (TypedKey& typed : shape_) {
    ImGui::InputText(ui.tr(typed.name), &typed.text);
    ui.note(typed.key);
  }
}

void CalibratePage::draw_grid(Interface& ui) {
  edit_vector(ui.tr("lower corner"), calibration_settings_.grid.low);
  ui.note("lower corner");
  edit_vector(ui.tr("upper corner"), calibration_settings_.grid.high);
  ui.note("upper corner");
  std::array<int, 3> count{};
  for (std::size_t a = 0; a < 3; ++a) count[a] = static_cast<int>(calibration_settings_.grid.count[a]);
  const bool changed = ImGui::InputInt3(ui.tr("points along x, y, z"), count.data());
  ui.note("grid points");
  for (std::size_t a = 0; changed && a < 3; ++a)
    calibration_settings_.grid.count[a] = static_cast<std::size_t>(std::clamp(count[a], 3, 20));
}

/// Starts the chosen calibration. Before that, applies the edited phantom's shape to the draft.
void CalibratePage::begin(ConfigDraft& draft) {
  said_ = {};
  std::vector<ConfigChange> changes;
  const std::vector<TypedKey> known = shape_of(draft);
  for (std::size_t k = 0; k < shape_.size(); ++k)
    if (shape_[k].text != known[k].text) changes.push_back({shape_[k].key, shape_[k].text});
  if (const std::string why = changes.empty() ? "" : draft.change(changes); !why.empty()) {
    said_ = {why, true};
    return;
  }
  try {
    running_ = chosen_->begin(draft.config(), calibration_settings_);
  } catch (const InputError& error) {
    said_ = {error.what(), true};
  }
}

void CalibratePage::draw_running(Interface& ui, ConfigDraft& draft) {
  running_->poll();
  const GuideStep step = running_->step();
  if (step.done) {
    finish(draft);
    return;
  }
  said_ = {ui.tr("Step {} of {}", step.index + 1, step.count), false};
  ImGui::SetWindowFontScale(1.35f);
  wrapped(ui.tr(step.instruction));
  ImGui::SetWindowFontScale(1);
  ImGui::ProgressBar(static_cast<float>(step.progress), {-1, 0}, "");
  ImGui::ProgressBar(static_cast<float>(step.index) / static_cast<float>(step.count),
                     {-1, 6 * static_cast<float>(ui.scale())}, "");
  if (!step.rejection.empty()) warning(ui.tr(step.rejection));
  const DeviceStatus device = running_->device();
  if (device.health != DeviceHealth::streaming && !device.message.empty()) warning(device.message);
  if (ImGui::Button(ui.tr("Repeat this step"))) running_->back();
  ui.note("back");
  ImGui::SameLine();
  if (ImGui::Button(ui.tr("Stop"))) {
    running_.reset();
    said_ = {msg("Stopped. Nothing was changed."), false};
  }
  ui.note("stop");
}

/// Applies the result to the draft. A field map is a separate file, which the configuration names.
void CalibratePage::finish(ConfigDraft& draft) {
  try {
    GuideOutcome outcome;
    if (const auto* field = dynamic_cast<const FieldGuide*>(&running_->guide())) {
      const FieldFit fit = field->fit();
      std::filesystem::create_directories(draft.file().parent_path());
      save_config_text(draft.file().parent_path() / field_map_file, write_field_map(fit.map));
      field_ = picture_of(field->samples(), fit);
      outcome = field->outcome_of(fit);
    } else {
      outcome = running_->guide().outcome();
    }
    outcomes_[chosen_->name] = outcome.words;
    shows_outcome_ = true;
    said_ = apply_outcome(draft, outcome);
  } catch (const InputError& error) {
    said_ = {error.what(), true};
  }
  running_.reset();
}

/// Draws the result in place of the settings, so that it is visible without scrolling.
void CalibratePage::draw_outcome(Interface& ui) {
  if (chosen_->begin == begin_field && field_) draw_field_picture(ui, *field_);
  const std::vector<std::string>& words = outcomes_.at(chosen_->name);
  for (std::size_t k = 0; k < std::min(words.size(), words_at_once); ++k)
    if (words.size() <= words_at_once || k < 2) wrapped(words[k]);
  if (words.size() > words_at_once && ImGui::CollapsingHeader(ui.tr("More")))
    for (std::size_t k = 2; k < words.size(); ++k) wrapped(words[k]);
  if (ImGui::Button(ui.tr("Repeat"))) shows_outcome_ = false;
  ui.note("once more");
}

}  // namespace prosector
