#include "client/setup/pictures_page.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "client/setup/words.h"

namespace prosector {
namespace {

struct QualityChoice {
  const char* name;
  const char* about;
};
constexpr std::array<QualityChoice, 4> qualities = {
    {{"low", "for a machine without a graphics card"},
     {"medium", "shadows, translucent tissue, reflections"},
     {"high", "smoother edges and light in air, for a good card"},
     {"", "by itself: so that a picture takes 33 ms at most"}}};

}  // namespace

void PicturesPage::draw(Interface& ui, Anteroom& room) {
  SeenAs& seen = room.memory.seen;
  title("How you see a session");
  const auto choice = [&](const char* label, const std::string& display) {
    if (ImGui::RadioButton(label, seen.display == display)) seen.display = display;
    ui.note(fmt::format("display {}", display));
  };
  choice("in a window", "window");
  for (const std::string& profile : profiles_)
    choice(fmt::format("side by side, for two eyes: {}", profile).c_str(), "stereo:" + profile);
  choice("in a headset by OpenXR, with its own tracking", "openxr");
  bool fills = seen.monitor >= 0;
  if (ImGui::Checkbox("filling the screen", &fills)) seen.monitor = fills ? 0 : -1;
  ui.note("fills");
  if (fills) {
    ImGui::SameLine();
    ImGui::SetNextItemWidth(120 * static_cast<float>(ui.scale()));
    ImGui::InputInt("screen, counted from 0", &seen.monitor);
    seen.monitor = std::clamp(seen.monitor, 0, 15);
  }
  quiet("How far your eyes are apart, and what of a display you see: the page of calibrations.");
  ImGui::Separator();
  title("How it is drawn");
  for (const QualityChoice& quality : qualities) {
    if (ImGui::RadioButton(fmt::format("{}  ·  {}###{}", *quality.name != 0 ? quality.name : "automatic",
                                       quality.about, quality.name)
                               .c_str(),
                           seen.quality == quality.name))
      seen.quality = quality.name;
    ui.note(fmt::format("quality {}", *quality.name != 0 ? quality.name : "automatic"));
  }
  ImGui::Separator();
  std::string words;
  for (const std::string& word : seen.words()) words += " " + word;
  quiet(words.empty() ? "As the client does by itself." : "In a command line:" + words);
}

}  // namespace prosector
