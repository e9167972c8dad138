#pragma once
// Moves a journal's write-ahead log into its file periodically. That waits for the disk, so a separate thread
// and connection do it: ticks are written meanwhile.

#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <thread>

namespace prosector {

class WalMover {
 public:
  /// Starts the mover. `file` must exist as long as it runs.
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
