// Serialized samples of libddsc.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "dds/library.hpp"

namespace tfloom::dds {

constexpr int data_kind = 2;  // of serdata with all of a sample, not its key alone
constexpr std::size_t encapsulation_size = 4;  // of the header that comes before a sample's data

// A view of a taken sample that libddsc owns, without a copy. It holds a reference to the sample, and its data is valid as
// long as this object exists.
class TakenSample {
 public:
  TakenSample(const Library& library, Serdata_* serdata)
      : library_(library), serdata_(serdata), size_(library.serdata_size(serdata)) {
    reference_ = library_.serdata_to_ser_ref(serdata_, 0, size_, &view_);
  }
  TakenSample(const TakenSample&) = delete;
  TakenSample& operator=(const TakenSample&) = delete;
  ~TakenSample() {
    library_.serdata_to_ser_unref(reference_, &view_);
    library_.serdata_unref(serdata_);
  }

  [[nodiscard]] std::span<const std::byte> data() const {
    return {static_cast<const std::byte*>(view_.iov_base), static_cast<std::size_t>(view_.iov_len)};
  }

 private:
  const Library& library_;
  Serdata_* serdata_;
  std::uint32_t size_;
  IoVec view_{};
  Serdata_* reference_ = nullptr;
};

}  // namespace tfloom::dds
