// A column of numbers that is its own, or a view of memory that somebody else keeps until it's written to.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tfloom::tf2 {

template <class T>
class Column {
 public:
  Column() = default;
  explicit Column(std::span<const T> foreign) : data_(foreign.data()), size_(foreign.size()) {}
  Column(Column&&) noexcept = default;
  Column& operator=(Column&&) noexcept = default;
  Column(const Column&) = delete;
  Column& operator=(const Column&) = delete;
  ~Column() = default;

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t capacity() const { return owned_.capacity(); }  // of its own memory
  const T& operator[](std::size_t index) const { return data_[index]; }
  [[nodiscard]] const T& back() const { return data_[size_ - 1]; }
  [[nodiscard]] const T* begin() const { return data_; }
  [[nodiscard]] const T* end() const { return data_ + size_; }

  void insert(std::size_t index, const T& value) {
    own();
    owned_.insert(owned_.begin() + static_cast<std::ptrdiff_t>(index), value);
    refresh();
  }

  void reserve(std::size_t count) {
    own();
    owned_.reserve(count);
    refresh();
  }

  void erase_before(std::size_t index) {
    own();
    owned_.erase(owned_.begin(), owned_.begin() + static_cast<std::ptrdiff_t>(index));
    refresh();
  }

  // Takes away what is from `index` on, into a column with room for `capacity`.
  [[nodiscard]] Column take_from(std::size_t index, std::size_t capacity) {
    own();
    Column taken;
    taken.owned_.reserve(capacity);
    taken.owned_.assign(owned_.begin() + static_cast<std::ptrdiff_t>(index), owned_.end());
    taken.refresh();
    owned_.resize(index);
    refresh();
    return taken;
  }

 private:
  void own() {
    if (data_ == owned_.data()) return;
    owned_.assign(begin(), end());
    refresh();
  }
  void refresh() {
    data_ = owned_.data();
    size_ = owned_.size();
  }

  std::vector<T> owned_;
  const T* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace tfloom::tf2
