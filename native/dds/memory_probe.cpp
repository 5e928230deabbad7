#include "dds/memory_probe.hpp"

#include <cstring>
#include <vector>

#ifndef _WIN32
#include <unistd.h>
#endif

namespace tfloom::dds {

bool copy_if_readable(const void* place, void* copy, std::size_t size) {
#ifdef _WIN32
  if (place == nullptr) return false;
  std::memcpy(copy, place, size);
  return true;
#else
  // The kernel reads it: where there is no memory, `write` returns an error, and no signal is raised.
  int ends[2];
  if (place == nullptr || pipe(ends) != 0) return false;
  const auto expected = static_cast<ssize_t>(size);
  const bool is_copied = write(ends[1], place, size) == expected && read(ends[0], copy, size) == expected;
  close(ends[0]);
  close(ends[1]);
  return is_copied;
#endif
}

bool is_readable(const void* place, std::size_t size) {
  std::vector<std::byte> copy(size);
  return copy_if_readable(place, copy.data(), size);
}

bool is_text(const char* found, const char* expected) {
  const std::size_t size = std::strlen(expected) + 1;
  std::vector<char> copy(size);
  return copy_if_readable(found, copy.data(), size) && std::memcmp(copy.data(), expected, size) == 0;
}

}  // namespace tfloom::dds
