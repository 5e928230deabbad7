// The product of a chain's transforms. In a sequential product, each step depends on the one before. So the products of
// the lower and the upper half are computed in parallel, in the two elements of a vector register. With a sequential
// product, a humanoid's lookup takes 24 % longer, and one of depth 50 39 %: benchmarks/native, "chain product".
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "tf2/transform.hpp"

namespace tfloom::tf2 {

// Collects links from the bottom up: each is multiplied to the left of those before it.
class ChainProduct {
 public:
  void push(const Transform& link) {
    if (count_ == max_links) fold();
    std::construct_at(links() + count_++, link);
  }
  void clear() { count_ = 0; }

  [[nodiscard]] Transform value() {
    if (count_ == 0) return {};
    if (count_ > 1) fold();
    return *links();
  }

 private:
  static constexpr std::size_t max_links = 32;

  void fold();  // replace the links by their product
  [[nodiscard]] Transform* links() { return reinterpret_cast<Transform*>(storage_.data()); }

  // Raw storage, so that unused elements are not initialised with identities.
  alignas(Transform) std::array<std::byte, max_links * sizeof(Transform)> storage_;
  std::size_t count_ = 0;
};

}  // namespace tfloom::tf2
