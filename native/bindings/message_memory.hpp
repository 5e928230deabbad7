// The memory of message objects: a class's pool keeps freed objects for the next messages of that class.
//
// Messages are small, and hundreds are created and freed together (a TFMessage of 100 transforms is 601 objects).
// Python's general function to free an object of a class with __slots__ takes as long as decoding it. Without the pool,
// decoding takes 30 % longer, or more: benchmarks/native, "message pool".
#pragma once

#include <nanobind/nanobind.h>

#include <cstddef>
#include <cstdint>

namespace tfloom::bindings {

struct MessageObject {
  PyObject_HEAD
  char check_fields;
  std::uint32_t pool;  // number of its pool; 0: none
};

// The freed objects of one class. It exists as long as the class's plan. All members are guarded by the GIL; without a
// GIL, pools are empty.
class MessagePool {
 public:
  MessagePool() = default;
  MessagePool(const MessagePool&) = delete;
  MessagePool& operator=(const MessagePool&) = delete;
  ~MessagePool();

  // Replace the deallocator of a class that has slots for its fields and nothing else: no __dict__, no weak references,
  // no __del__. Do nothing for any other class; its objects are not pooled.
  void manage(PyTypeObject* type, std::size_t field_count);

  // Return a message whose slots are empty and which the garbage collector does not track yet. Throw if there is no
  // memory.
  PyObject* make(PyTypeObject* type);
  // Let the garbage collector track a message whose slots are set, or a list whose items are set.
  static void track(PyObject* object) noexcept;
  // Store this pool's number in a message that Python has allocated, if it is of the managed class.
  void tag(PyObject* message) const noexcept;

  // Keep the memory of a freed message. Return false if the pool is full.
  bool keep(PyObject* freed) noexcept;

 private:
  PyObject* take_freed() noexcept;

  PyTypeObject* type_ = nullptr;  // the managed class; null: none
  std::uint32_t number_ = 0;
  PyObject* freed_ = nullptr;  // a linked list
  std::size_t kept_ = 0;
};

}  // namespace tfloom::bindings
