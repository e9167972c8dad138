#pragma once
// Which keys are down: at a few pictures a second, a tap begins and ends between two of them.

#include <set>

#include "client/render/window_context.h"

namespace prosector {

class HeldKeys {
 public:
  void take(const KeyEvent& key) {
    if (key.down) {
      held_.insert(key.key);
      tapped_.insert(key.key);
    } else {
      held_.erase(key.key);
    }
  }
  bool is_held(Key key) const { return held_.contains(key); }
  /// Tells whether the key was down at any time since the last forget_taps().
  bool was_down(Key key) const { return is_held(key) || tapped_.contains(key); }
  void forget_taps() { tapped_.clear(); }

 private:
  std::set<Key> held_, tapped_;
};

}  // namespace prosector
