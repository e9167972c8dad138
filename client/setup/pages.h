#pragma once
// The set-up window's pages, and what is said below them.

#include "client/setup/anteroom.h"
#include "client/setup/devices_page.h"
#include "client/setup/enter_page.h"
#include "client/setup/interface.h"

namespace prosector {

class Pages {
 public:
  Pages(Anteroom& room, ConfigDraft& draft) : room_(room), draft_(draft) {}

  void draw(Interface& ui);
  /// Tells whether something is shown that goes on by itself.
  bool lively() const { return devices_.open(); }

 private:
  Anteroom& room_;
  ConfigDraft& draft_;
  EnterPage enter_;
  DevicesPage devices_;
};

}  // namespace prosector
