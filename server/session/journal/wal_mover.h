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
  /// Starts a thread that periodically moves the write-ahead log of `file`, a SQLite file, into the file
  /// itself. The file must exist until this object is destroyed.
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
