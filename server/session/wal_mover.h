#pragma once
// Moves a journal's write-ahead log into its file now and then. That waits for the disk, so a thread and a
// connection of their own do it: ticks are written meanwhile.

#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <thread>

namespace prosector {

class WalMover {
 public:
  /// Starts the mover; `file` exists, and outlives it.
  explicit WalMover(std::filesystem::path file);
  ~WalMover();
  WalMover(const WalMover&) = delete;
  WalMover& operator=(const WalMover&) = delete;

 private:
  std::filesystem::path file_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool stop_ = false;
  std::thread thread_;

  void run();
};

}  // namespace prosector
