#include "server/physics/mechanics/soft/solvers/multigrid.h"

#include <Eigen/Cholesky>
#include <limits>

#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/soft/elements/corotational_kernel.h"
#include "server/physics/mechanics/soft/matrices/float_rows.h"
#include "server/physics/mechanics/soft/solvers/node_covariance.h"
#include "server/physics/mechanics/soft/solvers/smoothed_aggregation.h"
#include "server/physics/mechanics/soft/solvers/star_patches.h"

namespace prosector::soft {
namespace {

constexpr int smoothing_steps = 2, smoothing_steps_beside_stars = 1;
constexpr float share_of_stars = 0.8F;         // since most nodes are in two stars
constexpr Eigen::Index direct_unknowns = 200;  // maximum on the coarsest level, which is solved directly
// Relative to elastic stiffness: nodes with a stiffer attachment are left out of the coarse levels.
constexpr double firmly = 10;
constexpr std::size_t fine_rows_per_chunk = 256, coarse_rows_per_chunk = 32, numbers_per_chunk = 4096;

using Mat6 = Eigen::Matrix<double, 6, 6>;

template <class Block>
void write(const Block& block, float* to) {
  for (Eigen::Index k = 0; k < block.size(); ++k) to[k] = static_cast<float>(block.data()[k]);
}

/// Converts blocks to floats, with one readable float beyond the last block.
template <class Block>
std::vector<float> floats(const std::vector<Block>& blocks) {
  constexpr auto size = static_cast<std::size_t>(Block::SizeAtCompileTime);
  std::vector<float> out(size * blocks.size() + 1);
  for (std::size_t k = 0; k < blocks.size(); ++k) write(blocks[k], out.data() + size * k);
  return out;
}

/// Returns the matrix with each row scaled by a weight.
template <int R, int C>
BlockCsr<R, C> weighted(const VecX& weight, BlockCsr<R, C> A) {
  for (std::size_t i = 0; i < A.rows(); ++i)
    for (std::size_t k = A.begin[i]; k < A.begin[i + 1]; ++k)
      A.value[k] *= weight[static_cast<Eigen::Index>(i)];
  return A;
}

/// Prolongation P and restriction Pᵀ between a level with B unknowns per node and the next coarser one.
template <int B>
struct Transfer {
  BlockCsr<B, 6> down;  // only the structure is kept after construction
  BlockCsr<6, B> up;
  std::vector<float> prolongation, restriction;

  explicit Transfer(const Coarsening<B>& step)
      : down(step.prolongation),
        up(step.restriction),
        prolongation(floats(down.value)),
        restriction(floats(up.value)) {
    down.value = {};
    up.value = {};
  }
  void restrict_to(const float* fine, float* coarse) const {
    const FloatBlocks A = {up.begin.data(), up.column.data(), restriction.data()};
    parallel_chunks(up.rows(), coarse_rows_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
      multiply<6, B>(A, first, last, fine, coarse);
    });
  }
  void prolong(const float* coarse, float* fine) const {
    const FloatBlocks A = {down.begin.data(), down.column.data(), prolongation.data()};
    parallel_chunks(down.rows(), fine_rows_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
      multiply<B, 6>(A, first, last, coarse, fine);
    });
  }
};

/// Work vectors of one level.
struct Work {
  std::vector<float> b, z, other, d;
  explicit Work(std::size_t unknowns) : b(unknowns), z(unknowns), other(unknowns), d(unknowns) {}
};

/// Performs `steps` Chebyshev steps on z, or starts from zero.
template <class Rows>
void smooth_level(const Rows& A, std::size_t rows, std::size_t chunk, float eigenvalue, bool from_zero,
                  Work& w, int steps = smoothing_steps) {
  for (int i = 1; i <= steps; ++i) {
    const float k = static_cast<float>(i - 1);
    const float keep = i == 1 ? 0 : (2 * k - 1) / (2 * k + 3);
    const float gain = i == 1 ? 4 / (3 * eigenvalue) : (8 * k + 4) / ((2 * k + 3) * eigenvalue);
    parallel_chunks(rows, chunk, [&](std::size_t first, std::size_t last, std::size_t) {
      if (i == 1 && from_zero) {
        smooth_from_zero(A, first, last, w.b.data(), gain, w.d.data(), w.other.data());
      } else {
        smooth(A, first, last, w.b.data(), w.z.data(), keep, gain, w.d.data(), w.other.data());
      }
    });
    w.z.swap(w.other);
  }
}

template <class Rows>
void residual_level(const Rows& A, std::size_t rows, std::size_t chunk, Work& w) {
  parallel_chunks(rows, chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    residual(A, first, last, w.b.data(), w.z.data(), w.other.data());
  });
}

/// Adds `from` to `to`.
void add(const std::vector<float>& from, std::vector<float>& to) {
  parallel_chunks(to.size(), numbers_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i) to[i] += from[i];
  });
}

/// Converts to four floats per node, relative to the first node, so that numbers are small enough for single
/// precision.
void near_origin(const double* x, std::vector<float>& out) {
  parallel_chunks(out.size() / 4, numbers_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i)
      for (std::size_t k = 0; k < 3; ++k) out[4 * i + k] = static_cast<float>(x[3 * i + k] - x[k]);
  });
}

/// A coarse level with six unknowns per node.
struct CoarseLevel {
  BlockCsr<6, 6> stiffness;   // in the rest shape
  std::vector<Mat6> inertia;  // with the same structure
  std::vector<std::size_t> diagonal;
  float eigenvalue = 1;
  std::unique_ptr<Transfer<6>> transfer;  // to the next level; none on the coarsest, solved directly
  std::vector<float> value, inverse;
  Eigen::MatrixXd dense;
  Eigen::MatrixXf dense_inverse;
  Work work;

  CoarseLevel(BlockCsr<6, 6> K, const BlockCsr<6, 6>& M)
      : stiffness(std::move(K)), inertia(stiffness.value.size(), Mat6::Zero()), work(6 * stiffness.rows()) {
    for (std::size_t i = 0; i < rows(); ++i) {
      diagonal.push_back(find(i, static_cast<std::uint32_t>(i)));
      for (std::size_t k = M.begin[i]; k < M.begin[i + 1]; ++k) inertia[find(i, M.column[k])] = M.value[k];
    }
    value.resize(36 * stiffness.value.size() + 1);
    inverse.resize(36 * rows() + 1);
  }
  std::size_t rows() const { return stiffness.rows(); }
  std::size_t find(std::size_t i, std::uint32_t j) const {
    const auto first = stiffness.column.begin() + static_cast<std::ptrdiff_t>(stiffness.begin[i]);
    const auto last = stiffness.column.begin() + static_cast<std::ptrdiff_t>(stiffness.begin[i + 1]);
    return static_cast<std::size_t>(std::lower_bound(first, last, j) - stiffness.column.begin());
  }
  FloatRows matrix() const {
    return {{stiffness.begin.data(), stiffness.column.data(), value.data()}, inverse.data()};
  }
  void make_coarsest() {
    const auto n = static_cast<Eigen::Index>(6 * rows());
    dense.resize(n, n);
    dense_inverse.resize(n, n);
  }

  void retime(double alpha) {
    const auto sum = [&](std::size_t k) -> Mat6 { return stiffness.value[k] + alpha * inertia[k]; };
    if (!transfer) {
      dense.setZero();
      for (std::size_t i = 0; i < rows(); ++i)
        for (std::size_t k = stiffness.begin[i]; k < stiffness.begin[i + 1]; ++k)
          dense.block<6, 6>(6 * static_cast<Eigen::Index>(i),
                            6 * static_cast<Eigen::Index>(stiffness.column[k])) = sum(k);
      dense_inverse = dense.llt().solve(Eigen::MatrixXd::Identity(dense.rows(), dense.cols())).cast<float>();
      return;
    }
    parallel_chunks(rows(), coarse_rows_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t k = stiffness.begin[first]; k < stiffness.begin[last]; ++k)
        write(sum(k), value.data() + 36 * k);
      for (std::size_t i = first; i < last; ++i)
        write(Mat6(sum(diagonal[i]).inverse()), inverse.data() + 36 * i);
    });
  }
};

}  // namespace

struct Multigrid::Impl {
  const BlockPattern& pattern;
  VecX rest;
  float eigenvalue = 1;
  std::unique_ptr<Transfer<3>> transfer;  // none: all nodes are attached firmly
  std::vector<CoarseLevel> coarse;
  std::unique_ptr<StarPatches> stars;  // for quadratic elements
  SymmetricBlocks off_diagonal{};
  // Diagonal blocks of H/s, their inverses, and node rotations; 9 numbers per node, column-major.
  std::vector<float> diagonal, inverse, turned;
  std::vector<float> positions, rest_positions;  // 4 numbers per node
  std::vector<float> turned_back;                // 3 numbers per node: residual corrected by the stars
  bool turns = false;
  double alpha = -1, scale = 1;
  Work work;

  explicit Impl(const RestSystem& system)
      : pattern(system.pattern), rest(system.positions), work(3 * system.pattern.rows()) {
    BlockCsr<3, 3> A;
    A.reserve(pattern.rows(), pattern.blocks());
    std::vector<bool> held(pattern.rows());
    for (std::size_t i = 0; i < pattern.rows(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      for (std::size_t k = pattern.begin(i); k < pattern.end(i); ++k)
        A.add(pattern.column(k), system.stiffness[k]);
      A.close_row();
      Mat3& own = A.value[pattern.diagonal(i)];
      held[i] = 3 * system.attached[row] > firmly * own.trace();
      own.diagonal().array() += system.attached[row];
      if (!(own.trace() > 0)) own.setIdentity(), held[i] = true;  // the node is in no element
    }
    diagonal.resize(9 * pattern.rows() + 1);
    inverse.resize(9 * pattern.rows() + 1);
    turned.resize(9 * pattern.rows());
    positions.resize(4 * pattern.rows());
    rest_positions.resize(4 * pattern.rows());
    near_origin(rest.data(), rest_positions);
    coarsen_all(A, system.mass, held);
    if (transfer && system.elements.corners_each() == 10) {
      stars = std::make_unique<StarPatches>(system);
      turned_back.resize(3 * pattern.rows());
    }
  }

  /// Returns translations and rotations about the centre, the latter relative to the body's size.
  std::vector<Eigen::Matrix<double, 3, 6>> rigid_modes() const {
    const double size = std::max(rest.maxCoeff() - rest.minCoeff(), std::numeric_limits<double>::min());
    const Vec3 middle = rest.reshaped(3, rest.size() / 3).rowwise().mean();
    std::vector<Eigen::Matrix<double, 3, 6>> modes(pattern.rows());
    for (std::size_t i = 0; i < modes.size(); ++i) {
      const Vec3 p = (rest.segment<3>(3 * static_cast<Eigen::Index>(i)) - middle) / size;
      modes[i] << Mat3::Identity(),
          (Mat3() << 0, p.z(), -p.y(), -p.z(), 0, p.x(), p.y(), -p.x(), 0).finished();
    }
    return modes;
  }

  void coarsen_all(const BlockCsr<3, 3>& A, const VecX& mass, const std::vector<bool>& held) {
    const double largest = largest_eigenvalue(A);
    eigenvalue = static_cast<float>(largest);
    const auto modes = rigid_modes();
    const Coarsening<3> first = coarsen<3>(A, modes, held, largest);
    if (first.nodes == 0) return;
    transfer = std::make_unique<Transfer<3>>(first);
    BlockCsr<6, 6> inertia = product(first.restriction, weighted(mass, first.prolongation), first.nodes);
    coarse.emplace_back(first.matrix, inertia);
    std::vector<Mat6> coarse_modes = first.modes;
    while (static_cast<Eigen::Index>(6 * coarse.back().rows()) > direct_unknowns) {
      CoarseLevel& level = coarse.back();
      const double bound = std::max(largest_eigenvalue(level.stiffness), inertia_eigenvalue(level));
      level.eigenvalue = static_cast<float>(bound);
      const Coarsening<6> next =
          coarsen<6>(level.stiffness, coarse_modes, std::vector<bool>(level.rows(), false), bound);
      if (next.nodes >= level.rows()) break;
      level.transfer = std::make_unique<Transfer<6>>(next);
      inertia = product(next.restriction, product(inertia, next.prolongation, next.nodes), next.nodes);
      coarse_modes = next.modes;
      coarse.emplace_back(next.matrix, inertia);
    }
    coarse.back().make_coarsest();
  }

  static double inertia_eigenvalue(const CoarseLevel& level) {
    BlockCsr<6, 6> M = level.stiffness;
    M.value = level.inertia;
    for (std::size_t i = 0; i < level.rows(); ++i)
      for (int mode = 0; mode < 6; ++mode) {
        double& entry = M.value[level.diagonal[i]](mode, mode);
        if (entry == 0) entry = 1;
      }
    return largest_eigenvalue(M);
  }

  /// Returns the number of smoothing steps on the finest level.
  int steps() const { return stars ? smoothing_steps_beside_stars : smoothing_steps; }
  SymmetricFloats matrix() const { return {off_diagonal, diagonal.data(), inverse.data()}; }

  /// Computes to = Rᵀ·from or, if `forward`, to += R·from.
  void rotate(bool forward, const float* from, float* to) const {
    parallel_chunks(pattern.rows(), fine_rows_per_chunk,
                    [&](std::size_t first, std::size_t last, std::size_t) {
                      for (std::size_t i = first; i < last; ++i) {
                        using Vec = Eigen::Vector3f;
                        const Eigen::Map<const Eigen::Matrix3f> R(turned.data() + 9 * i);
                        const Eigen::Map<const Vec> in(from + 3 * i);
                        Eigen::Map<Vec> out(to + 3 * i);
                        if (forward) {
                          out += turns ? Vec(R * in) : Vec(in);
                        } else {
                          out = turns ? Vec(R.transpose() * in) : Vec(in);
                        }
                      }
                    });
  }

  void correct(std::size_t l) {
    CoarseLevel& level = coarse[l];
    Work& w = level.work;
    if (!level.transfer) {
      const auto n = level.dense_inverse.rows();
      Eigen::Map<Eigen::VectorXf>(w.z.data(), n).noalias() =
          level.dense_inverse * Eigen::Map<const Eigen::VectorXf>(w.b.data(), n);
      return;
    }
    smooth_level(level.matrix(), level.rows(), coarse_rows_per_chunk, level.eigenvalue, true, w);
    residual_level(level.matrix(), level.rows(), coarse_rows_per_chunk, w);
    level.transfer->restrict_to(w.other.data(), coarse[l + 1].work.b.data());
    correct(l + 1);
    level.transfer->prolong(coarse[l + 1].work.z.data(), w.other.data());
    add(w.other, w.z);
    smooth_level(level.matrix(), level.rows(), coarse_rows_per_chunk, level.eigenvalue, false, w);
  }
};

Multigrid::Multigrid(const RestSystem& rest) : impl_(std::make_unique<Impl>(rest)) {}
Multigrid::~Multigrid() = default;

std::size_t Multigrid::levels() const {
  return 1 + impl_->coarse.size();
}

void Multigrid::retime(double inertia) {
  if (inertia == impl_->alpha) return;
  impl_->alpha = inertia;
  for (CoarseLevel& level : impl_->coarse) level.retime(inertia);
  if (impl_->stars) impl_->stars->retime(inertia);
}

void Multigrid::turn(const double* x) {
  Impl& m = *impl_;
  m.turns = x != nullptr;
  if (!x || !m.transfer) return;
  near_origin(x, m.positions);
  // Each rotation is the best fit to the motion of the node's neighbours.
  parallel_chunks(
      m.pattern.rows(), elements_per_batch, [&](std::size_t first, std::size_t last, std::size_t) {
        LaneStrain strain;
        for (std::size_t lane = last - first; lane < elements_per_batch; ++lane)
          for (std::size_t k = 0; k < 9; ++k) strain.F.at[k][lane] = k % 4 == 0 ? 1 : 0;
        node_covariances(m.pattern, m.positions.data(), m.rest_positions.data(), first, last, strain.F);
        lane_rotations(strain);
        for (std::size_t i = first; i < last; ++i)
          for (std::size_t k = 0; k < 9; ++k)
            m.turned[9 * i + k] = static_cast<float>(strain.R.at[k][i - first]);
      });
}

void Multigrid::set_matrix(const SymmetricBlocks& off_diagonal, double scale, std::span<const Mat3> diagonal,
                           std::span<const Mat3> inverse) {
  Impl& m = *impl_;
  m.off_diagonal = off_diagonal;
  m.scale = scale;
  parallel_chunks(m.pattern.rows(), fine_rows_per_chunk,
                  [&](std::size_t first, std::size_t last, std::size_t) {
                    for (std::size_t i = first; i < last; ++i) {
                      write(Mat3(diagonal[i] / scale), m.diagonal.data() + 9 * i);
                      write(Mat3(inverse[i] * scale), m.inverse.data() + 9 * i);
                    }
                  });
}

void Multigrid::apply(const double* r, double* z) {
  Impl& m = *impl_;
  Work& w = m.work;
  const std::size_t rows = m.pattern.rows();
  parallel_chunks(w.b.size(), numbers_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i) w.b[i] = static_cast<float>(r[i] / m.scale);
  });
  smooth_level(m.matrix(), rows, fine_rows_per_chunk, m.eigenvalue, true, w, m.steps());
  if (m.transfer) {
    residual_level(m.matrix(), rows, fine_rows_per_chunk, w);
    m.rotate(false, w.other.data(), w.d.data());
    if (m.stars) m.turned_back = w.d;
    m.transfer->restrict_to(w.d.data(), m.coarse.front().work.b.data());
    m.correct(0);
    m.transfer->prolong(m.coarse.front().work.z.data(), w.d.data());
    if (m.stars) m.stars->add(share_of_stars, m.turned_back.data(), w.d.data());
    m.rotate(true, w.d.data(), w.z.data());
  }
  smooth_level(m.matrix(), rows, fine_rows_per_chunk, m.eigenvalue, false, w, m.steps());
  parallel_chunks(w.z.size(), numbers_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i) z[i] = static_cast<double>(w.z[i]);
  });
}

}  // namespace prosector::soft
