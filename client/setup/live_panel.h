#pragma once
// A panel with a device's live data, next to guided steps.

#include <cstdint>

#include "client/setup/config_draft.h"
#include "client/setup/interface.h"
#include "client/setup/text_styles.h"

namespace prosector {

class LivePanel {
 public:
  virtual ~LivePanel() = default;
  virtual const char* name() const = 0;
  virtual const char* about() const = 0;
  /// Draws the panel; opens its device if needed.
  virtual void draw(Interface& ui, ConfigDraft& draft, Said& said, std::int64_t now_ns) = 0;
  /// Closes the device.
  virtual void close() = 0;
  virtual bool open() const = 0;
};

}  // namespace prosector
