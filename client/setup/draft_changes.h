#pragma once
// The unsaved changes of a configuration draft, with buttons to save or discard them.

#include "client/setup/config_draft.h"
#include "client/setup/interface.h"
#include "client/setup/text_styles.h"
#include "drivers/fitting/guide.h"

namespace prosector {

/// Draws the lines that the unsaved changes of the configuration affect, with the buttons "Save" and
/// "Discard". `said` receives the message on saving. Returns whether the user discarded the changes.
bool draw_draft_changes(Interface& ui, ConfigDraft& draft, Said& said);
/// Applies the changes of the configuration that result from a calibration to the draft. Returns the page's
/// message: success, or the reason why they are invalid.
Said apply_outcome(ConfigDraft& draft, const GuideOutcome& outcome);

}  // namespace prosector
