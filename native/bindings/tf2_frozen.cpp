// Freezing a buffer to bytes, and mapping such bytes.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <cstring>
#include <memory>
#include <stdexcept>
#include <vector>

#include "bindings/gil.hpp"
#include "bindings/tf2_buffer.hpp"
#include "tf2/frozen.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace tfloom::bindings {
namespace {

using Bytes = nb::ndarray<const std::uint8_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

nb::bytes freeze(const BufferHandle& self) {
  std::vector<std::byte> bytes;
  {
    const ReleasedGil release;
    bytes = self.buffer->freeze();
  }
  // No other thread has a reference to the object yet, so it may be filled without the GIL.
  nb::bytes frozen = nb::steal<nb::bytes>(
      PyBytes_FromStringAndSize(nullptr, static_cast<Py_ssize_t>(bytes.size())));
  if (!frozen.is_valid()) throw nb::python_error();
  char* const data = PyBytes_AS_STRING(frozen.ptr());
  {
    const ReleasedGil release;
    std::memcpy(data, bytes.data(), bytes.size());
    std::vector<std::byte>().swap(bytes);  // free the memory without the GIL, because that takes long too
  }
  return frozen;
}

void map_frozen(BufferHandle& self, const Bytes& data) {
  const auto owner = std::make_shared<Bytes>(data);  // nanobind acquires the GIL to release it
  const std::span bytes(reinterpret_cast<const std::byte*>(owner->data()), owner->size());
  const ReleasedGil release;
  try {
    self.buffer->map(bytes, owner);
  } catch (const tf2::FrozenError& error) {
    throw std::invalid_argument(error.what());
  }
}

}  // namespace

void bind_tf2_frozen(nb::class_<BufferHandle>& type) {
  type.def("frozen", &freeze, "Return the whole contents as the bytes of a frozen buffer.")
      .def("map_frozen", &map_frozen, "data"_a,
           nb::sig("def map_frozen(self, data: bytes | memoryview) -> None"),
           "Replace the whole contents and the cache time by those of a frozen buffer.\n\n"
           "`data` is what `frozen` returned. It is not copied, and must not change. Raises ValueError, with nothing "
           "changed, if it is not a frozen buffer.");
}

}  // namespace tfloom::bindings
