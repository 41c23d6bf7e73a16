#include "engine/block_matrix.h"

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
}  // namespace

template <typename T>
void BlockMatrixOf<T>::solve(std::vector<T>& x) const {
  if (few_) return solve_few(x.data());
  const int columns = static_cast<int>(in_runs_.size());
  for (int c = 0; c < columns; ++c) in_runs_[at(c)] ? spread_in_runs(c, x.data()) : spread(panels_[at(c)], x.data());
  for (int r = 0; r < size(); ++r) x[at(r)] *= inverse_pivot_[at(r)];
  for (int c = columns - 1; c >= 0; --c)
    in_runs_[at(c)] ? gather_in_runs(c, x.data()) : gather(panels_[at(c)], x.data());
}

/// The same. Panels are so small that what leads to them is the price: so it is inlined here.
template <typename T>
void BlockMatrixOf<T>::solve_few(T* x) const {
  const int columns = static_cast<int>(in_runs_.size());
  for (int c = 0; c < columns; ++c) {
    const Panel& panel = panels_[at(c)];
    if (panel.width == 2) {
      spread_narrow<2>(panel, x);
    } else if (panel.width == 1) {
      spread_narrow<1>(panel, x);
    } else {
      spread(panel, x);
    }
  }
  for (int r = 0; r < size(); ++r) x[r] *= inverse_pivot_[at(r)];
  for (int c = columns - 1; c >= 0; --c) {
    const Panel& panel = panels_[at(c)];
    if (in_runs_[at(c)]) {
      gather_in_runs(c, x);
    } else if (panel.width == 2) {
      gather_narrow<2>(panel, x);
    } else if (panel.width == 3) {
      gather_narrow<3>(panel, x);
    } else if (panel.width == 1) {
      gather_narrow<1>(panel, x);
    } else {
      gather(panel, x);
    }
  }
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
[[gnu::always_inline]] inline void BlockMatrixOf<T>::spread_narrow(const Panel& panel, T* x) const {
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
  if (alike_ == 3) return spread_threes(column, x);
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
  if (alike_ == 3) return gather_threes(panel, x);
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
[[gnu::always_inline]] inline void BlockMatrixOf<T>::gather_narrow(const Panel& panel, T* x) const {
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

template void BlockMatrixOf<float>::solve(std::vector<float>&) const;
template void BlockMatrixOf<double>::solve(std::vector<double>&) const;

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
