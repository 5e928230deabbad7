#include "bindings/message_base.hpp"

#include <structmember.h>

#include <atomic>
#include <cstddef>
#include <exception>
#include <utility>

#include "bindings/objects.hpp"

namespace tfloom::bindings {
namespace {

nb::object class_of(PyObject* self) { return nb::borrow(reinterpret_cast<PyObject*>(Py_TYPE(self))); }

nb::object new_message(const ObjectPlan& plan);

nb::object initial_value(const ObjectPlan& plan, std::size_t index) {
  const auto& slot = plan.slots[index];
  const auto& field = plan.fields[index];
  if (field.kind == cdr::Kind::message && field.shape != cdr::Shape::unbounded &&
      field.shape != cdr::Shape::bounded) {
    const auto& nested = static_cast<const ObjectPlan&>(*field.message);
    if (field.shape == cdr::Shape::single) return new_message(nested);
    nb::list list;
    for (std::uint32_t i = 0; i < field.count; ++i) list.append(new_message(nested));
    return list;
  }
  return slot.copies ? copy(slot.initial) : slot.initial;
}

void set_slot(PyObject* self, Py_ssize_t offset, nb::object value) {
  // The former value goes after the slot has the new one and the object is unlocked: its destruction may run any Python
  // code, which may use this object.
  PyObject* old;
  {
    const nb::ft_object_guard guard{nb::handle(self)};
    old = std::exchange(slot(self, offset), value.release().ptr());
  }
  Py_XDECREF(old);
}

nb::object new_message(const ObjectPlan& plan) {
  // The garbage collector must not see a message with empty slots, so it tracks the message at the end only: creating
  // the values may start a collection.
  auto message = nb::steal(plan.pool.make(plan.type));
  for (std::size_t i = 0; i < plan.slots.size(); ++i) {
    set_slot(message.ptr(), plan.offsets[i], initial_value(plan, i));
  }
  MessagePool::track(message.ptr());
  return message;
}

nb::object convert(PyObject* self, const ObjectPlan::Slot& slot, const nb::object& value) {
  if (!slot.converts) return value;
  return message_hooks().convert(class_of(self), slot.name, value);
}

// Take `check_fields` from the keywords; return how many of them that is.
Py_ssize_t take_check_fields(PyObject* self, PyObject* kwargs) {
  static PyObject* const key = PyUnicode_InternFromString("check_fields");
  bool check = check_by_default();
  PyObject* const value = kwargs == nullptr ? nullptr : PyDict_GetItemWithError(kwargs, key);
  if (value != nullptr && value != Py_None) check = PyObject_IsTrue(value) == 1;
  if (PyErr_Occurred() != nullptr) throw nb::python_error();
  reinterpret_cast<MessageObject*>(self)->check_fields = check;
  return value != nullptr ? 1 : 0;
}

// Return the error text for positional arguments, as "Vector3 takes its fields by keyword: Vector3(x=…, …)".
std::string by_keyword(PyTypeObject* type) {
  const std::string name = type->tp_name;
  std::string fields;
  for (const ObjectPlan::Slot& slot : plan_of(type).slots) {
    if (!fields.empty()) fields += ", ";
    fields += std::string(nb::str(slot.name).c_str()) + "=…";
  }
  return name + " takes its fields by keyword: write " + name + "(" + fields + ")";
}

void init(PyObject* self, PyObject* args, PyObject* kwargs) {
  if (PyTuple_GET_SIZE(args) != 0) {
    throw nb::type_error(by_keyword(Py_TYPE(self)).c_str());
  }
  const ObjectPlan& plan = plan_of(Py_TYPE(self));
  plan.pool.tag(self);
  // First `check_fields`, which decides whether the other keywords are checked.
  Py_ssize_t known_count = take_check_fields(self, kwargs);
  const bool check = reinterpret_cast<MessageObject*>(self)->check_fields != 0;
  if (check && kwargs != nullptr) message_hooks().check_names(class_of(self), nb::borrow(kwargs));
  for (std::size_t i = 0; i < plan.slots.size(); ++i) {
    const auto& slot = plan.slots[i];
    PyObject* argument = kwargs == nullptr ? nullptr : PyDict_GetItemWithError(kwargs, slot.name.ptr());
    if (argument == nullptr) {
      if (PyErr_Occurred() != nullptr) throw nb::python_error();
      set_slot(self, plan.offsets[i], initial_value(plan, i));
      continue;
    }
    ++known_count;
    const auto converted = convert(self, slot, nb::borrow(argument));
    if (check) message_hooks().check(class_of(self), slot.name, converted);
    set_slot(self, plan.offsets[i], converted);
  }
  // Keywords that are not fields are detected by the number of keywords, so that the usual call costs no second search.
  if (kwargs != nullptr && PyDict_GET_SIZE(kwargs) > known_count) {
    message_hooks().warn_names(class_of(self), nb::borrow(kwargs));
  }
}

// Turn the current C++ exception into a Python error, and return -1, as a slot function of Python must.
int fail() noexcept {
  try {
    throw;
  } catch (nb::python_error& error) {
    error.restore();
  } catch (const nb::builtin_exception& error) {
    PyErr_SetString(PyExc_TypeError, error.what());
  } catch (const std::bad_alloc&) {
    PyErr_NoMemory();
  } catch (const std::exception& error) {
    PyErr_SetString(PyExc_RuntimeError, error.what());
  }
  return -1;
}

int message_init(PyObject* self, PyObject* args, PyObject* kwargs) noexcept {
  try {
    init(self, args, kwargs);
    return 0;
  } catch (const std::exception&) {
    return fail();
  }
}

int message_setattro(PyObject* self, PyObject* name, PyObject* value) noexcept {
  if (reinterpret_cast<MessageObject*>(self)->check_fields != 0 && value != nullptr) {
    try {
      message_hooks().check(class_of(self), nb::borrow(name), nb::borrow(value));
    } catch (const std::exception&) {
      return fail();
    }
  }
  return PyObject_GenericSetAttr(self, name, value);
}

PyMemberDef members[] = {
    {"_check_fields", T_BOOL, offsetof(MessageObject, check_fields), 0,
     "Whether what is assigned to a field is checked at once."},
    {nullptr, 0, 0, 0, nullptr},
};

PyType_Slot type_slots[] = {
    {Py_tp_doc, const_cast<char*>("The native part of `tfloom.rosidl.message.Message`.")},
    {Py_tp_init, reinterpret_cast<void*>(&message_init)},
    {Py_tp_setattro, reinterpret_cast<void*>(&message_setattro)},
    {Py_tp_members, members},
    {0, nullptr},
};

PyType_Spec type_spec = {"tfloom._native.MessageBase", sizeof(MessageObject), 0,
                         Py_TPFLAGS_DEFAULT | Py_TPFLAGS_BASETYPE, type_slots};

}  // namespace

std::atomic<bool>& check_by_default() noexcept {
  static std::atomic<bool> value = false;
  return value;
}

void bind_message_base(nb::module_& m) {
  const auto type = nb::steal(PyType_FromSpec(&type_spec));
  if (!type.is_valid()) throw nb::python_error();
  m.attr("MessageBase") = type;
  m.def(
      "check_fields_by_default", [](bool value) { check_by_default() = value; }, nb::arg("value"),
      "Set whether messages check what is assigned to their fields, where `check_fields` is not given.");
}

}  // namespace tfloom::bindings
