// A grid that sorts points into narrow cells: rows are some particles high, columns a fraction of a
// particle wide. In this order consecutive particles form compact clusters (cluster_lists.hpp), and
// the points within a given reach form one contiguous run in each of a few rows.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace slosh::sph {

struct IndexRange {
  std::size_t begin, end;
};

class CellGrid {
 public:
  // The grid covers [min, max] in both directions; positions are relative to the tank [m].
  CellGrid(double min_x, double max_x, double min_z, double max_z, double cell_width,
           double cell_height)
      : min_x_(min_x),
        min_z_(min_z),
        columns_per_length_(1 / cell_width),
        rows_per_length_(1 / cell_height),
        columns_(static_cast<int>((max_x - min_x) * columns_per_length_) + 1),
        rows_(static_cast<int>((max_z - min_z) * rows_per_length_) + 1),
        begin_(static_cast<std::size_t>(columns_) * rows_ + 2) {}

  // A point outside the grid belongs to the nearest cell.
  int column(double x) const { return clamped((x - min_x_) * columns_per_length_, columns_); }
  int row(double z) const { return clamped((z - min_z_) * rows_per_length_, rows_); }
  std::uint32_t cell(double x, double z) const {
    return static_cast<std::uint32_t>(row(z) * columns_ + column(x));
  }

  // Computes the stable order of `keys` (cell numbers) in which cells are contiguous, by a counting
  // sort.
  void sort(const std::vector<std::uint32_t>& keys, std::vector<std::uint32_t>& order) {
    begin_.assign(begin_.size(), 0);
    for (const std::uint32_t key : keys) ++begin_[key + 2];
    for (std::size_t c = 2; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
    order.resize(keys.size());
    // begin_[key + 1] grows from the cell's begin to its end, which is the begin of the next cell.
    for (std::uint32_t i = 0; i < keys.size(); ++i) order[begin_[keys[i] + 1]++] = i;
  }

  // Returns the points that the last sort put into the columns `from` to `to` of a row.
  IndexRange run(int row, int from, int to) const {
    const std::uint32_t* cells = begin_.data() + static_cast<std::size_t>(row) * columns_;
    return {cells[from], cells[to + 1]};
  }
  template <class Visit>
  void for_each_named_field(const Visit& visit) {
    visit("cells", begin_);
  }
  int columns() const { return columns_; }
  int rows() const { return rows_; }

 private:
  static int clamped(double cells, int count) {
    return static_cast<int>(std::clamp(cells, 0.0, count - 1.0));
  }

  double min_x_, min_z_, columns_per_length_, rows_per_length_;
  int columns_, rows_;
  std::vector<std::uint32_t> begin_;
};

}  // namespace slosh::sph
