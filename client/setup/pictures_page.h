#pragma once
// The page of how a session is seen: window, whole screen, two eyes; how well it is drawn; and where the eyes
// are.

#include <optional>
#include <string>
#include <vector>

#include "client/setup/anteroom.h"
#include "client/setup/config_draft.h"
#include "client/setup/eye_crosses.h"
#include "client/setup/eye_ruler.h"
#include "client/setup/interface.h"

namespace prosector {

class PicturesPage {
 public:
  /// Takes side-by-side displays.
  explicit PicturesPage(std::vector<EyeDisplay> displays);

  void draw(Interface& ui, Anteroom& room, ConfigDraft& draft);
  /// Lets devices go.
  void close() { crosses_.close(); }
  bool running() const { return crosses_.running(); }
  const Said& said() const { return said_; }

 private:
  std::vector<std::string> profiles_;
  bool by_crosses_ = false;
  EyeRuler ruler_;
  EyeCrosses crosses_;
  std::vector<std::string> outcome_;  // of the last one
  Said said_;

  void draw_seen(Interface& ui, SeenAs& seen);
  void draw_eyes(Interface& ui, ConfigDraft& draft);
  void measure(Interface& ui, ConfigDraft& draft);
  void draw_outcome(Interface& ui);
};

}  // namespace prosector
