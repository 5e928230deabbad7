#include "bindings/objects.hpp"

#include <atomic>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace tfloom::bindings {

using cdr::DecodeError;
using cdr::EncodeError;

namespace {

std::atomic<const MessageHooks*> current_hooks{nullptr};

}  // namespace

MessageHooks::~MessageHooks() {
  const MessageHooks* self = this;
  current_hooks.compare_exchange_strong(self, nullptr);
}

void set_message_hooks(const MessageHooks* hooks) noexcept { current_hooks.store(hooks, std::memory_order_release); }

const MessageHooks& message_hooks() {
  const MessageHooks* hooks = current_hooks.load(std::memory_order_acquire);
  if (hooks == nullptr) throw std::runtime_error("messages can't be used any more: the interpreter is ending");
  return *hooks;
}

ObjectPlan& plan_of(PyTypeObject* type) {
  static PyObject* const key = PyUnicode_InternFromString("_PLAN");
  auto plan = nb::steal(PyObject_GetAttr(reinterpret_cast<PyObject*>(type), key));
  if (!plan.is_valid()) {
    PyErr_Clear();
    throw nb::type_error((std::string(type->tp_name) + " is not a message class").c_str());
  }
  if (plan.is_none()) {
    plan = message_hooks().compile(nb::borrow(reinterpret_cast<PyObject*>(type)));
  }
  return *nb::cast<ObjectPlan*>(plan);  // the class keeps it alive
}

nb::object copy(const nb::object& object) {
  static PyObject* const key = PyUnicode_InternFromString("__copy__");
  PyObject* result = PyList_CheckExact(object.ptr()) ? PyList_GetSlice(object.ptr(), 0, PY_SSIZE_T_MAX)
                                                     : PyObject_CallMethodNoArgs(object.ptr(), key);
  if (result == nullptr) throw nb::python_error();
  return nb::steal(result);
}

ObjectBuilder::Value ObjectBuilder::octet(std::uint8_t value) {
  const char letter = static_cast<char>(value);
  return checked(PyBytes_FromStringAndSize(&letter, 1));
}

namespace {

// Whether a text is ASCII without a NUL.
bool is_ascii(std::string_view text) noexcept {
  unsigned char all = 0;
  for (const char octet : text) all |= static_cast<unsigned char>(octet | (octet - 1));  // 0 - 1 has the high bit, too
  return all < 0x80;
}

}  // namespace

ObjectBuilder::Value ObjectBuilder::string(std::string_view text, std::size_t offset) {
  if (is_ascii(text)) {  // without, a JointState of 30 takes 16 % longer: benchmarks/native, "ASCII text"
    Value object = checked(PyUnicode_New(static_cast<Py_ssize_t>(text.size()), 127));
    // An empty text may have no address, which memcpy must not be given.
    if (!text.empty()) std::memcpy(PyUnicode_1BYTE_DATA(object.ptr()), text.data(), text.size());
    return object;
  }
  // rclpy's texts end before their first NUL. The files in a real node's GetTypeDescription have one behind them.
  text = text.substr(0, text.find('\0'));
  PyObject* object = PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "strict");
  if (object != nullptr) return nb::steal(object);
  if (PyErr_ExceptionMatches(PyExc_UnicodeDecodeError) == 0) throw nb::python_error();
  PyErr_Clear();
  throw DecodeError(offset, "the text is not UTF-8");
}

ObjectBuilder::Value ObjectBuilder::wide(std::u32string_view text) {
  return checked(
      PyUnicode_FromKindAndData(PyUnicode_4BYTE_KIND, text.data(), static_cast<Py_ssize_t>(text.size())));
}

ObjectBuilder::Value ObjectBuilder::list(std::uint32_t length) {
  Value list = checked(PyList_New(static_cast<Py_ssize_t>(length)));
  PyObject_GC_UnTrack(list.ptr());  // until its items are set, because `gc.get_objects` would return it with null items
  return list;
}

ObjectBuilder::Value ObjectBuilder::sequence(const ObjectPlan::Slot& slot, std::span<const std::byte> bytes, bool swap) {
  Value array = copy(slot.empty);
  if (bytes.empty()) return array;
  // One copy, from the sample into the array.
  auto* from = const_cast<char*>(reinterpret_cast<const char*>(bytes.data()));
  const auto view = checked(PyMemoryView_FromMemory(from, static_cast<Py_ssize_t>(bytes.size()), PyBUF_READ));
  array.attr("frombytes")(view);
  if (swap) array.attr("byteswap")();
  return array;
}

std::string shown(nb::handle value) {
  constexpr std::size_t longest = 60;
  const auto repr = nb::steal(PyObject_Repr(value.ptr()));
  const char* utf8 = repr.is_valid() ? PyUnicode_AsUTF8(repr.ptr()) : nullptr;
  if (!utf8) PyErr_Clear();
  const std::string text = utf8 ? utf8 : "<no repr>";
  if (text.size() <= longest) return text;
  std::size_t end = longest;
  while ((static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U) --end;  // not within a character
  return text.substr(0, end) + "...";
}

namespace {

[[noreturn]] void throw_mismatch(const std::string& expected, PyObject* value) {
  // A time of rclpy prints as `Time`, too, and has a method that gives the message.
  const bool is_of_rclpy =
      expected.find("/msg/") != std::string::npos && PyObject_HasAttrString(value, "to_msg") == 1;
  throw EncodeError("must be " + expected + ", got " + shown(value) + " (" + Py_TYPE(value)->tp_name + ")" +
                    (is_of_rclpy ? ": append .to_msg()" : ""));
}

// Clear TypeError and OverflowError, which the caller replaces by an EncodeError. Rethrow errors of the value's own
// methods (its __float__ raised).
void clear_type_error() {
  if (PyErr_ExceptionMatches(PyExc_TypeError) == 0 && PyErr_ExceptionMatches(PyExc_OverflowError) == 0) {
    throw nb::python_error();
  }
  PyErr_Clear();
}

nb::object as_int(PyObject* value) {
  if (PyLong_Check(value)) return nb::borrow(value);
  if (PyIndex_Check(value) == 0) throw_mismatch("an int", value);
  const auto held = nb::borrow(value);
  auto number = nb::steal(PyNumber_Index(value));
  if (number.is_valid()) return number;
  clear_type_error();  // an array of numpy has __index__, which only one integer gives
  throw_mismatch("an int", value);
}

}  // namespace

ObjectReader::Held ObjectReader::open(Value value, const cdr::Plan& plan) {
  PyTypeObject* expected = static_cast<const ObjectPlan&>(plan).type;
  const bool matches = Py_TYPE(value) == expected || PyType_IsSubtype(Py_TYPE(value), expected) != 0;
  if (!matches) throw_mismatch("a " + plan.name, value);
  return nb::borrow(value);
}

bool ObjectReader::boolean(Value value) {
  if (value == Py_True) return true;
  if (value == Py_False) return false;
  const std::string_view type = Py_TYPE(value)->tp_name;
  if (type != "numpy.bool_" && type != "numpy.bool") throw_mismatch("a bool", value);
  return PyObject_IsTrue(value) == 1;
}

std::uint8_t ObjectReader::octet(Value value) {
  if (PyBytes_Check(value) && PyBytes_GET_SIZE(value) == 1) return static_cast<std::uint8_t>(PyBytes_AS_STRING(value)[0]);
  if (PyByteArray_Check(value) && PyByteArray_GET_SIZE(value) == 1) {
    return static_cast<std::uint8_t>(PyByteArray_AS_STRING(value)[0]);
  }
  throw_mismatch("bytes of length 1", value);
}

std::string_view ObjectReader::any_string(Value value) {
  if (!PyUnicode_Check(value)) throw_mismatch("a str", value);
  Py_ssize_t size = 0;
  const char* text = PyUnicode_AsUTF8AndSize(value, &size);  // kept by the str
  if (text != nullptr) return {text, static_cast<std::size_t>(size)};
  if (PyErr_ExceptionMatches(PyExc_UnicodeEncodeError) == 0) throw nb::python_error();
  PyErr_Clear();
  throw_mismatch("text without lone surrogates", value);
}

std::u32string ObjectReader::wide(Value value) {
  string(value);  // throws if it is not a text
  const auto size = static_cast<std::size_t>(PyUnicode_GET_LENGTH(value));
  std::u32string text(size, U'\0');
  auto* to = reinterpret_cast<Py_UCS4*>(text.data());
  if (size != 0 && PyUnicode_AsUCS4(value, to, static_cast<Py_ssize_t>(size), 0) == nullptr) throw nb::python_error();
  return text;
}

ObjectReader::Held ObjectReader::open_list(Value value) {
  if (PyList_CheckExact(value) || PyTuple_CheckExact(value)) return nb::borrow(value);
  // Bytes are a sequence of numbers only; those of length 0 are the empty sequence of any type.
  const bool is_text = PyUnicode_Check(value) || (PyBytes_Check(value) && PyBytes_GET_SIZE(value) != 0);
  if (is_text || PyDict_Check(value)) throw_mismatch("a sequence", value);
  const auto held = nb::borrow(value);
  auto list = nb::steal(PySequence_Fast(value, ""));
  if (list.is_valid()) return list;
  clear_type_error();
  throw_mismatch("a sequence", value);
}

ObjectReader::Value ObjectReader::item(const Held& list, std::size_t index) {
  // The list may have shrunk, because encoding an element may run any code.
  constexpr auto gone = "is gone: the list changed while it was encoded";
#ifdef Py_GIL_DISABLED
  if (PyList_Check(list.ptr())) {
    auto element = nb::steal(PyList_GetItemRef(list.ptr(), static_cast<Py_ssize_t>(index)));
    if (element.is_valid()) return hold(std::move(element));
    PyErr_Clear();
    throw EncodeError(gone);
  }
#endif
  if (index >= length(list)) throw EncodeError(gone);
  return PySequence_Fast_GET_ITEM(list.ptr(), static_cast<Py_ssize_t>(index));
}

double ObjectReader::real(Value value, double limit) {
  const auto held = nb::borrow(value);
  const double number = PyFloat_AsDouble(value);  // accepts __float__ and __index__: an int, numpy's numbers
  if (number == -1.0 && PyErr_Occurred() != nullptr) {
    clear_type_error();
    throw_mismatch("a float", value);
  }
  if (std::abs(number) > limit && std::isfinite(number)) throw_mismatch("a float within the range of float32", value);
  return number;
}

std::int64_t ObjectReader::integer(Value value, std::int64_t least, std::int64_t greatest) {
  int overflow = 0;
  const auto exact = PyLong_CheckExact(value) ? nb::object() : as_int(value);
  const std::int64_t number = PyLong_AsLongLongAndOverflow(exact.is_valid() ? exact.ptr() : value, &overflow);
  if (number == -1 && PyErr_Occurred() != nullptr) throw nb::python_error();
  if (overflow != 0 || number < least || number > greatest) {
    throw_mismatch("an int in [" + std::to_string(least) + ", " + std::to_string(greatest) + "]",
                   exact.is_valid() ? exact.ptr() : value);
  }
  return number;
}

std::uint64_t ObjectReader::natural(Value value) {
  const auto exact = as_int(value);
  const std::uint64_t number = PyLong_AsUnsignedLongLong(exact.ptr());
  if (number == static_cast<std::uint64_t>(-1) && PyErr_Occurred() != nullptr) {
    clear_type_error();
    throw_mismatch("an int in [0, 18446744073709551615]", exact.ptr());
  }
  return number;
}

char ObjectReader::format_of(const char* format) noexcept {
  if (*format == '@' || *format == '=' || (*format == '<' && std::endian::native == std::endian::little)) ++format;
  return format[0] != '\0' && format[1] == '\0' ? format[0] : '\0';
}

}  // namespace tfloom::bindings
