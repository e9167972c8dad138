#include "common/rotation_between.h"

namespace prosector {

Quat rotation_between(const Vec3& from, const Vec3& to) {
  return Quat::FromTwoVectors(from, to);
}

}  // namespace prosector
