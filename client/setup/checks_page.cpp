#include "client/setup/checks_page.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <thread>

#include "client/setup/text_styles.h"
#include "common/paths.h"

namespace prosector {
namespace {

constexpr std::array state_words = {msg("unknown"), msg("good"), msg("fair"), msg("bad")};
const std::array<ImVec4, 4> state_colors = {
    {{0.55f, 0.57f, 0.6f, 1}, {0.35f, 0.8f, 0.45f, 1}, {0.95f, 0.72f, 0.25f, 1}, {0.95f, 0.38f, 0.33f, 1}}};

}  // namespace

void ChecksPage::draw(Interface& ui) {
  title(ui.tr("Readiness of this machine for sessions"));
  if (checks_.empty())
    checks_ = {measure_pictures_(),
               check_cores(std::thread::hardware_concurrency(), ui.words()),
               check_network_buffers(network_buffer_limit, ui.words()),
               check_real_time(ui.words()),
               check_clock(ui.words()),
               check_anatomy(default_data_dir(), ui.words()),
               {msg("Latency from hand to display"), CheckState::unknown,
                ui.tr("The latency from hand to display can only be measured with a second device that "
                      "observes the screen. The latency step on the tracker page compares two devices.")}};
  const float scale = static_cast<float>(ui.scale());
  float words_at = 310 * scale;
  for (const char* state : state_words)
    words_at = std::max(words_at,
                        230 * scale + ImGui::CalcTextSize(ui.tr(state)).x + ImGui::GetStyle().ItemSpacing.x);
  for (const MachineCheck& check : checks_) {
    ImGui::Separator();
    const auto state = static_cast<std::size_t>(check.state);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float line = ImGui::GetTextLineHeight();
    ImGui::GetWindowDrawList()->AddCircleFilled({at.x + 0.5f * line, at.y + 0.5f * line}, 0.36f * line,
                                                ImGui::GetColorU32(state_colors[state]));
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 1.5f * line);
    ImGui::TextUnformatted(ui.tr(check.name.c_str()));
    ui.note("check " + check.name);
    ImGui::SameLine(230 * scale);
    ImGui::TextColored(state_colors[state], "%s", ui.tr(state_words[state]));
    ImGui::SameLine(words_at);
    wrapped(check.words);
  }
  ImGui::Separator();
  if (ImGui::Button(ui.tr("Check again"))) checks_.clear();
  ui.note("look again");
}

}  // namespace prosector
