#include "engine/block_matrix.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

namespace {

/// Sums products in eight lanes that are added up in a fixed order: the compiler may use the machine's vectors, whose
/// width then decides nothing.
template <typename T>
T dot_product(const T* a, const T* b, int count) {
  constexpr int lanes = 8;
  T rest = 0;
  int k = 0;
  if (count < lanes) {
    for (; k < count; ++k) rest += a[k] * b[k];
    return rest;
  }
  T sums[lanes] = {};
  for (; k + lanes <= count; k += lanes) {
    for (int lane = 0; lane < lanes; ++lane) sums[lane] += a[k + lane] * b[k + lane];
  }
  for (; k < count; ++k) rest += a[k] * b[k];
  return (((sums[0] + sums[4]) + (sums[2] + sums[6])) + ((sums[1] + sums[5]) + (sums[3] + sums[7]))) + rest;
}

/// Columns whose blocks stand in runs of so many rows on average are taken run by run, which the machine's vectors
/// like; where runs are shorter, row by row is faster.
constexpr int long_run = 16;

/// Rows that two blocks of a column bring together meet in the column of the first of them: all below the first one
/// come into its column, which passes them on.
std::vector<int> merged(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> both;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

}  // namespace

template <typename T>
bool BlockMatrixOf<T>::plan(std::vector<std::vector<int>> below, const std::vector<int>& most_rows, double most_work) {
  start_.assign(1, 0);
  row_.clear();
  column_.clear();
  beside_.assign(below.size(), {});
  double work = 0;
  for (int c = 0; c < static_cast<int>(below.size()); ++c) {
    const std::vector<int>& rows = below[at(c)];
    double height = 0.5 * most_rows[at(c)];
    row_.push_back(c);
    for (const int row : rows) {
      height += most_rows[at(row)];
      beside_[at(row)].push_back(static_cast<int>(row_.size()));
      row_.push_back(row);
    }
    work += 0.5 * most_rows[at(c)] * height * height;
    if (work > most_work) return false;
    column_.resize(row_.size(), c);
    start_.push_back(static_cast<int>(row_.size()));
    if (!rows.empty()) below[at(rows.front())] = merged(below[at(rows.front())], {rows.begin() + 1, rows.end()});
  }
  find_runs(most_rows);
  resize(most_rows);
  return true;
}

template <typename T>
void BlockMatrixOf<T>::find_runs(const std::vector<int>& most_rows) {
  run_end_.resize(row_.size());
  in_runs_.assign(most_rows.size(), false);
  for (int c = 0; c < static_cast<int>(most_rows.size()); ++c) {
    int runs = 0;
    int height = 0;
    for (int p = start_[at(c) + 1] - 1; p >= start_[at(c)]; --p) {
      const bool ends = p + 1 == start_[at(c) + 1] || row_[at(p) + 1] != row_[at(p)] + 1;
      run_end_[at(p)] = ends ? p + 1 : run_end_[at(p) + 1];
      runs += ends;
      height += most_rows[at(row_[at(p)])];
    }
    in_runs_[at(c)] = height >= long_run * runs;
  }
}

template <typename T>
void BlockMatrixOf<T>::resize(const std::vector<int>& rows) {
  first_.assign(1, 0);
  for (const int count : rows) first_.push_back(first_.back() + count);
  offset_.resize(row_.size());
  panel_.resize(rows.size());
  height_.resize(rows.size());
  list_.resize(rows.size());
  std::size_t used = 0;
  int widest = 0;
  int listed = 0;
  for (int c = 0; c < static_cast<int>(rows.size()); ++c) {
    int height = 0;
    for (int p = start_[at(c)]; p < start_[at(c) + 1]; ++p) {
      offset_[at(p)] = height;
      height += rows[at(row_[at(p)])];
    }
    height_[at(c)] = height;
    list_[at(c)] = at(listed);
    equations_.resize(at(listed + height));
    for (int p = start_[at(c)]; p < start_[at(c) + 1]; ++p) {
      for (int i = 0; i < rows[at(row_[at(p)])]; ++i) equations_[at(listed++)] = first_[at(row_[at(p)])] + i;
    }
    panel_[at(c)] = used;
    used += at(height) * at(rows[at(c)]);
    widest = std::max(widest, rows[at(c)]);
  }
  values_.assign(used, 0);
  pivot_.resize(at(size()));
  inverse_pivot_.resize(at(size()));
  updates_.assign(at(size()) * at(widest), 0);
}

template <typename T>
void BlockMatrixOf<T>::clear() {
  std::fill(values_.begin(), values_.end(), T(0));
}

template <typename T>
int BlockMatrixOf<T>::place_of(int row, int column) const {
  const auto begin = row_.begin() + start_[at(column)];
  return static_cast<int>(std::lower_bound(begin, row_.begin() + start_[at(column) + 1], row) - row_.begin());
}

template <typename T>
void BlockMatrixOf<T>::stretch_diagonal(T factor) {
  for (std::size_t c = 0; c < panel_.size(); ++c) {
    const std::size_t step = at(height_[c]) + 1;
    const int count = rows_of(static_cast<int>(c));
    for (int i = 0; i < count; ++i) values_[panel_[c] + at(i) * step] *= factor;
  }
}

/// Visits the rows of a column from `skip` rows below the upper edge of the block at `place` on, by runs of consecutive
/// equations: visit(first equation, offset in the panel, count).
template <typename T>
template <typename Visit>
void BlockMatrixOf<T>::for_each_run(int place, int skip, Visit&& visit) const {
  const int end = start_[at(column_[at(place)]) + 1];
  for (int p = place; p < end; p = run_end_[at(p)], skip = 0) {
    const int row = first_[at(row_[at(p)])] + skip;
    visit(row, offset_[at(p)] + skip, first_[at(row_[at(run_end_[at(p)] - 1)]) + 1] - row);
  }
}

/// What eliminating the column of the block at `place` does to the column of the block's row.
template <typename T>
void BlockMatrixOf<T>::subtract_what_follows_from(int place) {
  const int source = column_[at(place)];
  if (in_runs_[at(source)]) return subtract_in_runs(place);
  const int width = rows_of(row_[at(place)]);
  const int height = height_[at(source)];
  const int offset = offset_[at(place)];
  const int* equations = equations_.data() + list_[at(source)];
  const T* values = values_.data() + panel_[at(source)];
  for (int s = first(source); s < first(source + 1); ++s, values += height) {
    T* updates = updates_.data();
    for (int t = offset; t < offset + width; ++t, updates += size()) {
      const T factor = values[t] * pivot_[at(s)];
      for (int k = t; k < height; ++k) updates[equations[k]] += factor * values[k];
    }
  }
}

/// The same, two columns at a time, so that the sums are loaded half as often.
template <typename T>
void BlockMatrixOf<T>::subtract_in_runs(int place) {
  const int source = column_[at(place)];
  const std::size_t height = at(height_[at(source)]);
  const int width = rows_of(row_[at(place)]);
  for (int s = first(source); s < first(source + 1); s += 2) {
    const bool pair = s + 1 < first(source + 1);
    const T* a = values_.data() + panel_[at(source)] + at(s - first(source)) * height;
    const T* b = pair ? a + height : a;
    for (int t = 0; t < width; ++t) {
      const T of_a = a[offset_[at(place)] + t] * pivot_[at(s)];
      const T of_b = pair ? b[offset_[at(place)] + t] * pivot_[at(s) + 1] : 0;
      for_each_run(place, t, [&](int row, int offset, int count) {
        T* __restrict sum = updates_.data() + at(t) * at(size()) + row;
        for (int k = 0; k < count; ++k) sum[k] += of_a * a[offset + k] + of_b * b[offset + k];
      });
    }
  }
}

template <typename T>
void BlockMatrixOf<T>::take_updates(int column) {
  const int* equations = equations_.data() + list_[at(column)];
  for (int t = 0; t < rows_of(column); ++t) {
    T* values = values_.data() + panel_[at(column)] + at(t) * at(height_[at(column)]);
    T* updates = updates_.data() + at(t) * at(size());
    for (int k = 0; k < height_[at(column)]; ++k) values[k] -= std::exchange(updates[equations[k]], T(0));
  }
}

template <typename T>
T BlockMatrixOf<T>::factor() {
  T least = 1;
  for (int c = 0; c + 1 < static_cast<int>(first_.size()); ++c) {
    // Until the panel is factored, the diagonal as it was waits where the inverse pivots will be.
    for (int t = 0; t < rows_of(c); ++t)
      inverse_pivot_[at(first(c) + t)] = values_[panel_[at(c)] + at(t) * (at(height_[at(c)]) + 1)];
    for (const int place : beside_[at(c)]) subtract_what_follows_from(place);
    if (!beside_[at(c)].empty()) take_updates(c);
    least = std::min(least, factor_panel(c));
  }
  return least;
}

/// Eliminates within one panel, column by column. Returns its least relative pivot.
template <typename T>
T BlockMatrixOf<T>::factor_panel(int column) {
  const T negligible = 64 * std::numeric_limits<T>::epsilon();
  T least = 1;
  const int width = rows_of(column);
  const int height = height_[at(column)];
  T* panel = values_.data() + panel_[at(column)];
  for (int t = 0; t < width; ++t) {
    T* values = panel + t * height;
    const T pivot = values[t];
    T& diagonal = inverse_pivot_[at(first(column) + t)];
    if (pivot < least * diagonal) least = pivot / diagonal;
    const T inverse = pivot > negligible * diagonal ? 1 / pivot : 0;
    for (int u = t + 1; u < width; ++u) {
      const T factor = values[u] * inverse;
      T* __restrict other = panel + u * height;
      for (int k = u; k < height; ++k) other[k] -= factor * values[k];
    }
    for (int k = t + 1; k < height; ++k) values[k] *= inverse;
    pivot_[at(first(column) + t)] = pivot;
    diagonal = inverse;
  }
  return least;
}

template <typename T>
void BlockMatrixOf<T>::solve(std::vector<T>& x) const {
  const int blocks = static_cast<int>(panel_.size());
  for (int c = 0; c < blocks; ++c) spread(c, x.data());
  for (int r = 0; r < size(); ++r) x[at(r)] *= inverse_pivot_[at(r)];
  for (int c = blocks - 1; c >= 0; --c) gather(c, x.data());
}

/// Forward substitution: what is known of a column's unknowns is taken out of all equations below.
template <typename T>
void BlockMatrixOf<T>::spread(int column, T* x) const {
  const int height = height_[at(column)];
  const int* equations = equations_.data() + list_[at(column)];
  const T* values = values_.data() + panel_[at(column)];
  for (int s = 0; s < rows_of(column); ++s, values += height) {
    const T known = x[first(column) + s];
    if (in_runs_[at(column)]) {
      for_each_run(start_[at(column)], s + 1, [&](int row, int offset, int count) {
        for (int k = 0; k < count; ++k) x[row + k] -= values[offset + k] * known;
      });
    } else {
      for (int k = s + 1; k < height; ++k) x[equations[k]] -= values[k] * known;
    }
  }
}

/// Backward substitution: a column's unknowns from all below.
template <typename T>
void BlockMatrixOf<T>::gather(int column, T* x) const {
  const int height = height_[at(column)];
  const int* equations = equations_.data() + list_[at(column)];
  for (int s = rows_of(column) - 1; s >= 0; --s) {
    const T* values = values_.data() + panel_[at(column)] + s * height;
    T sum = 0;
    if (in_runs_[at(column)]) {
      for_each_run(start_[at(column)], s + 1,
                   [&](int row, int offset, int count) { sum += dot_product(values + offset, x + row, count); });
    } else {
      for (int k = s + 1; k < height; ++k) sum += values[k] * x[equations[k]];
    }
    x[first(column) + s] -= sum;
  }
}

template class BlockMatrixOf<float>;
template class BlockMatrixOf<double>;

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
