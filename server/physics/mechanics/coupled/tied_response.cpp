#include "server/physics/mechanics/coupled/tied_response.h"

#include "common/assert.h"
#include "server/physics/mechanics/contact/potentials.h"
#include "server/physics/mechanics/coupled/lever.h"

namespace prosector::coupled {
namespace {

bool is_rigid(const contact::Tie& tie) {
  return tie.a.kind == contact::ContactSide::Kind::rigid && tie.b.kind == contact::ContactSide::Kind::rigid;
}

std::size_t member_of(const Island& island, const contact::ContactSide& side) {
  PROSECTOR_ASSERT(side.kind == contact::ContactSide::Kind::rigid);
  std::size_t m = 0;
  while (island.rigid[m].slot != side.body) ++m;
  return m;
}

Mat6 inertia_of(const RigidMember& member, double h) {
  const double pulled = member.pull ? member.pull->stiffness * h * h : 0;
  const double turned = member.pull ? member.pull->angular_stiffness * h * h : 0;
  Mat6 out = Mat6::Zero();
  out.topLeftCorner<3, 3>() = (member.mass + pulled) * Mat3::Identity();
  out.bottomRightCorner<3, 3>() = member.inertia + turned * Mat3::Identity();
  return out;
}

}  // namespace

void TiedResponse::find_members(const Island& island) {
  place_.assign(island.rigid.size(), 0);
  for (const contact::Tie& tie : island.ties)
    if (is_rigid(tie)) place_[member_of(island, tie.a)] = place_[member_of(island, tie.b)] = 1;
  members_.clear();
  for (std::size_t m = 0; m < place_.size(); ++m)
    if (place_[m] != 0) {
      place_[m] = members_.size();
      members_.push_back(m);
    }
}

void TiedResponse::find(const Island& island, double h) {
  find_members(island);
  if (members_.empty()) return;
  const auto size = 6 * static_cast<Eigen::Index>(members_.size());
  inertia_.setZero(size, size);
  const auto block = [&](std::size_t a, std::size_t b) {
    return inertia_.block<6, 6>(6 * static_cast<Eigen::Index>(a), 6 * static_cast<Eigen::Index>(b));
  };
  for (std::size_t k = 0; k < members_.size(); ++k) block(k, k) = inertia_of(island.rigid[members_[k]], h);
  for (const contact::Tie& tie : island.ties) {
    if (!is_rigid(tie)) continue;
    const std::size_t a = member_of(island, tie.a), b = member_of(island, tie.b);
    const Mat36 at_a = lever(tie.a.arm), at_b = lever(tie.b.arm);
    const Vec3 stretch = tie.offset + at_a * island.rigid[a].twist - at_b * island.rigid[b].twist;
    const double k = h * h * contact::BoundedSpring{tie.stiffness, tie.max_force}.secant(stretch.norm());
    block(place_[a], place_[a]) += k * at_a.transpose() * at_a;
    block(place_[b], place_[b]) += k * at_b.transpose() * at_b;
    block(place_[a], place_[b]) -= k * at_a.transpose() * at_b;
    block(place_[b], place_[a]) -= k * at_b.transpose() * at_a;
  }
  factor_.compute(inertia_);
  response_.setIdentity(size, size);
  factor_.solveInPlace(response_);
}

}  // namespace prosector::coupled
