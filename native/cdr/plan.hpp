// The codec's description of a message type: its fields in order, each with its encoding.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cdr/cursor.hpp"

namespace tfloom::cdr {

enum class Kind : std::uint8_t {
  boolean,
  octet,  // a `byte`: not a number
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64,
  string,
  wstring,
  message,
};

enum class Shape : std::uint8_t { single, array, bounded, unbounded };

struct Plan;

// An upper limit for sizes [bytes]; no sample is as large, and the product of two sizes up to it does not overflow.
constexpr std::size_t size_limit = 0xffffffff;

struct Field {
  std::string name;
  Kind kind = Kind::boolean;
  Shape shape = Shape::single;
  std::uint32_t count = 0;         // length of an array, bound of a bounded sequence
  std::uint32_t string_bound = 0;  // [characters]; 0: not bounded
  const Plan* message = nullptr;   // of Kind::message

  [[nodiscard]] std::size_t min_element_size() const noexcept;  // [bytes], without alignment
  [[nodiscard]] std::size_t min_size() const noexcept;
};

struct Plan {
  std::string name;  // "geometry_msgs/msg/Twist"
  std::vector<Field> fields;
  std::size_t min_size = 0;  // [bytes], without alignment; set by `update_min_size`

  // A message without fields is encoded as one octet.
  [[nodiscard]] bool is_empty() const noexcept { return fields.empty(); }

  void update_min_size() {
    min_size = 0;
    for (const Field& field : fields) min_size = std::min(min_size + field.min_size(), size_limit);
    min_size = std::max<std::size_t>(min_size, 1);  // limits the number of elements that a few bytes can declare
  }

  // "TransformStamped" of "geometry_msgs/msg/TransformStamped"
  [[nodiscard]] std::string_view base_name() const noexcept {
    const std::string_view whole = name;
    return whole.substr(whole.rfind('/') + 1);
  }
};

// Call `visit` with a value of the number type of a numeric kind (bytes and booleans: uint8_t).
template <class Visit>
decltype(auto) with_number_type(Kind kind, Visit&& visit) {
  switch (kind) {
    case Kind::int8: return visit(std::int8_t{});
    case Kind::int16: return visit(std::int16_t{});
    case Kind::uint16: return visit(std::uint16_t{});
    case Kind::int32: return visit(std::int32_t{});
    case Kind::uint32: return visit(std::uint32_t{});
    case Kind::int64: return visit(std::int64_t{});
    case Kind::uint64: return visit(std::uint64_t{});
    case Kind::float32: return visit(float{});
    case Kind::float64: return visit(double{});
    default: return visit(std::uint8_t{});
  }
}

constexpr bool is_number(Kind kind) noexcept { return kind >= Kind::int8 && kind <= Kind::float64; }

inline std::size_t Field::min_element_size() const noexcept {
  if (kind == Kind::message) return message->min_size;
  if (kind == Kind::string || kind == Kind::wstring) return sizeof(std::uint32_t);
  return with_number_type(kind, [](auto number) { return sizeof(number); });
}

inline std::size_t Field::min_size() const noexcept {
  if (shape == Shape::single) return min_element_size();
  if (shape != Shape::array) return sizeof(std::uint32_t);
  // Arrays of arrays can be larger than any memory. Their sizes are limited, because it is enough that they do not fit.
  return static_cast<std::size_t>(std::min<std::uint64_t>(count * std::uint64_t{min_element_size()}, size_limit));
}

}  // namespace tfloom::cdr
