// A column of values in its own memory, or a view of other memory that is copied before the first write.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tfloom::tf2 {

template <class T>
class Column {
 public:
  Column() = default;
  explicit Column(std::span<const T> viewed) : data_(viewed.data()), size_(viewed.size()) {}
  Column(Column&&) noexcept = default;
  Column& operator=(Column&&) noexcept = default;
  Column(const Column&) = delete;
  Column& operator=(const Column&) = delete;
  ~Column() = default;

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t capacity() const { return owned_.capacity(); }  // of the memory that it owns
  const T& operator[](std::size_t index) const { return data_[index]; }
  [[nodiscard]] const T& back() const { return data_[size_ - 1]; }
  [[nodiscard]] const T* begin() const { return data_; }
  [[nodiscard]] const T* end() const { return data_ + size_; }

  void insert(std::size_t index, const T& value) {
    make_owned();
    owned_.insert(owned_.begin() + static_cast<std::ptrdiff_t>(index), value);
    refresh();
  }

  void append(std::span<const T> values) {
    make_owned();
    owned_.insert(owned_.end(), values.begin(), values.end());
    refresh();
  }

  void append(std::size_t count, const T& value) {
    make_owned();
    owned_.insert(owned_.end(), count, value);
    refresh();
  }

  void reserve(std::size_t count) {
    make_owned();
    owned_.reserve(count);
    refresh();
  }

  void erase_before(std::size_t index) {
    make_owned();
    owned_.erase(owned_.begin(), owned_.begin() + static_cast<std::ptrdiff_t>(index));
    refresh();
  }

  // Move the elements from `index` on into a new column that has memory for `capacity` elements.
  [[nodiscard]] Column take_from(std::size_t index, std::size_t capacity) {
    make_owned();
    Column taken;
    taken.owned_.reserve(capacity);
    taken.owned_.assign(owned_.begin() + static_cast<std::ptrdiff_t>(index), owned_.end());
    taken.refresh();
    owned_.resize(index);
    refresh();
    return taken;
  }

 private:
  void make_owned() {
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
