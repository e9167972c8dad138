#include "client/setup/pictures_page.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <utility>

#include "client/setup/beside.h"
#include "client/setup/draft_changes.h"
#include "client/setup/words.h"

namespace prosector {
namespace {

struct QualityChoice {
  const char* name;
  const char* about;
};
constexpr std::array<QualityChoice, 4> qualities = {
    {{msg("low"), msg("for a machine without a graphics card")},
     {msg("medium"), msg("shadows, translucent tissue, reflections")},
     {msg("high"), msg("smoother edges and light in air, for a good card")},
     {"", msg("by itself: so that a picture takes 33 ms at most")}}};

}  // namespace

PicturesPage::PicturesPage(std::vector<EyeDisplay> displays) : crosses_(displays) {
  for (EyeDisplay& display : displays) profiles_.push_back(std::move(display.name));
}

void PicturesPage::draw(Interface& ui, Anteroom& room, ConfigDraft& draft) {
  draw_beside(
      ui, 0.45, [&] { draw_seen(ui, room.memory.seen); }, [&] { draw_eyes(ui, draft); });
}

void PicturesPage::draw_seen(Interface& ui, SeenAs& seen) {
  title(ui.tr("How you see a session"));
  const auto choice = [&](const char* label, const std::string& display) {
    if (ImGui::RadioButton(label, seen.display == display)) seen.display = display;
    ui.note(fmt::format("display {}", display));
  };
  choice(ui.tr("in a window"), "window");
  for (const std::string& profile : profiles_)
    choice(ui.tr("side by side, for two eyes: {}", profile).c_str(), "stereo:" + profile);
  choice(ui.tr("in a headset by OpenXR, with its own tracking"), "openxr");
  bool fills = seen.monitor >= 0;
  if (ImGui::Checkbox(ui.tr("filling the screen"), &fills)) seen.monitor = fills ? 0 : -1;
  ui.note("fills");
  if (fills) {
    ImGui::SameLine();
    ImGui::SetNextItemWidth(120 * static_cast<float>(ui.scale()));
    ImGui::InputInt(ui.tr("screen, from 0"), &seen.monitor);
    ui.note("screen");
    seen.monitor = std::clamp(seen.monitor, 0, 15);
  }
  ImGui::Separator();
  title(ui.tr("How it is drawn"));
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
  quiet(words.empty() ? ui.tr("As the client does by itself.") : ui.tr("In a command line:{}", words));
}

void PicturesPage::draw_eyes(Interface& ui, ConfigDraft& draft) {
  title(ui.tr("Your eyes"));
  const EyeSettings& eyes = draft.config().eyes;
  quiet(eyes.distance ? ui.tr("They are {:.1f} mm apart, by the configuration.", 1e3 * *eyes.distance)
                      : ui.tr("How far they are apart isn't known: the display's profile says it."));
  const auto choice = [&](const char* label, const char* name, bool crosses) {
    if (ImGui::RadioButton(label, by_crosses_ == crosses)) {
      by_crosses_ = crosses;
      outcome_.clear();
    }
    ui.note(name);
  };
  choice(ui.tr("by a ruler on the screen"), "by ruler", false);
  ImGui::SameLine();
  choice(ui.tr("by crosses in a worn display"), "by crosses", true);
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
    crosses_.draw_wishes(ui, draft.config(), said_);
  if (!outcome) return;
  outcome_ = outcome->words;
  said_ = take_outcome(draft, *outcome);
}

/// Shows what came out in the place of what was asked, so that nobody must look for it.
void PicturesPage::draw_outcome(Interface& ui) {
  for (const std::string& line : outcome_) wrapped(line);
  if (ImGui::Button(ui.tr("Once more"))) outcome_.clear();
  ui.note("once more");
}

}  // namespace prosector
