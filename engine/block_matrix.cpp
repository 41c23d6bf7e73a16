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

/// Columns whose blocks stand in runs of so many on average are taken run by run, which the machine's vectors like;
/// where runs are shorter, row by row is faster.
constexpr int long_run = 4;

/// Up to so many equations loops are so short that what surrounds them is the price.
constexpr int most_few = 96;

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
  work_ = entries_ = 0;
  for (int c = 0; c < static_cast<int>(below.size()); ++c) {
    const std::vector<int>& rows = below[at(c)];
    double height = 0.5 * most_rows[at(c)];
    row_.push_back(c);
    for (const int row : rows) {
      height += most_rows[at(row)];
      beside_[at(row)].push_back(static_cast<int>(row_.size()));
      row_.push_back(row);
    }
    work_ += 0.5 * most_rows[at(c)] * height * height;
    entries_ += most_rows[at(c)] * height;
    if (work_ > most_work) return false;
    column_.resize(row_.size(), c);
    start_.push_back(static_cast<int>(row_.size()));
    if (!rows.empty()) below[at(rows.front())] = merged(below[at(rows.front())], {rows.begin() + 1, rows.end()});
  }
  find_runs();
  resize(most_rows);
  return true;
}

template <typename T>
void BlockMatrixOf<T>::find_runs() {
  run_end_.resize(row_.size());
  in_runs_.assign(beside_.size(), false);
  for (int c = 0; c < static_cast<int>(beside_.size()); ++c) {
    int runs = 0;
    for (int p = start_[at(c) + 1] - 1; p >= start_[at(c)]; --p) {
      const bool ends = p + 1 == start_[at(c) + 1] || row_[at(p) + 1] != row_[at(p)] + 1;
      run_end_[at(p)] = ends ? p + 1 : run_end_[at(p) + 1];
      runs += ends;
    }
    in_runs_[at(c)] = start_[at(c) + 1] - start_[at(c)] >= long_run * runs;
  }
}

template <typename T>
void BlockMatrixOf<T>::resize(const std::vector<int>& rows) {
  panels_.assign(1, {});
  for (const int count : rows) {
    panels_.back().width = count;
    panels_.push_back({panels_.back().first + count});
  }
  offset_.resize(row_.size());
  equations_.clear();
  std::size_t used = 0;
  int widest = 0;
  for (int c = 0; c < static_cast<int>(rows.size()); ++c) {
    Panel& panel = panels_[at(c)];
    panel.begin = used;
    panel.list = equations_.size();
    for (int p = start_[at(c)]; p < start_[at(c) + 1]; ++p) {
      offset_[at(p)] = panel.height;
      panel.height += rows[at(row_[at(p)])];
      for (int r = first(row_[at(p)]); r < first(row_[at(p)] + 1); ++r) equations_.push_back(r);
    }
    used += at(panel.height) * at(panel.width);
    widest = std::max(widest, panel.width);
  }
  values_.assign(used, 0);
  pivot_.resize(at(size()));
  inverse_pivot_.resize(at(size()));
  updates_.assign(at(size()) * at(widest), 0);
  threes_ = std::all_of(rows.begin(), rows.end(), [](int count) { return count == 3; });
  few_ = size() <= most_few && !threes_;
  if (few_) find_meeting_rows();
}

template <typename T>
void BlockMatrixOf<T>::find_meeting_rows() {
  meeting_.clear();
  meets_.resize(row_.size());
  int standing[most_few] = {};  // of each equation, in the panel
  for (int c = 0; c < static_cast<int>(beside_.size()); ++c) {
    const Panel& panel = panels_[at(c)];
    for (int k = 0; k < panel.height; ++k) standing[equations_of(panel)[k]] = k;
    for (const int place : beside_[at(c)]) {
      const Panel& source = panels_[at(column_[at(place)])];
      meets_[at(place)] = static_cast<int>(meeting_.size());
      for (int k = offset_[at(place)]; k < source.height; ++k) meeting_.push_back(standing[equations_of(source)[k]]);
    }
  }
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
  for (const Panel& panel : panels_) {
    for (int i = 0; i < panel.width; ++i) values_[panel.begin + at(i) * at(panel.height + 1)] *= factor;
  }
}

/// Visits the rows of a column from `skip` rows below the upper edge of the block at `place` on, by runs of consecutive
/// equations: visit(first equation, offset in the panel, count).
template <typename T>
template <typename Visit>
void BlockMatrixOf<T>::for_each_run(int place, int skip, Visit&& visit) const {
  const int end = start_[at(column_[at(place)]) + 1];
  for (int p = place; p < end; p = run_end_[at(p)], skip = 0) {
    const int row = first(row_[at(p)]) + skip;
    visit(row, offset_[at(p)] + skip, first(row_[at(run_end_[at(p)] - 1)] + 1) - row);
  }
}

template <typename T>
T BlockMatrixOf<T>::factor() {
  T least = 1;
  for (int c = 0; c + 1 < static_cast<int>(panels_.size()); ++c) {
    const Panel& panel = panels_[at(c)];
    // Until the panel is factored, the diagonal as it was waits where the inverse pivots will be.
    for (int t = 0; t < panel.width; ++t)
      inverse_pivot_[at(panel.first + t)] = values_[panel.begin + at(t) * at(panel.height + 1)];
    for (const int place : beside_[at(c)]) few_ ? subtract_few(place) : subtract_what_follows_from(place);
    if (!beside_[at(c)].empty()) few_ ? take_few(panel) : take_updates(panel);
    least = std::min(least, factor_panel(panel));
  }
  return least;
}

/// As below, the same sums in the same order.
template <typename T>
void BlockMatrixOf<T>::subtract_few(int place) {
  const Panel& source = panels_[at(column_[at(place)])];
  const Panel& target = panels_[at(row_[at(place)])];
  const int* rows = meeting_.data() + meets_[at(place)];
  const int count = source.height - offset_[at(place)];
  const bool pairs = in_runs_[at(column_[at(place)])];
  for (int s = 0; s < source.width; ++s) {
    const T* a = values_.data() + source.begin + at(s) * at(source.height) + at(offset_[at(place)]);
    const T* b = a + source.height;
    const T pivot = pivot_[at(source.first + s)];
    T* sums = updates_.data();
    if (pairs && s + 1 < source.width) {
      const T next_pivot = pivot_[at(source.first + ++s)];
      for (int t = 0; t < target.width; ++t, sums += target.height) {
        const T of_a = a[t] * pivot;
        const T of_b = b[t] * next_pivot;
        for (int k = t; k < count; ++k) sums[rows[k]] += of_a * a[k] + of_b * b[k];
      }
      continue;
    }
    for (int t = 0; t < target.width; ++t, sums += target.height) {
      const T factor = a[t] * pivot;
      for (int k = t; k < count; ++k) sums[rows[k]] += factor * a[k];
    }
  }
}

template <typename T>
void BlockMatrixOf<T>::take_few(const Panel& panel) {
  T* __restrict values = values_.data() + panel.begin;
  T* __restrict updates = updates_.data();
  const int count = panel.width * panel.height;
  for (int k = 0; k < count; ++k) {
    values[k] -= updates[k];
    updates[k] = 0;
  }
}

/// What eliminating the column of the block at `place` does to the column of the block's row.
template <typename T>
void BlockMatrixOf<T>::subtract_what_follows_from(int place) {
  if (threes_) return in_runs_[at(column_[at(place)])] ? subtract_threes<true>(place) : subtract_threes<false>(place);
  if (in_runs_[at(column_[at(place)])]) return subtract_in_runs(place);
  const Panel source = panels_[at(column_[at(place)])];
  const int begin = offset_[at(place)];
  const int end = begin + panels_[at(row_[at(place)])].width;
  const int* equations = equations_of(source);
  const T* values = values_.data() + source.begin;
  for (int s = 0; s < source.width; ++s, values += source.height) {
    const T pivot = pivot_[at(source.first + s)];
    T* updates = updates_.data();
    for (int t = begin; t < end; ++t, updates += size()) {
      const T factor = values[t] * pivot;
      for (int k = t; k < source.height; ++k) updates[equations[k]] += factor * values[k];
    }
  }
}

/// The same, two columns at a time, so that the sums are loaded half as often.
template <typename T>
void BlockMatrixOf<T>::subtract_in_runs(int place) {
  const Panel source = panels_[at(column_[at(place)])];
  const int begin = offset_[at(place)];
  const int width = panels_[at(row_[at(place)])].width;
  for (int s = 0; s < source.width; s += 2) {
    const bool pair = s + 1 < source.width;
    const T* a = values_.data() + source.begin + at(s) * at(source.height);
    const T* b = pair ? a + source.height : a;
    for (int t = 0; t < width; ++t) {
      const T of_a = a[begin + t] * pivot_[at(source.first + s)];
      const T of_b = pair ? b[begin + t] * pivot_[at(source.first + s + 1)] : 0;
      for_each_run(place, t, [&](int row, int offset, int count) {
        T* __restrict sum = updates_.data() + at(t) * at(size()) + row;
        for (int k = 0; k < count; ++k) sum[k] += of_a * a[offset + k] + of_b * b[offset + k];
      });
    }
  }
}

/// The same where all blocks have three rows: nine products for every three entries that are loaded, and three sums.
template <typename T>
template <bool in_runs>
void BlockMatrixOf<T>::subtract_threes(int place) {
  const Panel& source = panels_[at(column_[at(place)])];
  const T* __restrict a = values_.data() + source.begin;
  const T* __restrict b = a + source.height;
  const T* __restrict c = b + source.height;
  const int top = offset_[at(place)];
  T of_a[3];
  T of_b[3];
  T of_c[3];
  for (int t = 0; t < 3; ++t) {
    of_a[t] = a[top + t] * pivot_[at(source.first)];
    of_b[t] = b[top + t] * pivot_[at(source.first + 1)];
    of_c[t] = c[top + t] * pivot_[at(source.first + 2)];
  }
  T* __restrict first_sums = updates_.data();
  T* __restrict second_sums = first_sums + size();
  T* __restrict third_sums = second_sums + size();
  const auto subtract = [&](int row, int offset, int count) {
    for (int k = 0; k < count; ++k) {
      const T in_a = a[offset + k];
      const T in_b = b[offset + k];
      const T in_c = c[offset + k];
      first_sums[row + k] += of_a[0] * in_a + of_b[0] * in_b + of_c[0] * in_c;
      second_sums[row + k] += of_a[1] * in_a + of_b[1] * in_b + of_c[1] * in_c;
      third_sums[row + k] += of_a[2] * in_a + of_b[2] * in_b + of_c[2] * in_c;
    }
  };
  if constexpr (in_runs) {
    for_each_run(place, 0, subtract);
  } else {
    const int end = start_[at(column_[at(place)]) + 1];
    for (int p = place; p < end; ++p) subtract(first(row_[at(p)]), offset_[at(p)], 3);
  }
}

template <typename T>
void BlockMatrixOf<T>::take_updates(const Panel& panel) {
  const int* equations = equations_of(panel);
  for (int t = 0; t < panel.width; ++t) {
    T* values = values_.data() + panel.begin + at(t) * at(panel.height);
    T* updates = updates_.data() + at(t) * at(size());
    for (int k = threes_ ? 0 : t; k < panel.height; ++k) values[k] -= std::exchange(updates[equations[k]], T(0));
  }
}

/// Eliminates within one panel, column by column. Returns its least relative pivot.
template <typename T>
T BlockMatrixOf<T>::factor_panel(const Panel& panel) {
  if (panel.width == 1) return factor_narrow<1>(panel);
  if (panel.width == 2) return factor_narrow<2>(panel);
  if (panel.width == 3) return factor_narrow<3>(panel);
  const T negligible = 64 * std::numeric_limits<T>::epsilon();
  T least = 1;
  const int height = panel.height;
  for (int t = 0; t < panel.width; ++t) {
    T* values = values_.data() + panel.begin + at(t) * at(height);
    const T pivot = values[t];
    T& diagonal = inverse_pivot_[at(panel.first + t)];
    if (pivot < least * diagonal) least = pivot / diagonal;
    const T inverse = pivot > negligible * diagonal ? 1 / pivot : 0;
    T* __restrict other = values;
    for (int u = t + 1; u < panel.width; ++u) {
      other += height;
      const T factor = values[u] * inverse;
      for (int k = u; k < height; ++k) other[k] -= factor * values[k];
    }
    for (int k = t + 1; k < height; ++k) values[k] *= inverse;
    pivot_[at(panel.first + t)] = pivot;
    diagonal = inverse;
  }
  return least;
}

/// The same with a width that the compiler knows: most joints have two rows, or three.
template <typename T>
template <int width>
T BlockMatrixOf<T>::factor_narrow(const Panel& panel) {
  const T negligible = 64 * std::numeric_limits<T>::epsilon();
  T least = 1;
  const int height = panel.height;
  T* values = values_.data() + panel.begin;
  T inverses[width];
  T below[width][width];  // the diagonal: of row and column
  for (int t = 0; t < width; ++t) {
    T* column = values + t * height;
    const T pivot = column[t];
    T& diagonal = inverse_pivot_[at(panel.first + t)];
    if (pivot < least * diagonal) least = pivot / diagonal;
    const T inverse = pivot > negligible * diagonal ? 1 / pivot : 0;
    for (int u = t + 1; u < width; ++u) {
      below[u][t] = column[u] * inverse;
      for (int k = u; k < width; ++k) values[u * height + k] -= below[u][t] * column[k];
    }
    for (int u = t + 1; u < width; ++u) column[u] = below[u][t];
    pivot_[at(panel.first + t)] = pivot;
    inverses[t] = diagonal = inverse;
  }
  for (int k = width; k < height; ++k) {
    T row[width];
    for (int t = 0; t < width; ++t) {
      row[t] = values[t * height + k];
      for (int u = 0; u < t; ++u) row[t] -= below[t][u] * row[u];
    }
    for (int t = 0; t < width; ++t) values[t * height + k] = row[t] * inverses[t];
  }
  return least;
}

template <typename T>
void BlockMatrixOf<T>::solve(std::vector<T>& x) const {
  const int columns = static_cast<int>(in_runs_.size());
  for (int c = 0; c < columns; ++c)
    in_runs_[at(c)] && !few_ ? spread_in_runs(c, x.data()) : spread(panels_[at(c)], x.data());
  for (int r = 0; r < size(); ++r) x[at(r)] *= inverse_pivot_[at(r)];
  for (int c = columns - 1; c >= 0; --c)
    in_runs_[at(c)] ? gather_in_runs(c, x.data()) : gather(panels_[at(c)], x.data());
}

/// Forward substitution: what is known of a column's unknowns is taken out of all equations below.
template <typename T>
void BlockMatrixOf<T>::spread(const Panel& panel, T* x) const {
  if (panel.width == 2) return spread_narrow<2>(panel, x);
  if (panel.width == 3) return spread_narrow<3>(panel, x);
  const int* equations = equations_of(panel);
  const T* values = values_.data() + panel.begin;
  const int height = panel.height;
  for (int s = 0; s < panel.width; ++s, values += height) {
    const T known = x[panel.first + s];
    for (int k = s + 1; k < height; ++k) x[equations[k]] -= values[k] * known;
  }
}

template <typename T>
template <int width>
void BlockMatrixOf<T>::spread_narrow(const Panel& panel, T* x) const {
  const int* equations = equations_of(panel);
  const T* values = values_.data() + panel.begin;
  const int height = panel.height;
  T known[width];
  for (int s = 0; s < width; ++s) {
    known[s] = x[panel.first + s];
    for (int before = 0; before < s; ++before) known[s] -= values[before * height + s] * known[before];
    x[panel.first + s] = known[s];
  }
  for (int k = width; k < height; ++k) {
    T sum = x[equations[k]];
    for (int s = 0; s < width; ++s) sum -= values[s * height + k] * known[s];
    x[equations[k]] = sum;
  }
}

template <typename T>
void BlockMatrixOf<T>::spread_in_runs(int column, T* x) const {
  const Panel& panel = panels_[at(column)];
  const T* values = values_.data() + panel.begin;
  if (threes_) return spread_threes(column, x);
  for (int s = 0; s < panel.width; ++s, values += panel.height) {
    const T known = x[panel.first + s];
    for_each_run(start_[at(column)], s + 1, [&](int row, int offset, int count) {
      for (int k = 0; k < count; ++k) x[row + k] -= values[offset + k] * known;
    });
  }
}

template <typename T>
void BlockMatrixOf<T>::spread_threes(int column, T* x) const {
  const Panel& panel = panels_[at(column)];
  const T* a = values_.data() + panel.begin;
  const T* b = a + panel.height;
  const T* c = b + panel.height;
  const T first_known = x[panel.first];
  const T second_known = x[panel.first + 1] -= a[1] * first_known;
  const T third_known = x[panel.first + 2] -= a[2] * first_known + b[2] * second_known;
  for_each_run(start_[at(column)], 3, [&](int row, int offset, int count) {
    T* __restrict below = x + row;
    for (int k = 0; k < count; ++k)
      below[k] -= a[offset + k] * first_known + b[offset + k] * second_known + c[offset + k] * third_known;
  });
}

/// Backward substitution: a column's unknowns from all below.
template <typename T>
void BlockMatrixOf<T>::gather(const Panel& panel, T* x) const {
  if (threes_) return gather_threes(panel, x);
  if (few_ && panel.width == 2) return gather_narrow<2>(panel, x);
  if (few_ && panel.width == 3) return gather_narrow<3>(panel, x);
  const int* equations = equations_of(panel);
  const int height = panel.height;
  const T* values = values_.data() + panel.begin + at(panel.width) * at(height);
  for (int s = panel.width - 1; s >= 0; --s) {
    values -= height;
    T sum = x[panel.first + s];
    for (int k = s + 1; k < height; ++k) sum -= values[k] * x[equations[k]];
    x[panel.first + s] = sum;
  }
}

template <typename T>
template <int width>
void BlockMatrixOf<T>::gather_narrow(const Panel& panel, T* x) const {
  const int height = panel.height;
  const int* equations = equations_of(panel);
  T below[most_few];
  for (int k = width; k < height; ++k) below[k] = x[equations[k]];
  const T* values = values_.data() + panel.begin + at((width - 1) * height);
  for (int s = width - 1; s >= 0; --s, values -= height) {
    T sum = x[panel.first + s];
    for (int k = s + 1; k < width; ++k) sum -= values[k] * x[panel.first + k];
    for (int k = width; k < height; ++k) sum -= values[k] * below[k];
    x[panel.first + s] = sum;
  }
}

template <typename T>
void BlockMatrixOf<T>::gather_threes(const Panel& panel, T* x) const {
  const int* equations = equations_of(panel);
  const T* a = values_.data() + panel.begin;
  const T* b = a + panel.height;
  const T* c = b + panel.height;
  T of_a = 0;
  T of_b = 0;
  T of_c = 0;
  for (int k = 3; k < panel.height; k += 3) {
    const T* block = x + equations[k];
    of_a += a[k] * block[0] + a[k + 1] * block[1] + a[k + 2] * block[2];
    of_b += b[k] * block[0] + b[k + 1] * block[1] + b[k + 2] * block[2];
    of_c += c[k] * block[0] + c[k + 1] * block[1] + c[k + 2] * block[2];
  }
  T* own = x + panel.first;
  own[2] -= of_c;
  own[1] -= of_b + b[2] * own[2];
  own[0] -= of_a + a[1] * own[1] + a[2] * own[2];
}

template <typename T>
void BlockMatrixOf<T>::gather_in_runs(int column, T* x) const {
  const Panel& panel = panels_[at(column)];
  for (int s = panel.width - 1; s >= 0; --s) {
    const T* values = values_.data() + panel.begin + at(s) * at(panel.height);
    for_each_run(start_[at(column)], s + 1, [&](int row, int offset, int count) {
      x[panel.first + s] -= dot_product(values + offset, x + row, count);
    });
  }
}

template class BlockMatrixOf<float>;
template class BlockMatrixOf<double>;

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
