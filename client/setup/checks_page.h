#pragma once
// The page that rates this machine's suitability for sessions in green, amber and red.

#include <functional>
#include <vector>

#include "client/setup/interface.h"
#include "client/setup/machine_checks.h"

namespace prosector {

class ChecksPage {
 public:
  /// Takes the function that measures frame times; it takes a moment.
  explicit ChecksPage(std::function<MachineCheck()> measure_pictures)
      : measure_pictures_(std::move(measure_pictures)) {}

  void draw(Interface& ui);

 private:
  std::function<MachineCheck()> measure_pictures_;
  std::vector<MachineCheck> checks_;
};

}  // namespace prosector
