#include "server/physics/mechanics/soft/solvers/star_patches.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/soft/elements/edge_nodes.h"

namespace prosector::soft {
namespace {

constexpr std::size_t patches_per_chunk = 16, nodes_per_chunk = 512;

/// Returns, by vertex, its own node and those of its edges, ascending; empty for nodes that are not vertices.
std::vector<std::vector<std::uint32_t>> stars_of(const Connectivity& elements) {
  std::vector<std::vector<std::uint32_t>> stars(elements.nodes());
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const auto nodes = elements.element(e);
    for (std::size_t k = 0; k < EdgeNodes::edges_of_tet.size(); ++k)
      for (const std::size_t end : EdgeNodes::edges_of_tet[k]) stars[nodes[end]].push_back(nodes[4 + k]);
  }
  for (std::size_t i = 0; i < stars.size(); ++i) {
    std::vector<std::uint32_t>& star = stars[i];
    if (star.empty()) continue;
    star.push_back(static_cast<std::uint32_t>(i));
    std::sort(star.begin(), star.end());
    star.erase(std::unique(star.begin(), star.end()), star.end());
  }
  return stars;
}

}  // namespace

struct StarPatches::Impl {
  std::vector<std::size_t> begin{0};     // by patch: start in `node`
  std::vector<std::uint32_t> node;       // of all patches, concatenated
  std::vector<std::size_t> matrix{0};    // by patch: start in `stiffness` and `inverse`
  std::vector<float> stiffness;          // in the rest shape with attachments, column-major per patch, N/m
  std::vector<float> inverse;            // in the same layout
  std::vector<double> mass;              // kg, in the order of `node`
  std::vector<std::size_t> place_begin;  // by node: start in `place`
  std::vector<std::uint32_t> place;      // indices of the node in `node`
  std::vector<float> given, found;       // 3 numbers per entry of `node`
  double alpha = -1;

  explicit Impl(const RestSystem& rest) {
    std::vector<std::vector<std::uint32_t>> places(rest.pattern.rows());
    for (const auto& star : stars_of(rest.elements)) {
      if (star.empty()) continue;
      for (const std::uint32_t i : star) {
        places[i].push_back(static_cast<std::uint32_t>(node.size()));
        node.push_back(i);
        mass.push_back(rest.mass[static_cast<Eigen::Index>(i)]);
      }
      begin.push_back(node.size());
      matrix.push_back(matrix.back() + 9 * star.size() * star.size());
    }
    place_begin.push_back(0);
    for (const auto& own : places) {
      place.insert(place.end(), own.begin(), own.end());
      place_begin.push_back(place.size());
    }
    given.resize(3 * node.size());
    found.resize(3 * node.size());
    stiffness.assign(matrix.back(), 0);
    inverse.resize(matrix.back());
    parallel_chunks(patches(), patches_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t p = first; p < last; ++p) take_stiffness(rest, p);
    });
  }

  std::size_t patches() const { return begin.size() - 1; }
  std::size_t size(std::size_t p) const { return begin[p + 1] - begin[p]; }

  void take_stiffness(const RestSystem& rest, std::size_t p) {
    const auto own = std::span(node).subspan(begin[p], size(p));
    const auto n = static_cast<Eigen::Index>(3 * size(p));
    Eigen::Map<Eigen::MatrixXf> A(&stiffness[matrix[p]], n, n);
    for (std::size_t a = 0; a < own.size(); ++a) {
      const std::uint32_t i = own[a];
      std::size_t k = rest.pattern.begin(i);
      for (std::size_t b = 0; b < own.size(); ++b) {
        while (k < rest.pattern.end(i) && rest.pattern.column(k) < own[b]) ++k;
        if (k == rest.pattern.end(i) || rest.pattern.column(k) != own[b]) continue;
        A.block<3, 3>(3 * static_cast<Eigen::Index>(a), 3 * static_cast<Eigen::Index>(b)) =
            rest.stiffness[k].cast<float>();
      }
      A.diagonal().segment<3>(3 * static_cast<Eigen::Index>(a)).array() +=
          static_cast<float>(rest.attached[static_cast<Eigen::Index>(i)]);
    }
  }

  void invert(std::size_t p) {
    const auto n = static_cast<Eigen::Index>(3 * size(p));
    Eigen::MatrixXd A = Eigen::Map<const Eigen::MatrixXf>(&stiffness[matrix[p]], n, n).cast<double>();
    for (std::size_t a = 0; a < size(p); ++a)
      A.diagonal().segment<3>(3 * static_cast<Eigen::Index>(a)).array() += alpha * mass[begin[p] + a];
    Eigen::Map<Eigen::MatrixXf>(&inverse[matrix[p]], n, n) =
        A.llt().solve(Eigen::MatrixXd::Identity(n, n)).cast<float>();
  }

  void solve(std::size_t p, const float* r) {
    for (std::size_t a = begin[p]; a < begin[p + 1]; ++a)
      std::copy_n(r + 3 * std::size_t{node[a]}, 3, &given[3 * a]);
    const auto n = static_cast<Eigen::Index>(3 * size(p));
    Eigen::Map<Eigen::VectorXf>(&found[3 * begin[p]], n).noalias() =
        Eigen::Map<const Eigen::MatrixXf>(&inverse[matrix[p]], n, n) *
        Eigen::Map<const Eigen::VectorXf>(&given[3 * begin[p]], n);
  }
};

StarPatches::StarPatches(const RestSystem& rest) : impl_(std::make_unique<Impl>(rest)) {}
StarPatches::~StarPatches() = default;

void StarPatches::retime(double inertia) {
  if (inertia == impl_->alpha) return;
  impl_->alpha = inertia;
  parallel_chunks(impl_->patches(), patches_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t p = first; p < last; ++p) impl_->invert(p);
  });
}

void StarPatches::add(float share, const float* r, float* z) {
  Impl& m = *impl_;
  parallel_chunks(m.patches(), patches_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t p = first; p < last; ++p) m.solve(p, r);
  });
  parallel_chunks(m.place_begin.size() - 1, nodes_per_chunk,
                  [&](std::size_t first, std::size_t last, std::size_t) {
                    for (std::size_t i = first; i < last; ++i)
                      for (std::size_t k = m.place_begin[i]; k < m.place_begin[i + 1]; ++k)
                        for (std::size_t c = 0; c < 3; ++c)
                          z[3 * i + c] += share * m.found[3 * std::size_t{m.place[k]} + c];
                  });
}

}  // namespace prosector::soft
