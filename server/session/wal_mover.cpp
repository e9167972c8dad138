#include "server/session/wal_mover.h"

#include <chrono>

#include "server/session/sqlite.h"

namespace prosector {
namespace {

// A machine that loses its power loses at most this: what is in the log alone is not on the disk yet.
constexpr std::chrono::seconds period{5};

/// Moves the log. What can't be moved now, because the disk is full or somebody reads, can be later.
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
