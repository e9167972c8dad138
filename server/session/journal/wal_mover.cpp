#include "server/session/journal/wal_mover.h"

#include <chrono>

#include "server/session/journal/sqlite.h"

namespace prosector {
namespace {

// A power failure loses at most this much time: what is only in the log is not on the disk yet.
constexpr std::chrono::seconds period{5};

/// Moves the log. If the disk is full or a reader is active, a later call moves the rest.
void move(const std::filesystem::path& file) {
  try {
    SqliteDatabase database(file, SqliteDatabase::Mode::write);
    database.execute("PRAGMA synchronous=NORMAL; PRAGMA wal_checkpoint(PASSIVE)");
  } catch (const SqliteError&) {
  }
}

}  // namespace

WalMover::WalMover(std::filesystem::path file) : file_(std::move(file)), thread_([this] { run(); }) {}

WalMover::~WalMover() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void WalMover::run() {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, period, [this] { return stop_; })) {
    lock.unlock();
    move(file_);
    lock.lock();
  }
}

}  // namespace prosector
