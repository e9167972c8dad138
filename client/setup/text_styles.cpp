#include "client/setup/text_styles.h"

#include <imgui.h>

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

}  // namespace prosector
