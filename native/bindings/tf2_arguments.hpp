// Argument types of tf2's functions (a stamp, an age, a frame's name, numbers), and the conversion of native errors to
// exceptions. Their casters accept any object, and raise a TypeError that states what was given when the value is used,
// because nanobind's own text for an object that a caster refuses is the function's signature. It does refuse None
// where an argument is not marked `.none()`.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/stl/array.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "tf2/errors.hpp"
#include "tf2/time_cache.hpp"

namespace tfloom::bindings {

// An int of nanoseconds. Raises ValueError if it does not fit into 64 bits.
struct StampArgument {
  std::int64_t value = 0;
};

// The same for an age; None, if the argument accepts it, means unlimited. Not std::optional<StampArgument>, because its
// caster must not throw.
struct AgeArgument {
  std::int64_t value = tf2::unlimited;
};

// A str, and its UTF-8, valid during the call.
struct NameArgument {
  nanobind::handle object;
  std::string_view text;
};

// The x, y, z of a position, or the x, y, z, w of a rotation.
template <std::size_t N>
struct NumbersArgument {
  std::array<double, N> values{};
};

// Raise the TypeError of an argument that is not what it must be. Takes the GIL.
[[noreturn]] void raise_wrong_argument(const char* wanted, nanobind::handle given);
[[noreturn]] void raise(const tf2::Error& error);
[[nodiscard]] nanobind::object exception_of(const tf2::Error& error);

}  // namespace tfloom::bindings

namespace nanobind::detail {

// What the casters share. Each sets `value_`, or `refused_` to the object that it was given.
template <typename Argument>
struct ArgumentCaster {
  template <typename T>
  using Cast = Argument;
  template <typename T>
  static constexpr bool can_cast() {
    return true;
  }

 protected:
  bool refuse(handle source) noexcept {
    refused_ = source;
    return true;
  }

  Argument value_;
  handle refused_;
};

template <>
struct type_caster<tfloom::bindings::StampArgument> : ArgumentCaster<tfloom::bindings::StampArgument> {
  static constexpr auto Name = const_name("int");

  bool from_python(handle source, std::uint8_t, cleanup_list*) noexcept {
    PyObject* number = source.ptr();
    if (PyLong_Check(number)) {
      value_.value = PyLong_AsLongLongAndOverflow(number, &overflow_);
      return true;
    }
    if (PyFloat_Check(number) || !PyIndex_Check(number)) return refuse(source);
    number = PyNumber_Index(number);
    if (!number) {
      PyErr_Clear();
      return refuse(source);
    }
    value_.value = PyLong_AsLongLongAndOverflow(number, &overflow_);
    Py_DECREF(number);
    return true;
  }

  explicit operator tfloom::bindings::StampArgument() {
    if (refused_) {
      tfloom::bindings::raise_wrong_argument(
          "a stamp must be an int of nanoseconds, as int(seconds * 1e9) or a Time's nanoseconds", refused_);
    }
    if (overflow_ != 0) {
      throw nanobind::value_error("a stamp must fit into 64 bits of nanoseconds: years 1677 to 2262");
    }
    return value_;
  }

 protected:
  int overflow_ = 0;
};

template <>
struct type_caster<tfloom::bindings::AgeArgument> : type_caster<tfloom::bindings::StampArgument> {
  using Base = type_caster<tfloom::bindings::StampArgument>;
  static constexpr auto Name = const_name("int");  // `.none()` adds None
  template <typename T>
  using Cast = tfloom::bindings::AgeArgument;

  bool from_python(handle source, std::uint8_t flags, cleanup_list* cleanup) noexcept {
    is_none_ = source.is_none();
    return is_none_ || Base::from_python(source, flags, cleanup);
  }

  explicit operator tfloom::bindings::AgeArgument() {
    if (is_none_) return {};
    if (refused_) {
      tfloom::bindings::raise_wrong_argument(
          "a cache's time must be an int of nanoseconds, as int(seconds * 1e9) or a Duration's nanoseconds", refused_);
    }
    if (overflow_ != 0) throw nanobind::value_error("a time must fit into 64 bits of nanoseconds: 292 years");
    return {value_.value};
  }

 private:
  bool is_none_ = false;
};

template <>
struct type_caster<tfloom::bindings::NameArgument> : ArgumentCaster<tfloom::bindings::NameArgument> {
  static constexpr auto Name = const_name("str");

  bool from_python(handle source, std::uint8_t, cleanup_list*) noexcept {
    if (!PyUnicode_Check(source.ptr())) return refuse(source);
    Py_ssize_t size = 0;
    const char* text = PyUnicode_AsUTF8AndSize(source.ptr(), &size);
    if (!text) {
      PyErr_Clear();
      return true;
    }
    value_ = {source, {text, static_cast<std::size_t>(size)}};
    return true;
  }

  explicit operator tfloom::bindings::NameArgument() {
    if (refused_) tfloom::bindings::raise_wrong_argument("the name of a frame or a publisher must be a str", refused_);
    if (!value_.object) throw nanobind::value_error("a frame's name must be valid Unicode, without lone surrogates");
    return value_;
  }
};

template <std::size_t N>
struct type_caster<tfloom::bindings::NumbersArgument<N>> : ArgumentCaster<tfloom::bindings::NumbersArgument<N>> {
  using Numbers = make_caster<std::array<double, N>>;
  static constexpr auto Name = Numbers::Name;

  bool from_python(handle source, std::uint8_t flags, cleanup_list* cleanup) noexcept {
    return numbers_.from_python(source, flags, cleanup) || this->refuse(source);
  }

  explicit operator tfloom::bindings::NumbersArgument<N>() {
    static_assert(N == 3 || N == 4);
    if (this->refused_) {
      tfloom::bindings::raise_wrong_argument(
          N == 3 ? "a translation must be three numbers, x, y, z" : "a rotation must be four numbers, x, y, z, w",
          this->refused_);
    }
    return {numbers_.value};
  }

 private:
  Numbers numbers_;
};

}  // namespace nanobind::detail
