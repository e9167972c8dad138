#include "client/setup/pages.h"

#include <imgui.h>

#include "client/setup/words.h"

namespace prosector {

void Pages::draw(Interface& ui) {
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
  ImGui::Begin("anteroom", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
  const float line = ImGui::GetTextLineHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
  ImGui::BeginChild("page", {0, -line});
  enter_.draw(ui, room_);
  ImGui::EndChild();
  if (room_.wrong())
    warning(room_.words());
  else
    quiet(room_.words());
  ui.note(room_.wrong() ? "wrong" : "said");
  ImGui::End();
}

}  // namespace prosector
