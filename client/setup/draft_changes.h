#pragma once
// The unsaved changes of a configuration draft, with buttons to save or discard them.

#include "client/setup/config_draft.h"
#include "client/setup/interface.h"
#include "client/setup/text_styles.h"
#include "drivers/fitting/guide.h"

namespace prosector {

/// Draws the changed lines, "Save" and "Discard". Returns whether the draft was discarded.
bool draw_draft_changes(Interface& ui, ConfigDraft& draft, Said& said);
/// Applies the result of a calibration to the draft. Returns the message to show.
Said apply_outcome(ConfigDraft& draft, const GuideOutcome& outcome);

}  // namespace prosector
