#include "server/physics/mechanics/soft/matrices/block_matrix.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <array>
#include <functional>

#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/soft/base/table_rows.h"

namespace prosector::soft {
namespace {

constexpr std::size_t block_rows_per_chunk = 128, rows_found_at_once = 512;

/// Contents of a run of rows, concatenated.
struct Rows {
  FreshRows<std::uint32_t> columns, places;
};

/// Per thread, by node: the last row that contained the node, plus one, and the node's place in that row.
struct Seen {
  std::vector<std::uint32_t> by_row, place;
  explicit Seen(std::size_t nodes) : by_row(nodes, 0), place(nodes) {}
};

void find_columns(const Connectivity& elements, const Incidence& incidence, std::uint32_t row, Seen& seen,
                  Rows& out) {
  std::vector<std::uint32_t>& column = out.columns.values;
  const std::size_t first = column.size();
  const auto see = [&](std::uint32_t node) {
    if (seen.by_row[node] == row + 1) return;
    seen.by_row[node] = row + 1;
    column.push_back(node);
  };
  see(row);
  for (const std::uint32_t corner : incidence.corners(row))
    for (const std::uint32_t node : elements.element(elements.element_of(corner))) see(node);
  std::sort(column.begin() + static_cast<std::ptrdiff_t>(first), column.end());
  out.columns.counts.push_back(column.size() - first);
  std::uint32_t right = 0;  // number of columns right of the diagonal
  for (std::size_t k = first; k < column.size(); ++k)
    if (column[k] > row) seen.place[column[k]] = right++;
}

void find_places(const Connectivity& elements, const Incidence& incidence, std::uint32_t row,
                 const Seen& seen, Rows& out) {
  std::vector<std::uint32_t>& place = out.places.values;
  const std::size_t first = place.size();
  for (const std::uint32_t corner : incidence.corners(row)) {
    const std::size_t e = elements.element_of(corner);
    for (const std::uint32_t node : elements.element(e).subspan(corner - elements.first_corner(e) + 1))
      place.push_back(seen.place[node]);
  }
  out.places.counts.push_back(place.size() - first);
}

/// Computes `count` rows in runs of rows_found_at_once. `row_at`(i): index of the i-th row.
template <class RowAt>
std::vector<Rows> find_rows(const Connectivity& elements, const Incidence& incidence, std::size_t count,
                            const RowAt& row_at) {
  std::vector<Rows> runs(chunk_count(count, rows_found_at_once));
  tbb::enumerable_thread_specific<Seen> of_thread(elements.nodes());
  parallel_chunks(count, rows_found_at_once, [&](std::size_t first, std::size_t last, std::size_t run) {
    Seen& seen = of_thread.local();
    for (std::size_t i = first; i < last; ++i) {
      find_columns(elements, incidence, row_at(i), seen, runs[run]);
      find_places(elements, incidence, row_at(i), seen, runs[run]);
    }
  });
  return runs;
}

void append(const FreshRows<std::uint32_t>& rows, FreshRows<std::uint32_t>& to) {
  to.values.insert(to.values.end(), rows.values.begin(), rows.values.end());
  to.counts.insert(to.counts.end(), rows.counts.begin(), rows.counts.end());
}

}  // namespace

BlockPattern::BlockPattern(const Connectivity& elements)
    : elements_(elements), incidence_(elements), row_begin_{0}, place_begin_{0} {
  const std::vector<Rows> runs = find_rows(elements, incidence_, elements.nodes(),
                                           [](std::size_t i) { return static_cast<std::uint32_t>(i); });
  std::vector<std::array<std::size_t, 2>> start;  // of each run, in column_ and in place_
  for (const Rows& rows : runs) {
    start.push_back({row_begin_.back(), place_begin_.back()});
    for (const std::size_t n : rows.columns.counts) row_begin_.push_back(row_begin_.back() + n);
    for (const std::size_t n : rows.places.counts) place_begin_.push_back(place_begin_.back() + n);
  }
  column_.resize(row_begin_.back());
  place_.resize(place_begin_.back());
  parallel_chunks(runs.size(), 1, [&](std::size_t, std::size_t, std::size_t run) {
    const auto &columns = runs[run].columns.values, &places = runs[run].places.values;
    std::copy(columns.begin(), columns.end(), column_.data() + start[run][0]);
    std::copy(places.begin(), places.end(), place_.data() + start[run][1]);
  });
  find_mirrors();
}

void BlockPattern::follow(const MeshEdit& edit) {
  incidence_.follow(elements_, edit);
  replace_rows(edit.kept_nodes, edit.nodes);
}

void BlockPattern::follow(const Kept& kept, std::span<const std::uint32_t> nodes) {
  incidence_ = Incidence(elements_);
  replace_rows(kept, nodes);
}

/// Recomputes the rows of these nodes and keeps the others.
void BlockPattern::replace_rows(const Kept& kept, std::span<const std::uint32_t> nodes) {
  Rows rows;
  for (const Rows& run :
       find_rows(elements_, incidence_, nodes.size(), [&](std::size_t i) { return nodes[i]; })) {
    append(run.columns, rows.columns);
    append(run.places, rows.places);
  }
  const std::vector<std::uint32_t> now = kept.destinations();
  const auto renumbered = [&](std::uint32_t node) { return now[node]; };
  if (kept.all_unmoved())
    soft::replace_rows(kept, nodes, rows.columns, std::identity{}, row_begin_, column_);
  else
    soft::replace_rows(kept, nodes, rows.columns, renumbered, row_begin_, column_);
  soft::replace_rows(kept, nodes, rows.places, std::identity{}, place_begin_, place_);
  find_mirrors();
}

/// Finds, in order of ascending rows, the transposes of blocks: columns left of a row's diagonal ascend too.
void BlockPattern::find_mirrors() {
  std::vector<std::size_t> next(row_begin_.begin(), row_begin_.end() - 1);
  mirror_.resize(column_.size());
  diagonal_.resize(rows());
  for (std::size_t i = 0; i < rows(); ++i) {
    diagonal_[i] = next[i];
    for (std::size_t k = diagonal_[i] + 1; k < end(i); ++k) mirror_[k] = next[column_[k]]++;
  }
}

void BlockPattern::gather(std::span<const Mat3> elements, double scale, std::span<const Mat3> base,
                          std::span<Mat3> values) const {
  parallel_short_chunks(rows(), block_rows_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i) {
      const std::size_t right = diagonal_[i] + 1;
      for (std::size_t k = right; k < end(i); ++k) {
        if (base.empty())
          values[k].setZero();
        else
          values[k] = scale * base[k];
      }
      const std::uint32_t* place = place_.data() + place_begin_[i];
      for (const std::uint32_t corner : incidence_.corners(i)) {
        const std::size_t e = elements_.element_of(corner), n = elements_.element(e).size();
        const std::size_t own = corner - elements_.first_corner(e);
        for (std::size_t b = own + 1; b < n; ++b) {
          const Mat3& block = elements[elements_.first_block(e) + Connectivity::pair_index(own, b, n)];
          double* const total = values[right + *place++].data();
          for (int entry = 0; entry < 9; ++entry) total[entry] += block.data()[entry];
        }
      }
      for (std::size_t k = right; k < end(i); ++k) values[mirror_[k]] = values[k].transpose();
    }
  });
  close_rows(values);
}

/// Computes the diagonal blocks from the others and makes them exactly symmetric; the sum is symmetric only
/// up to rounding.
void BlockPattern::close_rows(std::span<Mat3> values) const {
  parallel_short_chunks(rows(), block_rows_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i) {
      Mat3 sum = Mat3::Zero();
      for (std::size_t k = begin(i); k < diagonal_[i]; ++k) sum += values[k];
      for (std::size_t k = diagonal_[i] + 1; k < end(i); ++k) sum += values[k];
      values[diagonal_[i]] = -0.5 * (sum + sum.transpose());
    }
  });
}

void BlockPattern::multiply(std::span<const Mat3> values, const double* x, double* y) const {
  parallel_short_chunks(rows(), block_rows_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i) {
      double y0 = 0, y1 = 0, y2 = 0;
      for (std::size_t k = begin(i); k < end(i); ++k) {
        const double* A = values[k].data();
        const double* p = x + 3 * std::size_t{column_[k]};
        y0 += A[0] * p[0] + A[3] * p[1] + A[6] * p[2];
        y1 += A[1] * p[0] + A[4] * p[1] + A[7] * p[2];
        y2 += A[2] * p[0] + A[5] * p[1] + A[8] * p[2];
      }
      y[3 * i] = y0;
      y[3 * i + 1] = y1;
      y[3 * i + 2] = y2;
    }
  });
}

}  // namespace prosector::soft
