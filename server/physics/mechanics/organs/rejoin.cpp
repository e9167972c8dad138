#include "server/physics/mechanics/organs/rejoin.h"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <tuple>

#include "common/assert.h"

namespace prosector::organs {
namespace {

// Regularises the rotation of collinear twins: rotation about their line is then zero.
constexpr double least_turn = 1e-9;

struct Node {
  std::uint32_t piece = 0, index = 0;
};
struct RestNode {
  std::array<double, 3> rest{};
  Node node;
  bool gone = false;
};
using Twins = std::array<Node, 2>;  // ascending by piece

/// Returns the pairs of nodes of different pieces that the cut made from one node: their rest positions are
/// equal, and one of them is gone. Where an older cut met the cut there is a third node.
std::vector<Twins> find_twins(const cutting::TetComplex& complex, std::span<const SeparatedPiece> pieces) {
  std::vector<RestNode> nodes;
  for (std::uint32_t p = 0; p < pieces.size(); ++p)
    for (std::uint32_t i = 0; i < pieces[p].mesh->nodes.size(); ++i) {
      const cutting::NodeId id = pieces[p].mesh->nodes[i];
      const Vec3& at = complex.rest(id);
      nodes.push_back({{at.x(), at.y(), at.z()}, {p, i}, !complex.has_node(id)});
    }
  std::stable_sort(nodes.begin(), nodes.end(),
                   [](const RestNode& a, const RestNode& b) { return a.rest < b.rest; });
  std::vector<Twins> out;
  for (std::size_t first = 0, end = 0; first < nodes.size(); first = end) {
    while (end < nodes.size() && nodes[end].rest == nodes[first].rest) ++end;
    for (std::size_t i = first; i < end; ++i)
      for (std::size_t j = i + 1; j < end; ++j)
        if (const std::uint32_t a = nodes[i].node.piece, b = nodes[j].node.piece;
            a != b && pieces[a].joins == pieces[b].joins && (nodes[i].gone || nodes[j].gone))
          out.push_back({nodes[i].node, nodes[j].node});
  }
  return out;
}

Vec3 at(const VecX& field, const Node& node) {
  return field.segment<3>(3 * Eigen::Index{node.index});
}

/// Returns the rigid motion that moves the `from` points nearest to the `to` points.
Pose fit(std::span<const std::array<Vec3, 2>> from_to) {
  PROSECTOR_ASSERT(!from_to.empty());
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
  for (const auto& [a, b] : from_to) from += a, to += b;
  from /= static_cast<double>(from_to.size());
  to /= static_cast<double>(from_to.size());
  Mat3 correlation = Mat3::Zero();
  double size = 0;
  for (const auto& [a, b] : from_to) {
    correlation += (b - to) * (a - from).transpose();
    size += (a - from).squaredNorm();
  }
  correlation += least_turn * size * Mat3::Identity();
  if (size == 0) return {to - from, Quat::Identity()};
  const Eigen::JacobiSVD<Mat3> svd(correlation, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 proper = Mat3::Identity();
  proper(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  const Quat turn(Mat3(svd.matrixU() * proper * svd.matrixV().transpose()));
  return {to - turn * from, turn.normalized()};
}

/// Returns the motion from a piece to its twins in pieces that are already placed; none if it has none there.
std::optional<ReturnMotion> way_back(std::span<const SeparatedPiece> pieces, std::span<const Twins> twins,
                                     std::span<const std::optional<ReturnMotion>> ways,
                                     std::span<const std::uint8_t> placed, std::uint32_t piece) {
  ReturnMotion out;
  std::vector<std::array<Vec3, 2>> from_to;
  for (const Twins& pair : twins) {
    if (pair[0].piece != piece && pair[1].piece != piece) continue;
    const auto& [own, other] =
        pair[0].piece == piece ? std::tie(pair[0], pair[1]) : std::tie(pair[1], pair[0]);
    if (!placed[other.piece]) continue;
    const auto& way = ways[other.piece];
    const Vec3 to = at(*pieces[other.piece].place, other);
    from_to.push_back({at(*pieces[piece].place, own), way ? way->motion * to : to});
    out.velocity += way ? way->velocity : at(*pieces[other.piece].velocity, other);
  }
  if (from_to.empty()) return std::nullopt;
  out.velocity /= static_cast<double>(from_to.size());
  out.motion = fit(from_to);
  return out;
}

/// Returns by piece whether it stays.
std::vector<std::uint8_t> staying(std::span<const SeparatedPiece> pieces) {
  std::vector<std::uint8_t> out;
  for (const SeparatedPiece& piece : pieces) {
    const bool any_tied = std::any_of(pieces.begin(), pieces.end(), [&](const SeparatedPiece& other) {
      return other.joins == piece.joins && other.tied;
    });
    const bool larger = std::any_of(pieces.begin(), pieces.end(), [&](const SeparatedPiece& other) {
      const std::size_t n = other.mesh->nodes.size(), own = piece.mesh->nodes.size();
      return other.joins == piece.joins && (n > own || (n == own && &other < &piece));
    });
    out.push_back(any_tied ? piece.tied : !larger);
  }
  return out;
}

}  // namespace

std::vector<std::optional<ReturnMotion>> ways_back(const cutting::TetComplex& complex,
                                                   std::span<const SeparatedPiece> pieces) {
  std::vector<std::optional<ReturnMotion>> ways(pieces.size());
  std::vector<std::uint8_t> placed = staying(pieces);
  if (std::count(placed.begin(), placed.end(), 0) == 0) return ways;
  const std::vector<Twins> twins = find_twins(complex, pieces);
  // One by one: a piece may be attached to another piece that moves back itself.
  for (bool found = true; found;) {
    found = false;
    for (std::uint32_t piece = 0; piece < pieces.size(); ++piece) {
      if (placed[piece]) continue;
      ways[piece] = way_back(pieces, twins, ways, placed, piece);
      if (!ways[piece]) continue;
      placed[piece] = 1;
      found = true;
    }
  }
  return ways;
}

}  // namespace prosector::organs
