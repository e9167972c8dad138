#pragma once
// What a page shows of a device while it goes on, beside guided steps.

#include <cstdint>

#include "client/setup/config_draft.h"
#include "client/setup/interface.h"
#include "client/setup/words.h"

namespace prosector {

class LivePanel {
 public:
  virtual ~LivePanel() = default;
  virtual const char* name() const = 0;
  virtual const char* about() const = 0;
  /// Shows it; opens its device when it isn't yet.
  virtual void draw(Interface& ui, ConfigDraft& draft, Said& said, std::int64_t now_ns) = 0;
  /// Lets the device go.
  virtual void close() = 0;
  virtual bool open() const = 0;
};

}  // namespace prosector
