// Argument types of tf2's functions (a stamp, an age, a frame's name), and the conversion of native errors to
// exceptions.
#pragma once

#include <nanobind/nanobind.h>

#include <cstdint>
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

[[noreturn]] void raise(const tf2::Error& error);
[[nodiscard]] nanobind::object exception_of(const tf2::Error& error);

}  // namespace tfloom::bindings

namespace nanobind::detail {

template <>
struct type_caster<tfloom::bindings::StampArgument> {
  static constexpr auto Name = const_name("int");
  template <typename T>
  using Cast = tfloom::bindings::StampArgument;
  template <typename T>
  static constexpr bool can_cast() {
    return true;
  }

  bool from_python(handle source, std::uint8_t, cleanup_list*) noexcept {
    PyObject* number = source.ptr();
    if (PyLong_Check(number)) {
      value_.value = PyLong_AsLongLongAndOverflow(number, &overflow_);
      return true;
    }
    if (PyFloat_Check(number) || !PyIndex_Check(number)) return false;
    number = PyNumber_Index(number);
    if (!number) {
      PyErr_Clear();
      return false;
    }
    value_.value = PyLong_AsLongLongAndOverflow(number, &overflow_);
    Py_DECREF(number);
    return true;
  }

  explicit operator tfloom::bindings::StampArgument() {
    if (overflow_ != 0) {
      throw nanobind::value_error("a stamp must fit into 64 bits of nanoseconds: years 1677 to 2262");
    }
    return value_;
  }

 protected:
  tfloom::bindings::StampArgument value_;
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
    if (overflow_ != 0) throw nanobind::value_error("a time must fit into 64 bits of nanoseconds: 292 years");
    return {value_.value};
  }

 private:
  bool is_none_ = false;
};

template <>
struct type_caster<tfloom::bindings::NameArgument> {
  static constexpr auto Name = const_name("str");
  template <typename T>
  using Cast = tfloom::bindings::NameArgument;
  template <typename T>
  static constexpr bool can_cast() {
    return true;
  }

  bool from_python(handle source, std::uint8_t, cleanup_list*) noexcept {
    if (!PyUnicode_Check(source.ptr())) return false;
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
    if (!value_.object) throw nanobind::value_error("a frame's name must be valid Unicode, without lone surrogates");
    return value_;
  }

 private:
  tfloom::bindings::NameArgument value_;
};

}  // namespace nanobind::detail
