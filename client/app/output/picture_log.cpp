#include "client/app/output/picture_log.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "common/error.h"

namespace prosector {

PictureLog::PictureLog(const std::filesystem::path& file) : out_(file) {
  if (!out_) throw InputError(fmt::format("--frame-log {}: cannot be written", file.string()));
  out_ << "drawn_ns,camera_ns,hand_ns,tick\n";
}

void PictureLog::add(const FrameTimes& times) {
  fmt::print(out_, "{},{},{},{:.3f}\n", times.drawn_ns, times.camera_ns, times.hand_ns, times.tick);
}

}  // namespace prosector
