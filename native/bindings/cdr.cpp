// The codec of messages: plans of types, encoding and decoding.

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include <structmember.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "bindings/bindings.hpp"
#include "bindings/message_base.hpp"
#include "bindings/objects.hpp"
#include "core/kept_memory.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace tfloom::bindings {
namespace {

using cdr::Kind;
using cdr::Shape;

template <class Value, std::size_t size>
Value find_name(const std::array<std::pair<const char*, Value>, size>& table, const std::string& name) {
  for (const auto& [key, value] : table) {
    if (name == key) return value;
  }
  throw nb::value_error(("no kind or shape is called '" + name + "'").c_str());
}

constexpr std::array<std::pair<const char*, Kind>, 16> kinds{{{"bool", Kind::boolean},
                                                              {"byte", Kind::octet},
                                                              {"int8", Kind::int8},
                                                              {"uint8", Kind::uint8},
                                                              {"char", Kind::uint8},
                                                              {"int16", Kind::int16},
                                                              {"uint16", Kind::uint16},
                                                              {"int32", Kind::int32},
                                                              {"uint32", Kind::uint32},
                                                              {"int64", Kind::int64},
                                                              {"uint64", Kind::uint64},
                                                              {"float32", Kind::float32},
                                                              {"float64", Kind::float64},
                                                              {"string", Kind::string},
                                                              {"wstring", Kind::wstring},
                                                              {"message", Kind::message}}};
constexpr std::array<std::pair<const char*, Shape>, 4> shapes{{{"", Shape::single},
                                                               {"array", Shape::array},
                                                               {"bounded", Shape::bounded},
                                                               {"unbounded", Shape::unbounded}}};

// Return the offset of the member that __slots__ created for a field [bytes].
Py_ssize_t slot_offset(const nb::handle& type, const std::string& field) {
  const nb::object member = type.attr(("_" + field).c_str());
  if (Py_TYPE(member.ptr()) != &PyMemberDescr_Type) {
    throw nb::type_error(("'_" + field + "' is no slot of the class").c_str());
  }
  return reinterpret_cast<PyMemberDescrObject*>(member.ptr())->d_member->offset;
}

// There is no slot to clear a plan: each cycle through it passes through its class, which Python clears.
int traverse_plan(PyObject* self, visitproc visit, void* arg) {
  Py_VISIT(Py_TYPE(self));
  if (!nb::inst_ready(self)) return 0;
  const ObjectPlan& plan = *nb::inst_ptr<ObjectPlan>(self);
  for (const ObjectPlan::Slot& slot : plan.slots) {
    Py_VISIT(slot.name.ptr());
    Py_VISIT(slot.initial.ptr());
    Py_VISIT(slot.empty.ptr());
  }
  for (const nb::object& nested : plan.nested) Py_VISIT(nested.ptr());
  return 0;
}

PyType_Slot plan_slots[] = {{Py_tp_traverse, reinterpret_cast<void*>(&traverse_plan)}, {0, nullptr}};

template <class Visit>
int for_each_hook(MessageHooks& hooks, Visit&& visit) {
  for (nb::object* hook : {&hooks.compile, &hooks.convert, &hooks.check, &hooks.check_names, &hooks.warn_names,
                           &hooks.encode_error, &hooks.decode_error}) {
    if (const int result = visit(*hook)) return result;
  }
  return 0;
}

int traverse_hooks(PyObject* self, visitproc visit, void* arg) {
  Py_VISIT(Py_TYPE(self));
  if (!nb::inst_ready(self)) return 0;
  return for_each_hook(*nb::inst_ptr<MessageHooks>(self), [&](const nb::object& hook) {
    Py_VISIT(hook.ptr());
    return 0;
  });
}

int clear_hooks(PyObject* self) {
  if (!nb::inst_ready(self)) return 0;
  set_message_hooks(nullptr);
  return for_each_hook(*nb::inst_ptr<MessageHooks>(self), [](nb::object& hook) {
    hook.reset();
    return 0;
  });
}

PyType_Slot hooks_slots[] = {{Py_tp_traverse, reinterpret_cast<void*>(&traverse_hooks)},
                             {Py_tp_clear, reinterpret_cast<void*>(&clear_hooks)},
                             {0, nullptr}};

void bind_message_hooks(nb::module_& m) {
  nb::class_<MessageHooks>(m, "_MessageHooks", nb::type_slots(hooks_slots), "What `set_message_hooks` was given.");
  m.def(
      "set_message_hooks",
      [module = nb::handle(m)](nb::object compile, nb::object convert, nb::object check, nb::object check_names,
                               nb::object warn_names, nb::object encode_error, nb::object decode_error) {
        const nb::object hooks = nb::cast(MessageHooks{std::move(compile), std::move(convert), std::move(check),
                                                       std::move(check_names), std::move(warn_names),
                                                       std::move(encode_error), std::move(decode_error)});
        set_message_hooks(nb::inst_ptr<MessageHooks>(hooks));
        module.attr("_message_hooks") = hooks;
      },
      "compile"_a, "convert"_a, "check"_a, "check_names"_a, "warn_names"_a, "encode_error"_a, "decode_error"_a,
      "Set the functions that compile classes, convert arrays and check fields, and the errors that the codec raises.");
}

void init_plan(ObjectPlan* self, const nb::type_object& message_class, const std::string& name) {
  new (self) ObjectPlan;
  self->name = name;
  self->type = reinterpret_cast<PyTypeObject*>(message_class.ptr());
  self->update_min_size();
}

// Must be called after the last field is added.
void complete_plan(ObjectPlan& plan) {
  plan.pool.manage(plan.type, plan.fields.size());
}

void add_field(ObjectPlan& plan, const std::string& name, const std::string& kind, const std::string& shape,
               std::uint32_t count, std::uint32_t string_bound, const nb::object& message_class,
               const nb::object& initial, bool copies, const nb::object& empty) {
  cdr::Field field{name, find_name(kinds, kind), find_name(shapes, shape), count, string_bound, nullptr};
  if (field.kind == Kind::message) {
    field.message = &plan_of(reinterpret_cast<PyTypeObject*>(message_class.ptr()));
    plan.nested.push_back(message_class);
  }
  ObjectPlan::Slot slot;
  plan.offsets.push_back(slot_offset(nb::handle(reinterpret_cast<PyObject*>(plan.type)), name));
  slot.name = nb::steal(PyUnicode_InternFromString(name.c_str()));
  slot.initial = initial;
  slot.copies = copies;
  slot.converts = cdr::is_number(field.kind) && field.shape != Shape::single;
  slot.empty = empty;
  plan.fields.push_back(std::move(field));
  plan.slots.push_back(std::move(slot));
  plan.update_min_size();
}

[[noreturn]] void raise_codec_error(const nb::object& error_class, const std::string& text, nb::object path,
                                    nb::object reason, nb::object offset) {
  const auto error = error_class(text);
  error.attr("path") = path;
  error.attr("reason") = reason;
  error.attr("offset") = offset;
  PyErr_SetObject(error_class.ptr(), error.ptr());
  throw nb::python_error();
}

std::string whole_path(const cdr::Plan& plan, const cdr::PathError& error) {
  return std::string(plan.base_name()) + (error.path.empty() ? "" : "." + error.path);
}

// Encode a message. Raise the EncodeError of Python for a value that does not fit its field.
template <class Storage>
void encode_into(cdr::Writer<Storage>& out, ObjectReader& reader, nb::handle message, const ObjectPlan& plan) {
  try {
    cdr::Encoder(reader, out).message(nb::borrow(message), plan);
  } catch (const cdr::EncodeError& error) {
    const std::string reason = error.what();
    const std::string path = whole_path(plan, error);
    raise_codec_error(message_hooks().encode_error, path + (reason.front() == ':' ? "" : " ") + reason,
                      nb::cast(path), nb::cast(reason), nb::none());
  }
}

nb::object decode_bytes(const ObjectPlan& plan, PyTypeObject* type, std::span<const std::byte> bytes) {
  try {
    return decode_message(plan, type, bytes);
  } catch (const cdr::DecodeError& error) {
    const std::string path = whole_path(plan, error);
    raise_codec_error(message_hooks().decode_error,
                      path + ": byte " + std::to_string(error.offset) + ": " + error.what(), nb::cast(path),
                      nb::cast(std::string(error.what())), nb::cast(error.offset));
  }
}

nb::object decode(const nb::type_object& message_class, const nb::handle& data) {
  auto* type = reinterpret_cast<PyTypeObject*>(message_class.ptr());
  const ObjectPlan& plan = plan_of(type);
  if (PyBytes_CheckExact(data.ptr())) {
    const auto* bytes = reinterpret_cast<const std::byte*>(PyBytes_AS_STRING(data.ptr()));
    return decode_bytes(plan, type, {bytes, static_cast<std::size_t>(PyBytes_GET_SIZE(data.ptr()))});
  }
  const Buffer buffer(data.ptr(), PyBUF_SIMPLE);
  return decode_bytes(plan, type, buffer.bytes());
}

}  // namespace

std::span<std::byte> BytesStorage::resize(std::size_t size) {
  PyObject* bytes = bytes_.release().ptr();
  if (bytes == nullptr) {
    bytes = PyBytes_FromStringAndSize(nullptr, static_cast<Py_ssize_t>(size));
  } else {
    _PyBytes_Resize(&bytes, static_cast<Py_ssize_t>(size));
  }
  if (bytes == nullptr) throw nb::python_error();
  bytes_ = nb::steal(bytes);
  return {reinterpret_cast<std::byte*>(PyBytes_AS_STRING(bytes)), size};
}

nb::bytes BytesStorage::take(std::size_t size) {
  if (static_cast<std::size_t>(PyBytes_GET_SIZE(bytes_.ptr())) != size) resize(size);
  return nb::borrow<nb::bytes>(bytes_);
}

// What is not large goes into bytes; the large arrays stay where they are.
class EncodedMessage::Storage : public BytesStorage {
 public:
  static constexpr std::size_t min_referred = 64 << 10;

  struct Referred {
    std::size_t offset;  // in the bytes
    std::span<const std::byte> bytes;
  };

  void refer(std::size_t offset, std::span<const std::byte> bytes) { referred.push_back({offset, bytes}); }

  std::vector<Referred> referred;
};

EncodedMessage::EncodedMessage(nb::handle message) : reader_(Storage::min_referred) {
  ObjectPlan& plan = plan_of(Py_TYPE(message.ptr()));
  Storage storage;
  cdr::Writer out(storage, plan.last_stored_size);
  encode_into(out, reader_, message, plan);
  plan.last_size = out.size();
  plan.last_stored_size = out.stored_size();
  keep_memory_of(out.size());
  stored_ = storage.take(out.stored_size());
  const std::span stored(static_cast<const std::byte*>(stored_.data()), stored_.size());
  std::size_t begin = 0;
  for (const auto& [offset, bytes] : storage.referred) {
    if (offset > begin) parts_.push_back(stored.subspan(begin, offset - begin));
    parts_.push_back(bytes);
    begin = offset;
  }
  if (stored.size() > begin) parts_.push_back(stored.subspan(begin));
}

bool is_large(nb::handle message) { return plan_of(Py_TYPE(message.ptr())).last_size >= min_kept_memory; }

nb::bytes encode_message(nb::handle message) {
  ObjectPlan& plan = plan_of(Py_TYPE(message.ptr()));
  BytesStorage storage;
  cdr::Writer out(storage, plan.last_size);
  ObjectReader reader;
  encode_into(out, reader, message, plan);
  plan.last_size = out.size();
  keep_memory_of(out.size());
  return storage.take(out.size());
}

nb::object decode_message(const ObjectPlan& plan, PyTypeObject* type, std::span<const std::byte> bytes) {
  keep_memory_of(bytes.size());
  cdr::Cursor in(bytes);
  ObjectBuilder builder(type);
  auto message = cdr::Decoder(in, builder).message(plan);
  constexpr std::size_t max_padding = 7;  // wires pad to 4 or 8
  if (in.left() > max_padding) in.fail(std::to_string(in.left()) + " bytes are left over");
  return message;
}

void bind_cdr(nb::module_& m) {
  bind_message_base(m);
  nb::class_<ObjectPlan>(m, "Plan", nb::type_slots(plan_slots),
                         "The codec's description of a message class: its fields and their positions.")
      .def("__init__", &init_plan, "message_class"_a, "name"_a, "Create a plan without fields.")
      .def("add_field", &add_field, "name"_a, "kind"_a, "shape"_a, "count"_a, "string_bound"_a,
           "message_class"_a.none(), "initial"_a.none(), "copies"_a, "empty"_a.none(),
           "Add the next field.\n\n"
           "`kind` is a primitive's name or 'message'; `shape` is '', 'array', 'bounded' or 'unbounded'. `initial` is "
           "the default; with `copies`, each message gets a copy of it. `empty` is the array that is copied and filled "
           "when a numeric array is decoded.");
  m.def("complete_plan", &complete_plan, "plan"_a,
        "Complete a plan after its last field. From now on it allocates and frees the objects of its class.");
  m.def("encode", &encode_message, "message"_a, "Return a message as encapsulation header and CDR, little-endian, not padded.");
  m.def("decode", &decode, "message_class"_a, "data"_a,
        nb::sig("def decode(message_class: type, data: object) -> typing.Any"),
        "Return a message of `message_class`, decoded from encapsulation header and CDR.");
  bind_message_hooks(m);
}

}  // namespace tfloom::bindings
