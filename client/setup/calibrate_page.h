#pragma once
// A page of calibrations: what a device tells now, what to calibrate, step by step, and what came out.

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "client/setup/config_draft.h"
#include "client/setup/field_picture.h"
#include "client/setup/interface.h"
#include "client/setup/live_panel.h"
#include "client/setup/procedures.h"
#include "client/setup/words.h"

namespace prosector {

class CalibratePage {
 public:
  CalibratePage(const char* heading, std::unique_ptr<LivePanel> live, std::span<const ProcedureRow> rows)
      : heading_(heading), live_(std::move(live)), rows_(rows) {}

  void draw(Interface& ui, ConfigDraft& draft, std::int64_t now_ns);
  /// Lets devices go.
  void close();
  bool running() const { return running_ != nullptr || live_->open(); }
  const Said& said() const { return said_; }

 private:
  /// A text of the configuration, as it is typed.
  struct TypedKey {
    const char* key;
    const char* name;
    std::string text;
  };

  const char* heading_;
  std::unique_ptr<LivePanel> live_;
  std::span<const ProcedureRow> rows_;
  CalibrationWishes wishes_ = {
      .points = {{0, 0.9, 0}, {0.4, 0.9, 0}, {0, 0.9, 0.4}, {0.4, 0.9, 0.4}},
      .landmarks = {{-0.1, 0, 0.1}, {0.1, 0, 0.1}, {0.1, 0, -0.1}, {-0.1, 0, -0.1}, {0, 0.15, 0}},
      .grid = {.low = {-0.4, 0.9, -0.4}, .high = {0.4, 1.5, 0.4}, .orientation = {}},
      .against = {}};
  bool knows_role_ = false;               // whose receiver touches, from the draft or the person
  const ProcedureRow* chosen_ = nullptr;  // none: what is live
  std::unique_ptr<GuidedCalibration> running_;
  std::map<std::string, std::vector<std::string>> outcomes_;  // of each calibration, the last one
  bool shows_outcome_ = false;
  std::vector<TypedKey> shape_;  // of the phantom; none: to be read
  std::optional<FieldPicture> field_;
  Said said_;

  void choose(const ProcedureRow* row);
  void draw_choice(Interface& ui);
  void draw_chosen(Interface& ui, ConfigDraft& draft, std::int64_t now_ns);
  void draw_wishes(Interface& ui, ConfigDraft& draft);
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
