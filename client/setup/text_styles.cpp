#include "client/setup/text_styles.h"

#include <imgui.h>

#include <algorithm>

namespace prosector {
namespace {

void coloured(const ImVec4& color, const std::string& words) {
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  wrapped(words);
  ImGui::PopStyleColor();
}

}  // namespace

void title(const std::string& words) {
  coloured({0.62f, 0.82f, 1, 1}, words);
}

void wrapped(const std::string& words) {
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(words.c_str());
  ImGui::PopTextWrapPos();
}

void quiet(const std::string& words) {
  coloured({0.62f, 0.65f, 0.7f, 1}, words);
}

void warning(const std::string& words) {
  coloured({1, 0.62f, 0.4f, 1}, words);
}

void keep_space_for(const std::string& other) {
  const ImVec2 text = ImGui::GetItemRectMin(), next = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x - text.x;
  const float height = ImGui::CalcTextSize(other.c_str(), nullptr, false, width).y;
  const float bottom = text.y + height + ImGui::GetStyle().ItemSpacing.y;
  ImGui::SetCursorScreenPos({next.x, std::max(next.y, bottom)});
}

}  // namespace prosector
