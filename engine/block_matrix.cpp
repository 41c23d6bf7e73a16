#include "engine/block_matrix.h"

#include <algorithm>
#include <iterator>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// Columns whose blocks stand in runs of so many on average are taken run by run, which the machine's vectors like;
/// where runs are shorter, row by row is faster.
constexpr int long_run = 4;

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
  const auto all_have = [&](int wanted) {
    return std::all_of(rows.begin(), rows.end(), [wanted](int count) { return count == wanted; });
  };
  alike_ = all_have(2) ? 2 : all_have(3) ? 3 : 0;
  few_ = size() <= most_few && alike_ != 3;
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

template bool BlockMatrixOf<float>::plan(std::vector<std::vector<int>>, const std::vector<int>&, double);
template bool BlockMatrixOf<double>::plan(std::vector<std::vector<int>>, const std::vector<int>&, double);
template void BlockMatrixOf<float>::resize(const std::vector<int>&);
template void BlockMatrixOf<double>::resize(const std::vector<int>&);
template void BlockMatrixOf<float>::clear();
template void BlockMatrixOf<double>::clear();
template int BlockMatrixOf<float>::place_of(int, int) const;
template int BlockMatrixOf<double>::place_of(int, int) const;
template void BlockMatrixOf<float>::stretch_diagonal(float);
template void BlockMatrixOf<double>::stretch_diagonal(double);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
