#include "client/render/shader_watch.h"

#include <utility>

namespace prosector {

bool ShaderWatch::changed() {
  Times now = times();
  if (now == written_) return false;
  written_ = std::move(now);
  return true;
}

// A file that an editor is replacing may be missing for a moment, and is then not listed.
ShaderWatch::Times ShaderWatch::times() const {
  Times out;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder_, error)) {
    const auto time = entry.last_write_time(error);
    if (!error) out[entry.path()] = time;
  }
  return out;
}

}  // namespace prosector
