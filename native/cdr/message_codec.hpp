// Any message as CDR bytes, by its plan: `Decoder` passes decoded values to a builder, which makes a message of them;
// `Encoder` encodes the values that a reader gets from a message.
//
// A builder has a type `Value` (movable) and
//   Value message(const Plan&)                                       an empty message
//   void set(Value& message, const Plan&, std::size_t index, Value)  its field number `index`
//   Value boolean(bool)   Value octet(std::uint8_t)   Value number(T)
//   Value string(std::string_view, std::size_t offset)               throws DecodeError if it is not UTF-8
//   Value wide(std::u32string_view)
//   Value numbers<T>(const Plan&, std::size_t index, Cursor&, std::uint32_t length)
//                                                                    reads a numeric array from the cursor
//   Value list(std::uint32_t length)   void set_item(Value& list, std::uint32_t index, Value)
//   void finish(Value& message, const Plan&)   void finish_list(Value&)   called after all fields or items are set
//
// A reader has a type `Value`, valid until the next call that may run user code (`number`, `open_list`); a type `Held`,
// which keeps its contents alive; and
//   Value field(const Held& message, const Plan&, std::size_t index)
//   Held open(Value, const Plan&)                           checks that the value is a message of that plan
//   bool boolean(Value)   std::uint8_t octet(Value)   T number<T>(Value)
//   std::string_view string(Value)   std::u32string wide(Value)
//   bool numbers<T>(Value, visit)                           calls visit(span of bytes); false: not contiguous
//   Held open_list(Value)   std::size_t length(const Held&)   Value item(const Held&, std::size_t index)
// Its functions throw EncodeError.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "cdr/cursor.hpp"
#include "cdr/plan.hpp"
#include "cdr/wide.hpp"
#include "cdr/writer.hpp"

namespace tfloom::cdr {

// A value that does not fit its field. `what()` continues the path: "must be a float, got 'abc' (str)".
class EncodeError : public PathError {
 public:
  using PathError::PathError;
};

namespace detail {

// Return the number of characters of UTF-8: bytes that are not continuations.
inline std::size_t count_characters(std::string_view text) noexcept {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char octet) { return (static_cast<unsigned char>(octet) & 0xc0) != 0x80; }));
}

inline std::string exceeds(std::size_t length, const Field& field) {
  return std::to_string(length) + " elements are more than the bound of " + std::to_string(field.count);
}

inline std::string exceeds_string(std::size_t length, const Field& field) {
  return std::to_string(length) + " characters are more than the bound of " + std::to_string(field.string_bound);
}

}  // namespace detail

template <class MessageBuilder>
class Decoder {
 public:
  using Value = typename MessageBuilder::Value;

  Decoder(Cursor& in, MessageBuilder& builder) : in_(in), builder_(builder) {}

  Value message(const Plan& plan) {
    Value message = builder_.message(plan);
    for (std::size_t i = 0; i < plan.fields.size(); ++i) {
      try {
        builder_.set(message, plan, i, value(plan, i));
      } catch (PathError& error) {
        error.enter_field(plan.fields[i].name);
        throw;
      }
    }
    if (plan.is_empty()) in_.read<std::uint8_t>();
    builder_.finish(message, plan);
    return message;
  }

 private:
  Value value(const Plan& plan, std::size_t index) {
    const Field& field = plan.fields[index];
    if (field.shape == Shape::single) return single(field);
    const std::uint32_t length = this->length(field);
    if (is_number(field.kind)) {
      return with_number_type(field.kind, [&](auto number) {
        return builder_.template numbers<decltype(number)>(plan, index, in_, length);
      });
    }
    return list(field, length);
  }

  std::uint32_t length(const Field& field) {
    if (field.shape == Shape::array) {
      in_.require(field.count, field.min_element_size());
      return field.count;
    }
    const auto length = in_.read_length(field.min_element_size());
    if (field.shape == Shape::bounded && length > field.count) in_.fail(detail::exceeds(length, field));
    return length;
  }

  Value list(const Field& field, std::uint32_t length) {
    Value list = builder_.list(length);
    for (std::uint32_t i = 0; i < length; ++i) {
      try {
        builder_.set_item(list, i, single(field));
      } catch (PathError& error) {
        error.enter_element(i);
        throw;
      }
    }
    builder_.finish_list(list);
    return list;
  }

  Value single(const Field& field) {
    switch (field.kind) {
      case Kind::float64: return builder_.number(in_.read<double>());
      case Kind::message: return message(*field.message);
      case Kind::string: return string(field);
      case Kind::wstring: return wide(field);
      case Kind::boolean: return builder_.boolean(in_.read<std::uint8_t>() != 0);
      case Kind::octet: return builder_.octet(in_.read<std::uint8_t>());
      default:
        return with_number_type(field.kind,
                                [&](auto number) { return builder_.number(in_.read<decltype(number)>()); });
    }
  }

  Value string(const Field& field) {
    const std::string_view text = in_.read_string();
    if (field.string_bound != 0) check_bound(detail::count_characters(text), field);
    return builder_.string(text, in_.offset() - text.size() - 1);
  }

  Value wide(const Field& field) {
    const std::u32string text = read_wide(in_);
    if (field.string_bound != 0) check_bound(text.size(), field);
    return builder_.wide(text);
  }

  void check_bound(std::size_t characters, const Field& field) {
    if (characters > field.string_bound) in_.fail(detail::exceeds_string(characters, field));
  }

  Cursor& in_;
  MessageBuilder& builder_;
};

template <class MessageReader, class Storage>
class Encoder {
 public:
  using Value = typename MessageReader::Value;
  using Held = typename MessageReader::Held;

  Encoder(MessageReader& reader, Writer<Storage>& out) : reader_(reader), out_(out) {}

  void message(const Held& message, const Plan& plan) {
    for (std::size_t i = 0; i < plan.fields.size(); ++i) {
      try {
        value(reader_.field(message, plan, i), plan.fields[i]);
      } catch (PathError& error) {
        error.enter_field(plan.fields[i].name);
        throw;
      }
    }
    if (plan.is_empty()) out_.write(std::uint8_t{0});
  }

 private:
  void value(Value value, const Field& field) {
    if (field.shape == Shape::single) {
      single(value, field);
    } else if (!is_number(field.kind) || !contiguous(value, field)) {
      list(reader_.open_list(value), field);
    }
  }

  bool contiguous(Value value, const Field& field) {
    return with_number_type(field.kind, [&](auto number) {
      using T = decltype(number);
      return reader_.template numbers<T>(value, [&](std::span<const std::byte> bytes) {
        length(bytes.size() / sizeof(T), field);
        out_.template write_all<T>(bytes);
      });
    });
  }

  void list(const Held& list, const Field& field) {
    const std::size_t count = reader_.length(list);
    length(count, field);
    for (std::size_t i = 0; i < count; ++i) {
      try {
        single(reader_.item(list, i), field);
      } catch (PathError& error) {
        error.enter_element(i);
        throw;
      }
    }
  }

  void length(std::size_t count, const Field& field) {
    if (field.shape == Shape::array) {
      if (count == field.count) return;
      throw EncodeError("must have " + std::to_string(field.count) + " elements, got " + std::to_string(count));
    }
    if (field.shape == Shape::bounded && count > field.count) throw EncodeError(": " + detail::exceeds(count, field));
    if (count > std::numeric_limits<std::uint32_t>::max()) throw EncodeError("has more than 2^32 - 1 elements");
    out_.write(static_cast<std::uint32_t>(count));
  }

  void single(Value value, const Field& field) {
    switch (field.kind) {
      case Kind::float64: return out_.write(reader_.template number<double>(value));
      case Kind::message: return message(reader_.open(value, *field.message), *field.message);
      case Kind::string: return string(value, field);
      case Kind::wstring: return wide(value, field);
      case Kind::boolean: return out_.write(static_cast<std::uint8_t>(reader_.boolean(value)));
      case Kind::octet: return out_.write(reader_.octet(value));
      default:
        with_number_type(field.kind,
                         [&](auto number) { out_.write(reader_.template number<decltype(number)>(value)); });
    }
  }

  void string(Value value, const Field& field) {
    const std::string_view text = reader_.string(value);
    if (field.string_bound != 0) check_bound(detail::count_characters(text), field);
    if (text.size() >= std::numeric_limits<std::uint32_t>::max()) throw EncodeError("has more than 2^32 - 2 bytes");
    out_.write_string(text);
  }

  void wide(Value value, const Field& field) {
    const std::u32string text = reader_.wide(value);
    if (field.string_bound != 0) check_bound(text.size(), field);
    write_wide(out_, text);
  }

  static void check_bound(std::size_t characters, const Field& field) {
    if (characters > field.string_bound) throw EncodeError(": " + detail::exceeds_string(characters, field));
  }

  MessageReader& reader_;
  Writer<Storage>& out_;
};

}  // namespace tfloom::cdr
