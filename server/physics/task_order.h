#pragma once
// Tells the thread sanitizer in which order tasks run. Debian's TBB isn't built with it, so that what TBB's
// own atomics order (a loop's beginning before its tasks, these before its end) would look like races. In
// other builds nothing of this is left.

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace prosector {

/// Stands for one parallel section: made before its tasks, joined after them by the same thread.
class TaskOrder {
 public:
#ifdef __SANITIZE_THREAD__
  TaskOrder() {
    __tsan_release(&begun_);
  }
  void join() {
    __tsan_acquire(&ended_);
  }
  /// Runs one task of the section.
  template <class F>
  void run(const F& task) {
    __tsan_acquire(&begun_);
    task();
    __tsan_release(&ended_);
  }

 private:
  char begun_ = 0, ended_ = 0;
#else
  void join() {}
  template <class F>
  void run(const F& task) {
    task();
  }
#endif
};

}  // namespace prosector
