#pragma once
// The set-up window's pages, and what is said below them.

#include "client/setup/anteroom.h"
#include "client/setup/enter_page.h"
#include "client/setup/interface.h"

namespace prosector {

class Pages {
 public:
  explicit Pages(Anteroom& room) : room_(room) {}

  void draw(Interface& ui);

 private:
  Anteroom& room_;
  EnterPage enter_;
};

}  // namespace prosector
