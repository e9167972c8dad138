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
  /// Draws the panel with the device's live data, and opens the device if it is not open yet. Changes that
  /// the user makes go into `draft`, messages into `said`. `now_ns`: monotonic time.
  virtual void draw(Interface& ui, ConfigDraft& draft, Said& said, std::int64_t now_ns) = 0;
  /// Closes the panel's device, so that another program can use it.
  virtual void close() = 0;
  virtual bool open() const = 0;
};

}  // namespace prosector
