#pragma once
// The page that rates this machine's suitability for sessions in green, amber and red.

#include <functional>
#include <vector>

#include "client/setup/interface.h"
#include "client/setup/machine_checks.h"

namespace prosector {

class ChecksPage {
 public:
  /// Stores `measure_pictures`, which measures and rates this machine's frame time when the page is first
  /// shown. It takes a moment.
  explicit ChecksPage(std::function<MachineCheck()> measure_pictures)
      : measure_pictures_(std::move(measure_pictures)) {}

  void draw(Interface& ui);

 private:
  std::function<MachineCheck()> measure_pictures_;
  std::vector<MachineCheck> checks_;
};

}  // namespace prosector
