#pragma once
// Opens what takes its time, as a device behind a vendor's library. That is done on a thread of its own, so
// that who polls never waits, and again twice a second until it works.

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
class Opening {
 public:
  static constexpr std::int64_t retry_ns = 500'000'000;

  /// Takes what opens it; that throws InputError with the reason where it can't. `how`: deferred opens in
  /// poll(), as tests in their own time want it.
  Opening(std::function<std::unique_ptr<T>()> make, std::launch how) : make_(std::move(make)), how_(how) {}

  /// Returns what is open, and when that was; nullptr: nothing is, problem() says why.
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
  /// Gives up what is open, for that reason. It is closed where it will be opened anew.
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
  std::future<std::unique_ptr<T>> attempt_;  // last: its end waits for what runs
};

}  // namespace prosector
