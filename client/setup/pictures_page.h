#pragma once
// The page of how a session is seen: window, whole screen, two eyes; and how well it is drawn.

#include <string>
#include <vector>

#include "client/setup/anteroom.h"
#include "client/setup/interface.h"

namespace prosector {

class PicturesPage {
 public:
  /// Takes the names of side-by-side displays.
  explicit PicturesPage(std::vector<std::string> profiles) : profiles_(std::move(profiles)) {}

  void draw(Interface& ui, Anteroom& room);

 private:
  std::vector<std::string> profiles_;
};

}  // namespace prosector
