#include "client/app/run/audience_settings.h"

#include <cmath>

namespace prosector {

Audience audience_settings(const DisplayOptions& o) {
  Audience out = *o.audience;
  if (o.kind == Display::openxr) out.eyes = 2;
  if (o.kind == Display::stereo) {
    out.eyes = 2;
    out.aspect = std::tan(o.stereo.fov_horizontal / 2) / std::tan(o.stereo.fov_vertical / 2);
  }
  return out;
}

}  // namespace prosector
