// The errors of a query, as values. Their texts are those of tf2.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>

namespace tfloom::tf2 {

using Stamp = std::int64_t;  // ns since epoch

inline constexpr Stamp latest = 0;  // in a query: the newest time at which the whole chain is known

// The numbers of tf2_msgs/TF2Error, and three of tf2's own that split "extrapolation".
enum class Code : std::uint8_t {
  ok = 0,
  lookup = 1,
  connectivity = 2,
  extrapolation = 3,
  invalid_argument = 4,
  timeout = 5,
  transform = 6,
  backward = 7,
  forward = 8,
  no_data = 9,
};

struct Error {
  Code code = Code::transform;
  std::string text{};
  // For a failed extrapolation: the frame, the requested stamp, and the range of the frame's history.
  std::string frame{};
  Stamp requested = 0;
  Stamp oldest = 0;
  Stamp newest = 0;

  [[nodiscard]] bool is_extrapolation() const {
    return code == Code::backward || code == Code::forward || code == Code::no_data;
  }
};

template <class T>
class Result {
 public:
  Result(T value) : outcome_(std::in_place_index<0>, std::move(value)) {}      // NOLINT: reads as `return value`
  Result(Error error) : outcome_(std::in_place_index<1>, std::move(error)) {}  // NOLINT

  explicit operator bool() const { return outcome_.index() == 0; }
  const T& operator*() const { return *std::get_if<0>(&outcome_); }
  const T* operator->() const { return std::get_if<0>(&outcome_); }
  [[nodiscard]] const Error& error() const { return *std::get_if<1>(&outcome_); }

 private:
  std::variant<T, Error> outcome_;
};

}  // namespace tfloom::tf2
