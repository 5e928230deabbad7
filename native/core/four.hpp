// Four numbers that are computed at once, in a register if the compiler has vector types.
#pragma once

#include <array>
#include <cstddef>

namespace tfloom {

template <class T>
struct FourTypes {
  // Without it, do_transform_cloud of padded points takes 20 % longer: benchmarks/native, "four at once".
#ifdef __GNUC__
  typedef T Four __attribute__((vector_size(4 * sizeof(T))));
#else
  struct Four {
    std::array<T, 4> values;

    T& operator[](std::size_t i) { return values[i]; }
    friend Four operator+(const Four& a, const Four& b) {
      return {{a.values[0] + b.values[0], a.values[1] + b.values[1], a.values[2] + b.values[2],
               a.values[3] + b.values[3]}};
    }
    friend Four operator*(const Four& a, T b) {
      return {{a.values[0] * b, a.values[1] * b, a.values[2] * b, a.values[3] * b}};
    }
  };
#endif
};

template <class T>
using Four = typename FourTypes<T>::Four;

}  // namespace tfloom
