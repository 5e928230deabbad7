#include "tf2/columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "core/vector_width.hpp"

// Compilers vectorise the loops so marked, because no iteration reads what another one wrote. Without vectors,
// lookup_many takes twice as long: benchmarks/native, "columns".
#if defined(__clang__)
#define TFLOOM_INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define TFLOOM_INDEPENDENT _Pragma("GCC ivdep")
#else
#define TFLOOM_INDEPENDENT
#endif

namespace tfloom::tf2 {
namespace {

// Vectors of two doubles, which every x86-64 (SSE2) and 64-bit ARM (NEON) has; without GCC's vector types, one double.
namespace narrow {

#define TFLOOM_TARGET
#ifdef __GNUC__
typedef double Lanes __attribute__((vector_size(16)));

template <class Part>
Lanes lanes_of(const Transform* const* rows, Part Transform::*part, double Part::*number) {
  return Lanes{rows[0]->*part.*number, rows[1]->*part.*number};
}
#else
using Lanes = double;

template <class Part>
Lanes lanes_of(const Transform* const* rows, Part Transform::*part, double Part::*number) {
  return rows[0]->*part.*number;
}
#endif
constexpr std::size_t lane_count = sizeof(Lanes) / sizeof(double);

#include "tf2/column_arithmetic.hpp"

}  // namespace narrow

#ifdef TFLOOM_WIDE_TARGET

// Vectors of four doubles. Without them, lookup_many takes 40 % longer: benchmarks/native, "wide vectors".
namespace wide {

#undef TFLOOM_TARGET
#define TFLOOM_TARGET TFLOOM_WIDE_TARGET
typedef double Lanes __attribute__((vector_size(32)));

template <class Part>
TFLOOM_TARGET Lanes lanes_of(const Transform* const* rows, Part Transform::*part, double Part::*number) {
  return Lanes{rows[0]->*part.*number, rows[1]->*part.*number, rows[2]->*part.*number, rows[3]->*part.*number};
}
constexpr std::size_t lane_count = sizeof(Lanes) / sizeof(double);

#include "tf2/column_arithmetic.hpp"

}  // namespace wide

#endif

}  // namespace

const ColumnArithmetic& column_arithmetic() {
#ifdef TFLOOM_WIDE_TARGET
  if (vectors_are_wide()) return wide::arithmetic;
#endif
  return narrow::arithmetic;
}

}  // namespace tfloom::tf2
