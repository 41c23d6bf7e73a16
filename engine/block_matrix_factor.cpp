#include "engine/block_matrix.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

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

/// As below, the same sums in the same order. Most joints have two rows, or three.
template <typename T>
void BlockMatrixOf<T>::subtract_few(int place) {
  const Panel& source = panels_[at(column_[at(place)])];
  if (source.width == 2)
    return in_runs_[at(column_[at(place)])] ? subtract_few<2, true>(place) : subtract_few<2, false>(place);
  if (source.width == 3)
    return in_runs_[at(column_[at(place)])] ? subtract_few<3, true>(place) : subtract_few<3, false>(place);
  subtract_few_of_any_width(place);
}

/// In one go over the rows for all columns of the source. `pairs`: two columns at a time are added up before they join
/// the sum.
template <typename T>
template <int width, bool pairs>
void BlockMatrixOf<T>::subtract_few(int place) {
  const Panel& source = panels_[at(column_[at(place)])];
  const Panel& target = panels_[at(row_[at(place)])];
  const int* __restrict rows = meeting_.data() + meets_[at(place)];
  const int height = source.height;
  const int count = height - offset_[at(place)];
  const T* __restrict a = values_.data() + source.begin + at(offset_[at(place)]);
  const T* pivots = pivot_.data() + source.first;
  T* __restrict sums = updates_.data();
  for (int t = 0; t < target.width; ++t, sums += target.height) {
    T factors[width];
    for (int s = 0; s < width; ++s) factors[s] = a[s * height + t] * pivots[s];
    for (int k = t; k < count; ++k) {
      T sum = sums[rows[k]];
      int s = 0;
      if constexpr (pairs) {
        for (; s + 2 <= width; s += 2) sum += factors[s] * a[s * height + k] + factors[s + 1] * a[(s + 1) * height + k];
      }
      for (; s < width; ++s) sum += factors[s] * a[s * height + k];
      sums[rows[k]] = sum;
    }
  }
}

template <typename T>
void BlockMatrixOf<T>::subtract_few_of_any_width(int place) {
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
  const bool in_runs = in_runs_[at(column_[at(place)])] != 0;
  if (alike_ == 2) return in_runs ? subtract_alike<2, true>(place) : subtract_alike<2, false>(place);
  if (alike_ == 3) return in_runs ? subtract_alike<3, true>(place) : subtract_alike<3, false>(place);
  if (in_runs) return subtract_in_runs(place);
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

/// The same where all blocks have so many rows: `width` squared products for every `width` entries that are loaded, and
/// `width` sums.
template <typename T>
template <int width, bool in_runs>
void BlockMatrixOf<T>::subtract_alike(int place) {
  const Panel& source = panels_[at(column_[at(place)])];
  const int top = offset_[at(place)];
  const T* values[width];   // of each column of the source
  T* sums[width];           // of each column of the target
  T factors[width][width];  // of each column of the source, for each of the target
  for (int t = 0; t < width; ++t) sums[t] = updates_.data() + at(t) * at(size());
  for (int s = 0; s < width; ++s) {
    values[s] = values_.data() + source.begin + at(s) * at(source.height);
    for (int t = 0; t < width; ++t) factors[s][t] = values[s][top + t] * pivot_[at(source.first + s)];
  }
  const auto subtract = [&](int row, int offset, int count) {
    for (int k = 0; k < count; ++k) {
      T in[width];
      for (int s = 0; s < width; ++s) in[s] = values[s][offset + k];
      for (int t = 0; t < width; ++t) {
        T sum = factors[0][t] * in[0];
        for (int s = 1; s < width; ++s) sum += factors[s][t] * in[s];
        sums[t][row + k] += sum;
      }
    }
  };
  if constexpr (in_runs) {
    for_each_run(place, 0, subtract);
  } else {
    const int end = start_[at(column_[at(place)]) + 1];
    for (int p = place; p < end; ++p) subtract(first(row_[at(p)]), offset_[at(p)], width);
  }
}

template <typename T>
void BlockMatrixOf<T>::take_updates(const Panel& panel) {
  const int* equations = equations_of(panel);
  for (int t = 0; t < panel.width; ++t) {
    T* values = values_.data() + panel.begin + at(t) * at(panel.height);
    T* updates = updates_.data() + at(t) * at(size());
    for (int k = alike_ > 0 ? 0 : t; k < panel.height; ++k) values[k] -= std::exchange(updates[equations[k]], T(0));
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

template float BlockMatrixOf<float>::factor();
template double BlockMatrixOf<double>::factor();

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
