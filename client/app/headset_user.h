#pragma once
// A headset's user on the way from the headset's thread to the one that sends.

#include <mutex>
#include <optional>
#include <utility>

#include "client/xr/tracked_user.h"

namespace prosector {

class HeadsetUser {
 public:
  /// Sets where the user is now.
  void put(const TrackedUser& user) {
    std::lock_guard lock(mutex_);
    newest_ = user;
  }
  /// Returns where the user is; nullopt: nothing new since the last call.
  std::optional<TrackedUser> take() {
    std::lock_guard lock(mutex_);
    return std::exchange(newest_, std::nullopt);
  }

 private:
  std::mutex mutex_;
  std::optional<TrackedUser> newest_;
};

}  // namespace prosector
