#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace repose {

/// Items grouped by row (compressed sparse rows): those of row i are items[offset[i]] to items[offset[i + 1]].
template <class T>
struct Csr {
  std::vector<std::size_t> offset = {0};
  std::vector<T> items;

  std::size_t rows() const { return offset.size() - 1; }
  std::span<const T> row(std::size_t i) const { return {items.data() + offset[i], offset[i + 1] - offset[i]}; }
  void append_row(std::span<const T> row) {
    items.insert(items.end(), row.begin(), row.end());
    offset.push_back(items.size());
  }

  /// Groups (row, item) entries; within a row they keep their order.
  static Csr group(std::size_t rows, const std::vector<std::pair<std::size_t, T>>& entries) {
    Csr csr;
    csr.offset.assign(rows + 1, 0);
    for (const auto& [row, item] : entries) ++csr.offset[row + 1];
    for (std::size_t i = 0; i < rows; ++i) csr.offset[i + 1] += csr.offset[i];
    csr.items.resize(entries.size());
    std::vector<std::size_t> next(csr.offset.begin(), csr.offset.end() - 1);
    for (const auto& [row, item] : entries) csr.items[next[row]++] = item;
    return csr;
  }

  /// Rows in a new order: row k of the result is row order[k] of this.
  Csr reordered(std::span<const std::size_t> order) const {
    Csr result;
    result.items.reserve(items.size());
    for (const std::size_t i : order) result.append_row(row(i));
    return result;
  }
};

}  // namespace repose
