#pragma once
// What a draft of the configuration would change in its file, with the buttons that write or forget it.

#include "client/setup/config_draft.h"
#include "client/setup/interface.h"
#include "client/setup/words.h"
#include "drivers/fitting/guide.h"

namespace prosector {

/// Shows the lines that change, "Save" and "Discard". Returns whether the draft was discarded.
bool draw_draft_changes(Interface& ui, ConfigDraft& draft, Said& said);
/// Takes what a calibration changes into the draft. Returns what is to be said of it.
Said take_outcome(ConfigDraft& draft, const GuideOutcome& outcome);

}  // namespace prosector
