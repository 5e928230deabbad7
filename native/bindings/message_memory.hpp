// The memory of message objects: freed ones wait in their class's pool for the next message of that class.
//
// Messages come in hundreds (a TFMessage of 100 transforms is 601 of them), are small, and die together. Python's
// general way to free an object of a class with __slots__ takes as long as reading the message did. Without the pool,
// decoding takes 30 % longer, or more: benchmarks/native, "message pool".
#pragma once

#include <nanobind/nanobind.h>

#include <cstddef>
#include <cstdint>

namespace tfloom::bindings {

struct MessageObject {
  PyObject_HEAD
  char check_fields;
  std::uint32_t pool;  // number of the pool that it goes to; 0: none
};

// The freed objects of one class. Made with the class's plan, and gone with it.
class MessagePool {
 public:
  MessagePool() = default;
  MessagePool(const MessagePool&) = delete;
  MessagePool& operator=(const MessagePool&) = delete;
  ~MessagePool();

  // Takes over freeing the objects of a class that has slots for fields and nothing else: no __dict__, no weak
  // references, no __del__. Another class is left alone, and its objects never come here.
  void manage(PyTypeObject* type, std::size_t field_count);

  // A message whose slots are empty; the collector does not know it yet. Throws when there is no memory.
  PyObject* make(PyTypeObject* type);
  // Lets the collector know of a message once its slots are filled, or of a list once its items are.
  static void finish(PyObject* whole) noexcept;
  // Says that a message that Python made belongs here too.
  void claim(PyObject* message) const noexcept;

  // Keeps the memory of a dead message, unless there is enough already.
  bool keep(PyObject* freed) noexcept;

 private:
  PyObject* take_freed() noexcept;

  PyTypeObject* type_ = nullptr;  // null: adopted none
  std::uint32_t number_ = 0;
  PyObject* freed_ = nullptr;
  std::size_t kept_ = 0;
};

}  // namespace tfloom::bindings
