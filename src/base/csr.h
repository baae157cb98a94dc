#pragma once

#include <cstddef>
#include <span>
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

  static Csr empty(std::size_t rows) {
    Csr csr;
    csr.offset.assign(rows + 1, 0);
    return csr;
  }

  /// Groups the entries that for_each(add) names by add(row, item), twice over: first they are counted, then kept, so
  /// that no more memory is taken than the result needs. Within a row they keep their order.
  template <class ForEach>
  static Csr group(std::size_t rows, const ForEach& for_each) {
    Csr csr = empty(rows);
    for_each([&](std::size_t row, const T&) { ++csr.offset[row + 1]; });
    for (std::size_t i = 0; i < rows; ++i) csr.offset[i + 1] += csr.offset[i];
    csr.items.resize(csr.offset.back());
    std::vector<std::size_t> next(csr.offset.begin(), csr.offset.end() - 1);
    for_each([&](std::size_t row, const T& item) { csr.items[next[row]++] = item; });
    return csr;
  }
};

}  // namespace repose
