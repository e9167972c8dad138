#include "client/setup/draft_changes.h"

#include <imgui.h>

#include "common/error.h"

namespace prosector {

bool draw_draft_changes(Interface& ui, ConfigDraft& draft, Said& said) {
  if (!draft.changed()) {
    const std::string file = draft.file().string();
    quiet(std::filesystem::exists(draft.file()) ? file : ui.tr("{}: no file yet", file));
    return false;
  }
  title(ui.tr("Changes to write to {}", draft.file().string()));
  for (const ChangedLine& line : draft.changes()) {
    if (!line.before.empty()) quiet("- " + line.before);
    if (!line.after.empty()) wrapped("+ " + line.after);
  }
  if (ImGui::Button(ui.tr("Save"))) {
    try {
      draft.save();
      said = {msg("Saved."), false};
    } catch (const InputError& error) {
      said = {error.what(), true};
    }
  }
  ui.note("save");
  ImGui::SameLine();
  const bool discarded = ImGui::Button(ui.tr("Discard"));
  ui.note("discard");
  if (discarded) draft.revert();
  return discarded;
}

Said apply_outcome(ConfigDraft& draft, const GuideOutcome& outcome) {
  const std::string why = outcome.changes.empty() ? "" : draft.change(outcome.changes);
  return why.empty() ? Said{msg("Done."), false} : Said{why, true};
}

}  // namespace prosector
