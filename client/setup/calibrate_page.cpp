#include "client/setup/calibrate_page.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <array>
#include <utility>

#include "client/setup/beside.h"
#include "client/setup/draft_changes.h"
#include "client/setup/fields.h"
#include "common/error.h"

namespace prosector {
namespace {

constexpr std::size_t words_at_once = 7;  // of an outcome; the others are shown when they are asked for

}  // namespace

void CalibratePage::draw(Interface& ui, ConfigDraft& draft, std::int64_t now_ns) {
  draw_beside(
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
    draw_wishes(ui, draft);
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
    const auto told = outcomes_.find(row.name);
    if (told == outcomes_.end()) continue;
    quiet(told->second.front());
    ui.note("told: " + told->second.front());
  }
}

void CalibratePage::draw_wishes(Interface& ui, ConfigDraft& draft) {
  if (!std::exchange(knows_role_, true)) wishes_.role = touching_role(draft.config());
  ImGui::PushItemWidth(330 * static_cast<float>(ui.scale()));
  for (const Asked asked : chosen_->asked) switch (asked) {
      case Asked::role:
        edit_role(ui, wishes_.role);
        break;
      case Asked::hand:
        edit_hand(ui, wishes_.hand);
        break;
      case Asked::points:
        quiet(ui.tr("Points to touch, in this order: x to the right, y up, z towards you, m."));
        draw_points(ui, wishes_.points);
        break;
      case Asked::grid:
        draw_grid(ui);
        break;
      case Asked::seconds:
        ImGui::InputDouble(ui.tr("seconds"), &wishes_.seconds, 0, 0, "%.0f");
        ui.note("seconds");
        wishes_.seconds = std::clamp(wishes_.seconds, 2., 600.);
        break;
      case Asked::against:
        ImGui::InputText(ui.tr("the second device, DRIVER:PATH"), &wishes_.against);
        ui.note("against");
        break;
      case Asked::shape:
        draw_shape(ui, draft);
        break;
      case Asked::landmarks:
        quiet(ui.tr(
            "Points of the shape to touch, in this order, all around it: in the shape's own frame, m."));
        draw_points(ui, wishes_.landmarks);
        edit_vector(ui.tr("target: its error is told"), wishes_.target);
        ui.note("target");
        break;
    }
  ImGui::PopItemWidth();
  if (ImGui::Button(ui.tr("Begin"))) begin(draft);
  ui.note("begin");
}

void CalibratePage::draw_points(Interface& ui, std::vector<Vec3>& points) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::string name = fmt::format("point {}", k + 1);
    edit_vector(fmt::format("{}###{}", ui.tr("point {}", k + 1), name).c_str(), points[k]);
    ui.note(name);
  }
  if (ImGui::Button(ui.tr("One more"))) points.push_back(points.back());
  ui.note("one more");
  ImGui::SameLine();
  if (ImGui::Button(ui.tr("One less")) && points.size() > 3) points.pop_back();
  ui.note("one less");
}

/// Returns what the draft says of the phantom's shape.
std::vector<CalibratePage::TypedKey> CalibratePage::shape_of(const ConfigDraft& draft) {
  const PhantomSettings& phantom = draft.config().phantom;
  return {{"phantom.body", msg("the scene's body whose shape it has"), phantom.body},
          {"phantom.mesh", msg("or a file of its shape"), draft.named(phantom.mesh)},
          {"phantom.board", msg("the board fixed to it; none: it stands still"), draft.named(phantom.board)}};
}

void CalibratePage::draw_shape(Interface& ui, const ConfigDraft& draft) {
  if (shape_.empty()) shape_ = shape_of(draft);
  for (TypedKey& typed : shape_) {
    ImGui::InputText(ui.tr(typed.name), &typed.text);
    ui.note(typed.key);
  }
}

void CalibratePage::draw_grid(Interface& ui) {
  edit_vector(ui.tr("lower corner"), wishes_.grid.low);
  ui.note("lower corner");
  edit_vector(ui.tr("upper corner"), wishes_.grid.high);
  ui.note("upper corner");
  std::array<int, 3> count{};
  for (std::size_t a = 0; a < 3; ++a) count[a] = static_cast<int>(wishes_.grid.count[a]);
  const bool changed = ImGui::InputInt3(ui.tr("points along x, y, z"), count.data());
  ui.note("grid points");
  for (std::size_t a = 0; changed && a < 3; ++a)
    wishes_.grid.count[a] = static_cast<std::size_t>(std::clamp(count[a], 3, 20));
}

/// Begins what is chosen. What was typed of a phantom's shape is taken into the draft before.
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
    running_ = chosen_->begin(draft.config(), wishes_);
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
  if (!step.trouble.empty()) warning(ui.tr(step.trouble));
  const DeviceStatus device = running_->device();
  if (device.health != DeviceHealth::streaming && !device.message.empty()) warning(device.message);
  if (ImGui::Button(ui.tr("This one again"))) running_->back();
  ui.note("back");
  ImGui::SameLine();
  if (ImGui::Button(ui.tr("Stop"))) {
    running_.reset();
    said_ = {msg("Stopped: nothing is changed."), false};
  }
  ui.note("stop");
}

/// Takes what came out into the draft. A field's map is a file of its own, which the configuration names.
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
    said_ = take_outcome(draft, outcome);
  } catch (const InputError& error) {
    said_ = {error.what(), true};
  }
  running_.reset();
}

/// Shows what came out in the place of what was asked, so that nobody must look for it.
void CalibratePage::draw_outcome(Interface& ui) {
  if (chosen_->begin == begin_field && field_) draw_field_picture(ui, *field_);
  const std::vector<std::string>& words = outcomes_.at(chosen_->name);
  for (std::size_t k = 0; k < std::min(words.size(), words_at_once); ++k)
    if (words.size() <= words_at_once || k < 2) wrapped(words[k]);
  if (words.size() > words_at_once && ImGui::CollapsingHeader(ui.tr("More")))
    for (std::size_t k = 2; k < words.size(); ++k) wrapped(words[k]);
  if (ImGui::Button(ui.tr("Once more"))) shows_outcome_ = false;
  ui.note("once more");
}

}  // namespace prosector
