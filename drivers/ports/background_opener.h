#pragma once
// Opens a slow resource, such as a device behind a vendor library, on a separate thread, so that the poller
// never waits. Retries twice a second until it succeeds.

#include <chrono>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <string>
#include <utility>

#include "common/error.h"

namespace prosector {

template <class T>
class BackgroundOpener {
 public:
  static constexpr std::int64_t retry_ns = 500'000'000;

  /// Takes the function that opens the resource; it throws InputError with the reason on failure. `how` says
  /// how poll() runs it: `async` in another thread, `deferred` synchronously, for tests with simulated time.
  BackgroundOpener(std::function<std::unique_ptr<T>()> make, std::launch how)
      : make_(std::move(make)), how_(how) {}

  /// Returns the open resource, or starts an attempt to open it if one is due. Returns nullptr while nothing
  /// is open; problem() gives the reason if the last attempt failed.
  T* poll(std::int64_t now_ns) {
    if (open_) return open_.get();
    if (!attempt_.valid()) {
      if (now_ns < next_ns_) return nullptr;
      attempt_ = std::async(how_, [this, old = std::exchange(old_, nullptr)]() mutable {
        old.reset();
        return make_();
      });
    }
    if (attempt_.wait_for(std::chrono::seconds(0)) == std::future_status::timeout) return nullptr;
    try {
      open_ = attempt_.get();
      opened_ns_ = now_ns;
      problem_.clear();
    } catch (const InputError& error) {
      problem_ = error.what();
      next_ns_ = now_ns + retry_ns;
    }
    return open_.get();
  }
  /// Gives up the open resource; `why` is the reason that problem() then returns. The next attempt to open,
  /// half a second later, closes the old resource first.
  void lose(std::string why, std::int64_t now_ns) {
    old_ = std::move(open_);
    problem_ = std::move(why);
    next_ns_ = now_ns + retry_ns;
  }
  bool is_trying() const { return attempt_.valid(); }
  T* get() const { return open_.get(); }
  std::int64_t opened_ns() const { return opened_ns_; }
  const std::string& problem() const { return problem_; }

 private:
  std::function<std::unique_ptr<T>()> make_;
  std::launch how_;
  std::unique_ptr<T> open_, old_;
  std::int64_t next_ns_ = 0, opened_ns_ = 0;
  std::string problem_;
  std::future<std::unique_ptr<T>> attempt_;  // last member: its destructor waits for a running attempt
};

}  // namespace prosector
