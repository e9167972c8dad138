#include "server/session/run/file_watch.h"

#include <system_error>
#include <utility>

namespace prosector {

FileWatch::FileWatch(std::function<std::vector<std::filesystem::path>()> files)
    : files_(std::move(files)), settled_(look()), last_(settled_) {}

bool FileWatch::changed() {
  std::vector<Stamp> now = look();
  const bool at_rest = now == last_;
  last_ = std::move(now);
  if (!at_rest || last_ == settled_) return false;
  settled_ = last_;
  return true;
}

std::vector<FileWatch::Stamp> FileWatch::look() const {
  std::vector<Stamp> out;
  for (const std::filesystem::path& file : files_()) {
    Stamp& stamp = out.emplace_back();
    stamp.file = file;
    std::error_code missing;
    const auto bytes = std::filesystem::file_size(file, missing);
    if (!missing) stamp.bytes = bytes;
    const auto written = std::filesystem::last_write_time(file, missing);
    if (!missing) stamp.written = written;
  }
  return out;
}

}  // namespace prosector
