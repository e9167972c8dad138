#include "client/setup/side_by_side.h"

#include <imgui.h>

#include <cmath>

namespace prosector {
namespace {

constexpr double least_width = 1000;  // pixels at scale 1, of both together

}  // namespace

void draw_side_by_side(Interface& ui, double share, const std::function<void()>& left,
                       const std::function<void()>& right) {
  const float width = ImGui::GetContentRegionAvail().x, gap = ImGui::GetStyle().ItemSpacing.x;
  if (width < least_width * ui.scale()) {
    left();
    ImGui::Separator();
    right();
    return;
  }
  ImGui::BeginChild("left", {std::floor(static_cast<float>(share) * width), 0}, true);
  left();
  ImGui::EndChild();
  ImGui::SameLine(0, gap);
  ImGui::BeginChild("right", {0, 0}, true);
  right();
  ImGui::EndChild();
}

}  // namespace prosector
