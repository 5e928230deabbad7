#include "bindings/message_memory.hpp"

#include <cstddef>
#include <utility>
#include <vector>

#include "bindings/message_base.hpp"

namespace tfloom::bindings {
namespace {

constexpr std::size_t max_kept = 1024;  // freed objects per class

std::vector<MessagePool*>& pools() {
  static auto* all = new std::vector<MessagePool*>{nullptr};  // never destroyed, because messages may be freed later
  return *all;
}

PyObject** slots_of(PyObject* message) noexcept {
  return reinterpret_cast<PyObject**>(reinterpret_cast<char*>(message) + sizeof(MessageObject));
}

std::size_t slot_count(const PyTypeObject* type) noexcept {
  return (static_cast<std::size_t>(type->tp_basicsize) - sizeof(MessageObject)) / sizeof(PyObject*);
}

void free_message(PyObject* self);

// Return the managed class of an object: its own class or a base class, whose slots have a known layout.
PyTypeObject* managed_type(PyObject* self) noexcept {
  PyTypeObject* type = Py_TYPE(self);
  while (type->tp_dealloc != &free_message) type = type->tp_base;
  return type;
}

void release(PyObject* self) {
  PyTypeObject* type = Py_TYPE(self);
  PyTypeObject* owner = managed_type(self);
  PyObject** slot = slots_of(self);
  for (std::size_t left = slot_count(owner); left > 0; --left, ++slot) Py_CLEAR(*slot);
  MessagePool* pool = type == owner ? pools()[reinterpret_cast<MessageObject*>(self)->pool] : nullptr;
  if (pool == nullptr || !pool->keep(self)) type->tp_free(self);
  Py_DECREF(type);
}

// The tp_dealloc of managed classes. Python's tp_dealloc of a derived class calls it last.
void free_message(PyObject* self) {
  PyTypeObject* type = Py_TYPE(self);
  if (type->tp_dealloc != &free_message) {
    PyObject_GC_UnTrack(self);
    release(self);
    return;
  }
  if (type->tp_finalize != nullptr && PyObject_CallFinalizerFromDealloc(self) < 0) return;  // resurrected
  PyObject_GC_UnTrack(self);
  Py_TRASHCAN_BEGIN(self, free_message)
  release(self);
  Py_TRASHCAN_END
}

}  // namespace

MessagePool::~MessagePool() {
  if (number_ != 0) pools()[number_] = nullptr;
  while (freed_ != nullptr) PyObject_GC_Del(take_freed());
}

void MessagePool::manage(PyTypeObject* type, std::size_t field_count) {
#if !defined(Py_GIL_DISABLED) && !defined(PYPY_VERSION)
  const bool plain = static_cast<std::size_t>(type->tp_basicsize) == sizeof(MessageObject) + field_count * sizeof(void*) &&
                     type->tp_dictoffset == 0 && type->tp_weaklistoffset == 0 && type->tp_finalize == nullptr &&
                     type->tp_del == nullptr && type->tp_itemsize == 0;
  if (!plain || type_ != nullptr || field_count == 0) return;
  type->tp_dealloc = &free_message;
  type_ = type;
  number_ = static_cast<std::uint32_t>(pools().size());
  pools().push_back(this);
#else
  static_cast<void>(type);
  static_cast<void>(field_count);
#endif
}

PyObject* MessagePool::make(PyTypeObject* type) {
  PyObject* message;
  if (type == type_ && freed_ != nullptr) {
    message = take_freed();
    PyObject_Init(message, type);
  } else {
    message = type->tp_alloc(type, 0);
    if (message == nullptr) throw nanobind::python_error();
    PyObject_GC_UnTrack(message);
  }
  tag(message);
  reinterpret_cast<MessageObject*>(message)->check_fields = check_by_default();
  return message;
}

void MessagePool::track(PyObject* object) noexcept { PyObject_GC_Track(object); }

void MessagePool::tag(PyObject* message) const noexcept {
  if (Py_TYPE(message) == type_) reinterpret_cast<MessageObject*>(message)->pool = number_;
}

bool MessagePool::keep(PyObject* freed) noexcept {
  if (kept_ == max_kept) return false;
  *slots_of(freed) = std::exchange(freed_, freed);  // the first slot of each object points to the next
  ++kept_;
  return true;
}

PyObject* MessagePool::take_freed() noexcept {
  PyObject* first = std::exchange(freed_, *slots_of(freed_));
  *slots_of(first) = nullptr;
  --kept_;
  return first;
}

}  // namespace tfloom::bindings
