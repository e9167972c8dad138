#pragma once
// Passes a headset user's poses from the headset thread to the sending thread.

#include <mutex>
#include <optional>
#include <utility>

#include "client/xr/tracked_user.h"

namespace prosector {

class HeadsetUser {
 public:
  /// Sets the headset user's latest poses. Called on the headset's thread.
  void put(const TrackedUser& user) {
    std::lock_guard lock(mutex_);
    newest_ = user;
  }
  /// Returns the headset user's latest poses; nullopt if there was no update since the last call.
  std::optional<TrackedUser> take() {
    std::lock_guard lock(mutex_);
    return std::exchange(newest_, std::nullopt);
  }

 private:
  std::mutex mutex_;
  std::optional<TrackedUser> newest_;
};

}  // namespace prosector
