#pragma once
// A page of calibrations: a device's live data, a choice of calibrations, their steps and results.

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "client/setup/config_draft.h"
#include "client/setup/field_plot.h"
#include "client/setup/interface.h"
#include "client/setup/live_panel.h"
#include "client/setup/procedures.h"
#include "client/setup/text_styles.h"

namespace prosector {

class CalibratePage {
 public:
  CalibratePage(const char* heading, std::unique_ptr<LivePanel> live, std::span<const ProcedureRow> rows)
      : heading_(heading), live_(std::move(live)), rows_(rows) {}

  void draw(Interface& ui, ConfigDraft& draft, std::int64_t now_ns);
  /// Closes the devices that the page has opened, and stops a running calibration without a result.
  void close();
  bool running() const { return running_ != nullptr || live_->open(); }
  const Said& said() const { return said_; }

 private:
  /// Text field for a text of the client's configuration: its key, its label, and the text as edited.
  struct TypedKey {
    const char* key;
    const char* name;
    std::string text;
  };

  const char* heading_;
  std::unique_ptr<LivePanel> live_;
  std::span<const ProcedureRow> rows_;
  CalibrationSettings calibration_settings_ = {
      .points = {{0, 0.9, 0}, {0.4, 0.9, 0}, {0, 0.9, 0.4}, {0.4, 0.9, 0.4}},
      .landmarks = {{-0.1, 0, 0.1}, {0.1, 0, 0.1}, {0.1, 0, -0.1}, {-0.1, 0, -0.1}, {0, 0.15, 0}},
      .grid = {.low = {-0.4, 0.9, -0.4}, .high = {0.4, 1.5, 0.4}, .orientation = {}},
      .against = {}};
  bool knows_role_ = false;               // the role to calibrate is set, from the draft or by the user
  const ProcedureRow* chosen_ = nullptr;  // null: the live panel
  std::unique_ptr<GuidedCalibration> running_;
  std::map<std::string, std::vector<std::string>> outcomes_;  // last result of each calibration
  bool shows_outcome_ = false;
  std::vector<TypedKey> shape_;  // shape of the phantom as edited; empty: to be read from the draft
  std::optional<FieldPicture> field_;
  Said said_;

  void choose(const ProcedureRow* row);
  void draw_choice(Interface& ui);
  void draw_chosen(Interface& ui, ConfigDraft& draft, std::int64_t now_ns);
  void draw_settings_form(Interface& ui, ConfigDraft& draft);
  static void draw_points(Interface& ui, std::vector<Vec3>& points);
  void draw_shape(Interface& ui, const ConfigDraft& draft);
  static std::vector<TypedKey> shape_of(const ConfigDraft& draft);
  void draw_grid(Interface& ui);
  void draw_running(Interface& ui, ConfigDraft& draft);
  void draw_outcome(Interface& ui);
  void begin(ConfigDraft& draft);
  void finish(ConfigDraft& draft);
};

}  // namespace prosector
