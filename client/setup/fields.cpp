#include "client/setup/fields.h"

#include <imgui.h>

#include <array>

namespace prosector {
namespace {

struct RoleChoice {
  StationRole role;
  const char* name;
};
constexpr std::array<RoleChoice, 5> role_choices = {{{StationRole::right_hand, msg("right hand")},
                                                     {StationRole::left_hand, msg("left hand")},
                                                     {StationRole::head, msg("head")},
                                                     {StationRole::instrument, msg("instrument")},
                                                     {StationRole::tablet, msg("tablet")}}};

}  // namespace

bool edit_vector(const char* name, Vec3& v) {
  std::array<double, 3> values = {v.x(), v.y(), v.z()};
  const bool changed =
      ImGui::InputScalarN(name, ImGuiDataType_Double, values.data(), 3, nullptr, nullptr, "%.3f");
  if (changed) v = Vec3(values.data());
  return changed;
}

void edit_role(Interface& ui, StationRole& role) {
  std::size_t at = 0;
  while (role_choices[at].role != role) ++at;
  if (ImGui::BeginCombo(ui.tr("receiver of"), ui.tr(role_choices[at].name))) {
    for (const RoleChoice& choice : role_choices) {
      if (ImGui::Selectable(ui.tr(choice.name), choice.role == role)) role = choice.role;
      ui.note(choice.name);
    }
    ImGui::EndCombo();
  }
  ui.note("role");
}

void edit_hand(Interface& ui, std::size_t& hand) {
  if (ImGui::RadioButton(ui.tr("right glove"), hand == right_hand)) hand = right_hand;
  ui.note("right hand's");
  ImGui::SameLine();
  if (ImGui::RadioButton(ui.tr("left glove"), hand == left_hand)) hand = left_hand;
  ui.note("left hand's");
}

}  // namespace prosector
