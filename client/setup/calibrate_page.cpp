#include "client/setup/calibrate_page.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <cmath>

#include "client/setup/draft_changes.h"
#include "client/setup/fields.h"
#include "common/error.h"

namespace prosector {
namespace {

/// What a person says before one begins.
enum class Asked : std::uint8_t { points, role, grid, hand, seconds };

struct ProcedureRow {
  const char* name;
  const char* about;
  std::unique_ptr<GuidedCalibration> (*begin)(const ClientConfig&, const CalibrationWishes&);
  std::vector<Asked> asked;
};

const std::vector<ProcedureRow>& procedures() {
  static const std::vector<ProcedureRow> rows = {
      {"Tracker in the room",
       "Touch points whose place in the room is known: the tracker's own place follows.",
       begin_room,
       {Asked::role, Asked::points}},
      {"Instrument's tip",
       "Rest the tip in a dent and swing the instrument about it: where the tip is follows.",
       begin_tip,
       {Asked::role}},
      {"Bent field",
       "Hold the receiver at the points of a grid: what metal bends is mapped and taken out.",
       begin_field,
       {Asked::role, Asked::grid}},
      {"Glove",
       "Hold the hand flat, as a fist, and with each finger bent: what counts mean follows.",
       begin_glove,
       {Asked::hand}},
      {"Noise",
       "Let a receiver rest: how much it trembles and drifts is told.",
       begin_noise,
       {Asked::role, Asked::seconds}}};
  return rows;
}

}  // namespace

void CalibratePage::draw(Interface& ui, ConfigDraft& draft) {
  const float width = ImGui::GetContentRegionAvail().x, gap = ImGui::GetStyle().ItemSpacing.x;
  ImGui::BeginChild("procedures", {std::floor(0.26f * width), 0}, true);
  draw_choice(ui);
  ImGui::EndChild();
  ImGui::SameLine(0, gap);
  ImGui::BeginChild("procedure", {0, 0}, true);
  title(procedures()[chosen_].name);
  wrapped(procedures()[chosen_].about);
  ImGui::Separator();
  if (running_)
    draw_running(ui, draft);
  else
    draw_wishes(ui, draft);
  ImGui::Separator();
  for (const std::string& line : outcome_) wrapped(line);
  draw_draft_changes(ui, draft, said_);
  ImGui::EndChild();
}

void CalibratePage::draw_choice(Interface& ui) {
  title("Calibrate");
  for (std::size_t k = 0; k < procedures().size(); ++k) {
    if (ImGui::Selectable(procedures()[k].name, k == chosen_) && k != chosen_) {
      chosen_ = k;
      running_.reset();
      outcome_.clear();
      said_ = {};
    }
    ui.note(procedures()[k].name);
  }
}

void CalibratePage::draw_wishes(Interface& ui, ConfigDraft& draft) {
  const float field = 330 * static_cast<float>(ui.scale());
  ImGui::PushItemWidth(field);
  for (const Asked asked : procedures()[chosen_].asked) switch (asked) {
      case Asked::role:
        edit_role(ui, wishes_.role);
        break;
      case Asked::hand:
        if (ImGui::RadioButton("right glove", wishes_.hand == right_hand)) wishes_.hand = right_hand;
        ImGui::SameLine();
        if (ImGui::RadioButton("left glove", wishes_.hand == left_hand)) wishes_.hand = left_hand;
        break;
      case Asked::points:
        quiet("Points to touch, in this order: x to the right, y up, z towards you, m.");
        for (std::size_t k = 0; k < wishes_.points.size(); ++k)
          edit_vector(fmt::format("point {}", k + 1).c_str(), wishes_.points[k]);
        if (ImGui::Button("One more")) wishes_.points.push_back(wishes_.points.back());
        ImGui::SameLine();
        if (ImGui::Button("One less") && wishes_.points.size() > 3) wishes_.points.pop_back();
        break;
      case Asked::grid: {
        edit_vector("lower corner", wishes_.grid.low);
        edit_vector("upper corner", wishes_.grid.high);
        std::array<int, 3> count{};
        for (std::size_t a = 0; a < 3; ++a) count[a] = static_cast<int>(wishes_.grid.count[a]);
        if (ImGui::InputInt3("points along x, y, z", count.data()))
          for (std::size_t a = 0; a < 3; ++a)
            wishes_.grid.count[a] = static_cast<std::size_t>(std::clamp(count[a], 3, 20));
        break;
      }
      case Asked::seconds:
        ImGui::InputDouble("seconds", &wishes_.seconds, 0, 0, "%.0f");
        wishes_.seconds = std::clamp(wishes_.seconds, 2., 600.);
        break;
    }
  ImGui::PopItemWidth();
  if (ImGui::Button("Begin")) begin(draft);
  ui.note("begin");
}

void CalibratePage::begin(const ConfigDraft& draft) {
  outcome_.clear();
  said_ = {};
  try {
    running_ = procedures()[chosen_].begin(draft.config(), wishes_);
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
  said_ = {fmt::format("Step {} of {}", step.index + 1, step.count), false};
  ImGui::SetWindowFontScale(1.35f);
  wrapped(step.instruction);
  ImGui::SetWindowFontScale(1);
  ImGui::ProgressBar(static_cast<float>(step.progress), {-1, 0}, "");
  ImGui::ProgressBar(static_cast<float>(step.index) / static_cast<float>(step.count),
                     {-1, 6 * static_cast<float>(ui.scale())}, "");
  if (!step.trouble.empty()) warning(step.trouble);
  const DeviceStatus device = running_->device();
  if (device.health != DeviceHealth::streaming && !device.message.empty()) warning(device.message);
  if (ImGui::Button("This one again")) running_->back();
  ui.note("back");
  ImGui::SameLine();
  if (ImGui::Button("Stop")) {
    running_.reset();
    said_ = {"Stopped: nothing is changed.", false};
  }
  ui.note("stop");
}

/// Takes what came out into the draft. A field's map is a file of its own, which the configuration names.
void CalibratePage::finish(ConfigDraft& draft) {
  try {
    const GuideOutcome outcome = running_->guide().outcome();
    if (const auto* field = dynamic_cast<const FieldGuide*>(&running_->guide())) {
      std::filesystem::create_directories(draft.file().parent_path());
      save_config_text(draft.file().parent_path() / field_map_file, write_field_map(field->fit().map));
    }
    outcome_ = outcome.words;
    said_ = take_outcome(draft, outcome);
  } catch (const InputError& error) {
    said_ = {error.what(), true};
  }
  running_.reset();
}

}  // namespace prosector
