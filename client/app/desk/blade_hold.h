#pragma once
// Whether a desk user's hand holds a blade.

#include <algorithm>

#include "client/app/desk/cut_drawing.h"

namespace prosector {

/// Whether the closed hand holds a blade, which stays there when the button is released. The server reports
/// what a hand holds only some time after it has closed.
class BladeHold {
 public:
  /// Notes whether the button was pressed on a blade.
  void expect(bool at_blade) { expected_ = at_blade; }
  /// Advances by a frame of `seconds`. `closed`: the hand is closed; `reported`: the server reports a blade
  /// in the hand.
  void advance(bool closed, bool reported, double seconds) {
    seconds_closed_ = closed ? seconds_closed_ + seconds : 0;
    seconds_unreported_ = reported ? 0 : seconds_unreported_ + std::min(seconds, longest_step);
    holds_ = closed && (reported || (holds_ && seconds_unreported_ < report_delay));
    if (holds_) opens_ = false;
  }
  /// Handles the release of the button before the server has reported the held body: the hand opens if the
  /// server does not report a blade in time.
  void open_without_blade() { opens_ = true; }
  /// Ends the hold.
  void release() { opens_ = holds_ = false; }

  bool holds() const { return holds_; }
  /// Returns whether the server may still report the blade on which the button was pressed.
  bool is_undecided() const { return expected_ && !holds_ && seconds_closed_ < report_delay; }
  /// Returns whether the hand must open, as it holds no blade and the button is not pressed.
  bool should_open(bool closed, bool pressed) const {
    const bool is_lost = closed && !pressed && !holds_ && !opens_;
    return is_lost || (opens_ && seconds_closed_ >= report_delay);
  }

 private:
  static constexpr double report_delay = 0.6;  // s, until the server has reported what a hand holds

  bool expected_ = false;  // the button was pressed on a blade
  bool opens_ = false;     // the button was released before the server reported the held body
  bool holds_ = false;
  double seconds_closed_ = 0;      // since the hand closed
  double seconds_unreported_ = 0;  // since a blade was last reported in the hand
};

}  // namespace prosector
