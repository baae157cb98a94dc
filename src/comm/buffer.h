#pragma once

#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace repose {

/// Appends plain values to a byte buffer and reads them back in the same order.
class PackBuffer {
 public:
  explicit PackBuffer(std::vector<char>& bytes) : bytes_(bytes) {}

  template <class T>
  void put(const T& value) {
    put_all(std::span<const T>(&value, 1));
  }
  template <class T>
  void put_all(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::size_t end = bytes_.size();
    bytes_.resize(end + values.size_bytes());
    if (!values.empty()) std::memcpy(bytes_.data() + end, values.data(), values.size_bytes());
  }

 private:
  std::vector<char>& bytes_;
};

class UnpackBuffer {
 public:
  explicit UnpackBuffer(const std::vector<char>& bytes) : bytes_(bytes) {}
  bool at_end() const { return read_ == bytes_.size(); }

  template <class T>
  T get() {
    T value;
    get_all(std::span<T>(&value, 1));
    return value;
  }
  template <class T>
  std::vector<T> get_vector(std::size_t count) {
    std::vector<T> values(count);
    get_all(std::span<T>(values));
    return values;
  }

 private:
  template <class T>
  void get_all(std::span<T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (!values.empty()) std::memcpy(values.data(), bytes_.data() + read_, values.size_bytes());
    read_ += values.size_bytes();
  }

  const std::vector<char>& bytes_;
  std::size_t read_ = 0;
};

}  // namespace repose
