// The product of a chain's transforms, computed sequentially.
#pragma once

#include "tf2/transform.hpp"

namespace tfloom::tf2 {

class ChainProduct {
 public:
  void push(const Transform& link) {
    value_ = is_empty_ ? link : link * value_;
    is_empty_ = false;
  }
  void clear() { *this = {}; }
  [[nodiscard]] Transform value() const { return value_; }

 private:
  Transform value_;
  bool is_empty_ = true;
};

}  // namespace tfloom::tf2
