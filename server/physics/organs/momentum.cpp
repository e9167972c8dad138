#include "server/physics/organs/momentum.h"

#include <unordered_map>

namespace prosector {
namespace {

Vec3 momentum(const PieceMotion& piece) {
  Vec3 sum = Vec3::Zero();
  for (Eigen::Index i = 0; i < piece.mass->size(); ++i)
    sum += (*piece.mass)[i] * piece.velocity->segment<3>(3 * i);
  return sum;
}

}  // namespace

void keep_momentum(std::span<const PieceMotion> before, std::span<const PieceMotion> now) {
  Vec3 lost = Vec3::Zero();
  std::unordered_map<NodeId, double> mass_before;
  for (const PieceMotion& piece : before) {
    lost += momentum(piece);
    for (std::size_t n = 0; n < piece.mesh->nodes.size(); ++n)
      mass_before[piece.mesh->nodes[n]] = (*piece.mass)[static_cast<Eigen::Index>(n)];
  }
  for (const PieceMotion& piece : now) lost -= momentum(piece);
  const auto changed = [&](const PieceMotion& piece, std::size_t n) {
    const auto at = mass_before.find(piece.mesh->nodes[n]);
    return at == mass_before.end() || at->second != (*piece.mass)[static_cast<Eigen::Index>(n)];
  };
  double mass = 0;
  for (const PieceMotion& piece : now)
    for (std::size_t n = 0; n < piece.mesh->nodes.size(); ++n)
      if (changed(piece, n)) mass += (*piece.mass)[static_cast<Eigen::Index>(n)];
  if (!(mass > 0)) return;
  const Vec3 more = lost / mass;
  for (const PieceMotion& piece : now)
    for (std::size_t n = 0; n < piece.mesh->nodes.size(); ++n)
      if (changed(piece, n)) piece.velocity->segment<3>(3 * static_cast<Eigen::Index>(n)) += more;
}

}  // namespace prosector
