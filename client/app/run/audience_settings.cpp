#include "client/app/run/audience_settings.h"

#include <cmath>

namespace prosector {

Audience audience_settings(const ClientOptions& o) {
  Audience out = *o.audience;
  if (o.display == Display::openxr) out.eyes = 2;
  if (o.display == Display::stereo) {
    out.eyes = 2;
    out.aspect = std::tan(o.stereo.fov_horizontal / 2) / std::tan(o.stereo.fov_vertical / 2);
  }
  return out;
}

}  // namespace prosector
