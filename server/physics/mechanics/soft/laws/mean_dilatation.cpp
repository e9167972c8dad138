#include "server/physics/mechanics/soft/laws/mean_dilatation.h"

#include <algorithm>

namespace prosector::soft {

SplitMaterials split_volume(const Materials& materials) {
  SplitMaterials out{materials, {}};
  bool any = false;
  for (Material& kind : out.local.kinds) {
    const double most = kind.lame.mu * 2 * most_local_poisson_ratio / (1 - 2 * most_local_poisson_ratio);
    const double local = std::min(kind.lame.lambda, most);
    out.mean.push_back(kind.lame.lambda - local);
    any = any || out.mean.back() > 0;
    kind.lame.lambda = local;
  }
  if (!any) out.mean.clear();
  return out;
}

}  // namespace prosector::soft
