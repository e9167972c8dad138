#include "server/physics/mechanics/soft/mechanical_energy.h"

namespace prosector::soft {

double kinetic_energy(const VecX& mass, const VecX& v) {
  double sum = 0;
  for (Eigen::Index i = 0; i < mass.size(); ++i) sum += mass[i] * v.segment<3>(3 * i).squaredNorm();
  return 0.5 * sum;
}

double fall_energy(const VecX& mass, const VecX& from, const VecX& to, const Weight& weight) {
  double sum = 0;
  for (Eigen::Index i = 0; i < mass.size(); ++i)
    sum += mass[i] * weight.at(i).dot(to.segment<3>(3 * i) - from.segment<3>(3 * i));
  return sum;
}

}  // namespace prosector::soft
