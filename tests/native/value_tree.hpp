// The plainest builder and reader of the codec: messages as trees of C++ values.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "cdr/message_codec.hpp"

namespace tfloom::cdr {

struct Tree {
  using Bytes = std::vector<std::byte>;  // numbers, in host order

  std::variant<bool, std::uint64_t, double, std::string, std::u32string, Bytes, std::vector<Tree>> value;
};

class TreeBuilder {
 public:
  using Value = Tree;

  Value message(const Plan& plan) { return {std::vector<Tree>(plan.fields.size())}; }
  void set(Value& message, const Plan&, std::size_t index, Value value) {
    std::get<std::vector<Tree>>(message.value)[index] = std::move(value);
  }
  void finish(Value&, const Plan&) {}
  void finish_list(Value&) {}
  Value boolean(bool value) { return {value}; }
  Value octet(std::uint8_t value) { return {std::uint64_t{value}}; }
  template <class T>
  Value number(T value) {
    if constexpr (std::is_floating_point_v<T>) return {static_cast<double>(value)};
    return {static_cast<std::uint64_t>(value)};
  }
  Value string(std::string_view text, std::size_t) { return {std::string(text)}; }
  Value wide(std::u32string_view text) { return {std::u32string(text)}; }
  template <class T>
  Value numbers(const Plan&, std::size_t, Cursor& in, std::uint32_t length) {
    in.require(length, sizeof(T));
    std::vector<T> numbers(length);
    in.read_into(std::span<T>(numbers));
    const auto* from = reinterpret_cast<const std::byte*>(numbers.data());
    return {Tree::Bytes(from, from + length * sizeof(T))};
  }
  Value list(std::uint32_t length) { return {std::vector<Tree>(length)}; }
  void set_item(Value& list, std::uint32_t index, Value value) {
    std::get<std::vector<Tree>>(list.value)[index] = std::move(value);
  }
};

class TreeReader {
 public:
  using Value = const Tree*;
  using Held = const Tree*;

  Value field(Held message, const Plan&, std::size_t index) { return item(message, index); }
  Held open(Value value, const Plan&) { return value; }
  bool boolean(Value value) { return std::get<bool>(value->value); }
  std::uint8_t octet(Value value) { return number<std::uint8_t>(value); }
  template <class T>
  T number(Value value) {
    if constexpr (std::is_floating_point_v<T>) return static_cast<T>(std::get<double>(value->value));
    return static_cast<T>(std::get<std::uint64_t>(value->value));
  }
  std::string_view string(Value value) { return std::get<std::string>(value->value); }
  std::u32string wide(Value value) { return std::get<std::u32string>(value->value); }
  template <class T, class Visit>
  bool numbers(Value value, Visit&& visit) {
    visit(std::span<const std::byte>(std::get<Tree::Bytes>(value->value)));
    return true;
  }
  Held open_list(Value value) { return value; }
  std::size_t length(Held list) { return std::get<std::vector<Tree>>(list->value).size(); }
  Value item(Held list, std::size_t index) { return &std::get<std::vector<Tree>>(list->value)[index]; }
};

struct TreeStorage {
  std::vector<std::byte> bytes;

  std::span<std::byte> resize(std::size_t size) {
    bytes.resize(size);
    return bytes;
  }
};

}  // namespace tfloom::cdr
