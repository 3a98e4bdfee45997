// Cell-linked neighbour search. Cells are half as wide as the kernel's support plus a skin and
// stored row by row, so a particle's neighbours are five runs of sources, one in each of the five
// rows around it, five cells long: contiguous memory for the pair loops. The skin keeps a grid
// valid until some particle has moved half of it against the tank.
#pragma once

#include <array>
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
  static constexpr int reach_in_cells = 2;
  static constexpr int runs = 2 * reach_in_cells + 1;

  // Covers [min, max] in both directions, positions relative to the tank [m]; `reach` is the
  // kernel's support plus the skin [m].
  CellGrid(double min_x, double max_x, double min_z, double max_z, double reach)
      : min_x_(min_x), min_z_(min_z), inverse_width_(reach_in_cells / reach) {
    columns_ = column(max_x) + 1 + reach_in_cells;
    rows_ = row(max_z) + 1 + reach_in_cells;
    begin_.resize(static_cast<std::size_t>(columns_) * rows_ + 1);
  }

  std::uint32_t cell(double x, double z) const {
    return static_cast<std::uint32_t>(row(z) * columns_ + column(x));
  }

  // Counting sort: the order of `keys` (cell numbers) that makes cells contiguous, stable.
  void sort(const std::vector<std::uint32_t>& keys, std::vector<std::uint32_t>& order) {
    begin_.assign(begin_.size(), 0);
    for (const std::uint32_t key : keys) ++begin_[key + 1];
    for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
    order.resize(keys.size());
    cursor_.assign(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t i = 0; i < keys.size(); ++i) order[cursor_[keys[i]]++] = i;
  }

  // The runs of sources around a cell that is not on the margin.
  std::array<IndexRange, runs> neighbourhood(std::uint32_t cell) const {
    std::array<IndexRange, runs> ranges;
    for (int r = 0; r < runs; ++r) {
      const std::int64_t middle = static_cast<std::int64_t>(cell) + (r - reach_in_cells) * columns_;
      ranges[r] = {begin_[middle - reach_in_cells], begin_[middle + reach_in_cells + 1]};
    }
    return ranges;
  }

 private:
  // An empty margin surrounds the covered cells.
  int column(double x) const {
    return static_cast<int>(std::floor((x - min_x_) * inverse_width_)) + reach_in_cells;
  }
  int row(double z) const {
    return static_cast<int>(std::floor((z - min_z_) * inverse_width_)) + reach_in_cells;
  }

  double min_x_, min_z_, inverse_width_;
  int columns_, rows_;
  std::vector<std::uint32_t> begin_, cursor_;
};

}  // namespace slosh::sph
