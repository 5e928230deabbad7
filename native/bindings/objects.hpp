// Python messages: their plans, and the builder and the reader by which the codec makes and reads them.
#pragma once

#include <nanobind/nanobind.h>

#include <atomic>
#include <bit>
#include <forward_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bindings/message_memory.hpp"
#include "cdr/plan.hpp"
#include "cdr/message_codec.hpp"

namespace tfloom::bindings {

namespace nb = nanobind;

// A plan with the positions and defaults of the fields in the Python class.
struct ObjectPlan : cdr::Plan {
  struct Slot {
    nb::object name;        // interned: "x"
    nb::object initial;     // the default
    bool copies = false;    // `initial` is mutable, so each message gets a copy
    bool converts = false;  // a numeric array: a value given by the user is converted
    nb::object empty;       // numeric sequence: an empty array.array of its type; numeric array: zeros
  };

  PyTypeObject* type = nullptr;     // borrowed, because the class owns the plan
  std::vector<Py_ssize_t> offsets;  // of each field's slot in the object
  std::vector<Slot> slots;
  mutable MessagePool pool;
  // The size of the last message encoded, as a first guess for the next one. Without it, encoding TFMessage x 1 takes
  // 14 % longer: benchmarks/native, "size hint".
  std::atomic<std::size_t> last_size = 64;
  // The same of what an EncodedMessage holds itself.
  std::atomic<std::size_t> last_stored_size = 64;
  std::vector<nb::object> nested;  // keeps the plans of nested messages, and their classes, alive
};

// Functions and classes of tfloom.rosidl that the native base class uses. The module owns them, and the garbage
// collector frees both at the interpreter's end.
struct MessageHooks {
  nb::object compile;       // (class) -> Plan
  nb::object convert;       // (class, name, value) -> numeric array
  nb::object check;         // (class, name, value) -> None, or raises AssertionError
  nb::object check_names;   // (class, kwargs) -> None, or raises AssertionError
  nb::object warn_names;    // (class, kwargs) -> None
  nb::object encode_error;  // exception classes
  nb::object decode_error;

  ~MessageHooks();  // if they are the hooks that `message_hooks` returns, there are none afterwards
};
// Set the hooks that `message_hooks` returns; null: none.
void set_message_hooks(const MessageHooks* hooks) noexcept;
// Return the hooks. Raise RuntimeError if there are none, because the interpreter is ending.
const MessageHooks& message_hooks();

// Return a value's repr, a long one cut, for the text of an error.
[[nodiscard]] std::string shown(nb::handle value);

// Return the plan of a message class, compiled at first use. Raise TypeError for any other class.
ObjectPlan& plan_of(PyTypeObject* type);

// Return a message of a class, or of one derived from it, decoded from encapsulation header and CDR. Throw
// cdr::DecodeError for other bytes.
nb::object decode_message(const ObjectPlan& plan, PyTypeObject* type, std::span<const std::byte> bytes);

inline PyObject*& slot(PyObject* message, Py_ssize_t offset) noexcept {
  return *reinterpret_cast<PyObject**>(reinterpret_cast<char*>(message) + offset);
}

// Return a new reference to the object in a slot; not valid if the slot is empty. Python holds the same guard while it
// assigns to a slot. With a GIL, the guard does nothing.
inline nb::object held_slot(PyObject* message, Py_ssize_t offset) {
  const nb::ft_object_guard guard{nb::handle(message)};
  return nb::borrow(slot(message, offset));
}

// Return a copy, made by the object's `__copy__`, or by a slice for a list.
nb::object copy(const nb::object& object);

// A view of an object's memory. It must not be moved, because some objects let the view refer to itself.
class Buffer {
 public:
  Buffer(PyObject* object, int flags) {
    if (PyObject_GetBuffer(object, &view_, flags) != 0) throw nb::python_error();
  }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;
  ~Buffer() { PyBuffer_Release(&view_); }

  [[nodiscard]] void* data() const noexcept { return view_.buf; }
  [[nodiscard]] const Py_buffer& view() const noexcept { return view_; }
  [[nodiscard]] std::span<const std::byte> bytes() const noexcept {
    return {static_cast<const std::byte*>(view_.buf), static_cast<std::size_t>(view_.len)};
  }

 private:
  Py_buffer view_;
};

// Creates Python messages; the builder of cdr::Decoder.
class ObjectBuilder {
 public:
  using Value = nb::object;

  explicit ObjectBuilder(PyTypeObject* outermost) : outermost_(outermost) {}

  Value message(const cdr::Plan& plan) {
    PyTypeObject* type = outermost_ != nullptr ? outermost_ : static_cast<const ObjectPlan&>(plan).type;
    outermost_ = nullptr;
    return nb::steal(static_cast<const ObjectPlan&>(plan).pool.make(type));
  }
  void finish(Value& message, const cdr::Plan&) noexcept { MessagePool::track(message.ptr()); }
  void finish_list(Value& list) noexcept { MessagePool::track(list.ptr()); }
  void set(Value& message, const cdr::Plan& plan, std::size_t index, Value value) noexcept {
    slot(message.ptr(), static_cast<const ObjectPlan&>(plan).offsets[index]) = value.release().ptr();
  }
  Value boolean(bool value) { return nb::borrow(value ? Py_True : Py_False); }
  Value octet(std::uint8_t value);
  Value string(std::string_view text, std::size_t offset);
  Value wide(std::u32string_view text);
  Value list(std::uint32_t length);
  void set_item(Value& list, std::uint32_t index, Value value) noexcept {
    PyList_SET_ITEM(list.ptr(), index, value.release().ptr());
  }

  template <class T>
  Value number(T value) {
    PyObject* object;
    if constexpr (std::is_floating_point_v<T>) {
      object = real(static_cast<double>(value));
    } else if constexpr (std::is_signed_v<T>) {
      object = PyLong_FromLongLong(value);
    } else {
      object = PyLong_FromUnsignedLongLong(value);
    }
    return checked(object);
  }

  template <class T>
  Value numbers(const cdr::Plan& plan, std::size_t index, cdr::Cursor& in, std::uint32_t length) {
    const auto& slot = static_cast<const ObjectPlan&>(plan).slots[index];
    if (plan.fields[index].shape != cdr::Shape::array) {
      return sequence(slot, in.read_bytes(length, sizeof(T)), in.swaps() && sizeof(T) > 1);
    }
    Value array = copy(slot.empty);
    const Buffer buffer(array.ptr(), PyBUF_WRITABLE);
    in.read_into(std::span<T>(static_cast<T*>(buffer.data()), length));
    return array;
  }

 private:
  static Value checked(PyObject* object) {
    if (object == nullptr) throw nb::python_error();
    return nb::steal(object);
  }
  static Value sequence(const ObjectPlan::Slot& slot, std::span<const std::byte> bytes, bool swap);

  // Most numbers of most transforms are 0 or 1, so all messages share one object for each. With a new object for each
  // number, decoding a PoseStamped takes 18 % longer: benchmarks/native, "shared 0 and 1".
  static PyObject* real(double value) noexcept {
    static PyObject* const zero = PyFloat_FromDouble(0.0);
    static PyObject* const one = PyFloat_FromDouble(1.0);
    const auto bits = std::bit_cast<std::uint64_t>(value);
    if (bits == 0) return Py_NewRef(zero);
    if (bits == std::bit_cast<std::uint64_t>(1.0)) return Py_NewRef(one);
    return PyFloat_FromDouble(value);
  }

  PyTypeObject* outermost_;  // the class of the outermost message: the plan's class or one derived from it
};

// Reads Python messages; the reader of cdr::Encoder. It holds references while a message is encoded, because a number's __float__
// may run any code.
class ObjectReader {
 public:
  using Value = PyObject*;
  using Held = nb::object;

  ObjectReader() = default;
  // Numbers in contiguous memory of at least `min_kept` bytes are valid as long as this reader.
  explicit ObjectReader(std::size_t min_kept) : min_kept_(min_kept) {}

  Value field(const Held& message, const cdr::Plan& plan, std::size_t index) {
    const Py_ssize_t offset = static_cast<const ObjectPlan&>(plan).offsets[index];
#ifdef Py_GIL_DISABLED
    PyObject* value = hold(held_slot(message.ptr(), offset));
#else
    PyObject* value = slot(message.ptr(), offset);
#endif
    if (value == nullptr) throw cdr::EncodeError("is not set");
    return value;
  }
  Held open(Value value, const cdr::Plan& plan);
  bool boolean(Value value);
  std::uint8_t octet(Value value);
  std::string_view string(Value value) {
    if (PyUnicode_CheckExact(value) && PyUnicode_IS_COMPACT_ASCII(value)) {
      return {reinterpret_cast<const char*>(PyUnicode_1BYTE_DATA(value)),
              static_cast<std::size_t>(PyUnicode_GET_LENGTH(value))};
    }
    return any_string(value);
  }
  std::u32string wide(Value value);
  Held open_list(Value value);
  std::size_t length(const Held& list) { return static_cast<std::size_t>(PySequence_Fast_GET_SIZE(list.ptr())); }
  Value item(const Held& list, std::size_t index);

  template <class T>
  T number(Value value) {
    if constexpr (std::is_same_v<T, double>) {
      return PyFloat_CheckExact(value) ? PyFloat_AS_DOUBLE(value) : real(value, std::numeric_limits<T>::max());
    } else if constexpr (std::is_same_v<T, float>) {
      return static_cast<T>(real(value, std::numeric_limits<T>::max()));
    } else if constexpr (std::is_same_v<T, std::uint64_t>) {
      return natural(value);
    } else {
      return static_cast<T>(integer(value, std::numeric_limits<T>::min(), std::numeric_limits<T>::max()));
    }
  }

  template <class T, class Visit>
  bool numbers(Value value, Visit&& visit) {
    if (PyObject_CheckBuffer(value) == 0) return false;
    const Buffer buffer(value, PyBUF_FORMAT | PyBUF_C_CONTIGUOUS);
    if (!holds<T>(buffer.view())) return false;
    if (buffer.bytes().size() < min_kept_) {
      visit(buffer.bytes());
    } else {
      visit(kept_.emplace_front(value, PyBUF_C_CONTIGUOUS).bytes());
    }
    return true;
  }

 private:
#ifdef Py_GIL_DISABLED
  // Another thread may replace a value while it is read, so all values stay referenced until the message is encoded.
  Value hold(nb::object value) {
    held_.push_back(std::move(value));
    return held_.back().ptr();
  }
  std::vector<nb::object> held_;
#endif

  static std::string_view any_string(Value value);
  static double real(Value value, double limit);
  static std::int64_t integer(Value value, std::int64_t least, std::int64_t greatest);
  static std::uint64_t natural(Value value);

  template <class T>
  static bool holds(const Py_buffer& view) {
    const char kind = view.format == nullptr ? 'B' : format_of(view.format);
    return view.itemsize == sizeof(T) && std::string_view(kinds<T>).find(kind) != std::string_view::npos;
  }
  static char format_of(const char* format) noexcept;  // '\0': not in host byte order, or not a single number

  template <class T>
  static constexpr const char* kinds = std::is_floating_point_v<T> ? "fd"
                                       : std::is_signed_v<T>       ? "bhilq"
                                                                   : "BHILQ";

  std::size_t min_kept_ = std::numeric_limits<std::size_t>::max();
  std::forward_list<Buffer> kept_;
};

// The bytes object into which a message is encoded.
class BytesStorage {
 public:
  std::span<std::byte> resize(std::size_t size);
  nb::bytes take(std::size_t size);

 private:
  nb::object bytes_;
};

// A message that is encoded and then sent at once: its large arrays are not copied, but belong to the message, which can't
// resize them as long as this object exists.
class EncodedMessage {
 public:
  // Throw as `encode`.
  explicit EncodedMessage(nb::handle message);

  // The parts of encapsulation header and CDR, in order, valid as long as this object.
  [[nodiscard]] const std::vector<std::span<const std::byte>>& parts() const noexcept { return parts_; }

 private:
  class Storage;

  ObjectReader reader_;
  nb::bytes stored_;
  std::vector<std::span<const std::byte>> parts_;
};

// Return whether the last message of its class was so large that it is worth an EncodedMessage. Raise TypeError for what is
// not a message.
bool is_large(nb::handle message);

// Return a message as encapsulation header and CDR, little-endian, not padded.
nb::bytes encode_message(nb::handle message);

}  // namespace tfloom::bindings
