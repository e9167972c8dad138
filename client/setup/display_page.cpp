#include "client/setup/display_page.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <utility>

#include "client/setup/draft_changes.h"
#include "client/setup/side_by_side.h"
#include "client/setup/text_styles.h"

namespace prosector {
namespace {

struct QualityChoice {
  const char* name;
  const char* about;
};
constexpr std::array<QualityChoice, 4> qualities = {
    {{msg("low"), msg("for a machine without a graphics card")},
     {msg("medium"), msg("shadows, translucent tissue, reflections")},
     {msg("high"), msg("smoother edges and visible light beams, for a good graphics card")},
     {"", msg("automatic quality: at most 33 ms per frame")}}};

}  // namespace

PicturesPage::PicturesPage(std::vector<EyeDisplay> displays) : crosses_(displays) {
  for (EyeDisplay& display : displays) profiles_.push_back(std::move(display.name));
}

void PicturesPage::draw(Interface& ui, SetupSession& room, ConfigDraft& draft) {
  draw_side_by_side(
      ui, 0.45, [&] { draw_seen(ui, room.memory.seen); }, [&] { draw_eyes(ui, draft); });
}

void PicturesPage::draw_seen(Interface& ui, DisplaySettings& seen) {
  title(ui.tr("Display"));
  const auto choice = [&](const char* label, const std::string& display) {
    if (ImGui::RadioButton(label, seen.display == display)) seen.display = display;
    ui.note(fmt::format("display {}", display));
  };
  choice(ui.tr("in a window"), "window");
  for (const std::string& profile : profiles_)
    choice(ui.tr("side by side, for two eyes: profile {}", profile).c_str(), "stereo:" + profile);
  choice(ui.tr("in an OpenXR headset, with its own tracking"), "openxr");
  bool fills = seen.monitor >= 0;
  if (ImGui::Checkbox(ui.tr("full screen"), &fills)) seen.monitor = fills ? 0 : -1;
  ui.note("fills");
  if (fills) {
    ImGui::SameLine();
    ImGui::SetNextItemWidth(120 * static_cast<float>(ui.scale()));
    ImGui::InputInt(ui.tr("screen number, from 0"), &seen.monitor);
    ui.note("screen");
    seen.monitor = std::clamp(seen.monitor, 0, 15);
  }
  ImGui::Separator();
  title(ui.tr("Quality"));
  for (const QualityChoice& quality : qualities) {
    if (ImGui::RadioButton(
            fmt::format("{}  ·  {}###{}", *quality.name != 0 ? ui.tr(quality.name) : ui.tr("automatic"),
                        ui.tr(quality.about), quality.name)
                .c_str(),
            seen.quality == quality.name))
      seen.quality = quality.name;
    ui.note(fmt::format("quality {}", *quality.name != 0 ? quality.name : "automatic"));
  }
  ImGui::Separator();
  std::string words;
  for (const std::string& word : seen.words()) words += " " + word;
  quiet(words.empty() ? ui.tr("Default settings.") : ui.tr("On the command line:{}", words));
}

void PicturesPage::draw_eyes(Interface& ui, ConfigDraft& draft) {
  title(ui.tr("Your eyes"));
  const EyeSettings& eyes = draft.config().eyes;
  quiet(eyes.distance ? ui.tr("Eye distance {:.1f} mm, from the configuration.", 1e3 * *eyes.distance)
                      : ui.tr("Eye distance not measured: the value of the display's profile is used."));
  const auto choice = [&](const char* label, const char* name, bool crosses) {
    if (ImGui::RadioButton(label, by_crosses_ == crosses)) {
      by_crosses_ = crosses;
      outcome_.clear();
    }
    ui.note(name);
  };
  choice(ui.tr("measure with a ruler on the screen"), "by ruler", false);
  ImGui::SameLine();
  choice(ui.tr("measure with crosses in a headset"), "by crosses", true);
  ImGui::Separator();
  if (outcome_.empty())
    measure(ui, draft);
  else
    draw_outcome(ui);
  ImGui::Separator();
  draw_draft_changes(ui, draft, said_);
}

void PicturesPage::measure(Interface& ui, ConfigDraft& draft) {
  std::optional<GuideOutcome> outcome;
  if (!by_crosses_)
    outcome = ruler_.draw(ui, said_);
  else if (crosses_.running())
    outcome = crosses_.draw_cross(ui, said_);
  else
    crosses_.draw_settings_form(ui, draft.config(), said_);
  if (!outcome) return;
  outcome_ = outcome->words;
  said_ = apply_outcome(draft, *outcome);
}

/// Draws the result in place of the settings, so that it is visible without scrolling.
void PicturesPage::draw_outcome(Interface& ui) {
  for (const std::string& line : outcome_) wrapped(line);
  if (ImGui::Button(ui.tr("Repeat"))) outcome_.clear();
  ui.note("once more");
}

}  // namespace prosector
