#include "client/setup/address_field.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "client/setup/text_styles.h"

namespace prosector {

bool edit_address(Interface& ui, AddressField& field, std::span<const FoundDevice> found,
                  const char* nothing) {
  ImGui::PushID(field.key);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(ui.tr(field.name));
  const float name_end =
      ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + ImGui::GetStyle().ItemInnerSpacing.x;
  ImGui::SameLine(std::max(110 * static_cast<float>(ui.scale()), name_end));
  const float button = ImGui::GetFrameHeight();
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button - ImGui::GetStyle().ItemSpacing.x);
  const bool entered = ImGui::InputText("##address", &field.text, ImGuiInputTextFlags_EnterReturnsTrue);
  ui.note(field.key);
  const bool left = ImGui::IsItemDeactivatedAfterEdit();
  ImGui::SameLine();
  bool picked = false;
  if (ImGui::BeginCombo("##found", "", ImGuiComboFlags_NoPreview)) {
    if (!field.text.empty() && ImGui::Selectable(ui.tr("no device until one is chosen"))) {
      field.text.clear();
      picked = true;
    }
    ui.note(fmt::format("none {}", field.key));
    for (const FoundDevice& device : found)
      for (const std::string& address : device.addresses)
        if (ImGui::Selectable(fmt::format("{}   ({})", address, device.name).c_str())) {
          field.text = address;
          picked = true;
        }
    if (found.empty()) quiet(nothing);
    ImGui::EndCombo();
  }
  ui.note(fmt::format("found {}", field.key));
  ImGui::PopID();
  return entered || left || picked;
}

}  // namespace prosector
