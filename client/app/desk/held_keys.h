#pragma once
// Set of pressed keys. It also remembers taps, which at low frame rates begin and end between two frames.

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
  /// Returns whether the key was down at any time since the last forget_taps(), also if only between two
  /// frames.
  bool was_down(Key key) const { return is_held(key) || tapped_.contains(key); }
  void forget_taps() { tapped_.clear(); }

 private:
  std::set<Key> held_, tapped_;
};

}  // namespace prosector
