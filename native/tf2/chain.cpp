#include "tf2/chain.hpp"

#include <cstring>

namespace tfloom::tf2 {
namespace {

// Two doubles, in one register where the compiler has a vector type.
#ifdef __GNUC__
using Two = double __attribute__((vector_size(16)));
#else
struct Two {
  double first, second;

  friend constexpr Two operator+(Two a, Two b) { return {a.first + b.first, a.second + b.second}; }
  friend constexpr Two operator-(Two a, Two b) { return {a.first - b.first, a.second - b.second}; }
  friend constexpr Two operator*(Two a, Two b) { return {a.first * b.first, a.second * b.second}; }
};
#endif

// Two transforms, element by element.
struct Pair {
  Two px, py, pz, qx, qy, qz, qw;

  Pair(const Transform& a, const Transform& b)
      : px{a.translation.x, b.translation.x},
        py{a.translation.y, b.translation.y},
        pz{a.translation.z, b.translation.z},
        qx{a.rotation.x, b.rotation.x},
        qy{a.rotation.y, b.rotation.y},
        qz{a.rotation.z, b.rotation.z},
        qw{a.rotation.w, b.rotation.w} {}

  // Replace this pair by its product with `b` on the right. The translation depends on the previous one only through a
  // sum, which keeps the chain of dependent operations short.
  void append(const Pair& b) {
    const Two cx = qy * b.pz - qz * b.py, cy = qz * b.px - qx * b.pz, cz = qx * b.py - qy * b.px;
    const Two tx = cx + cx, ty = cy + cy, tz = cz + cz;
    px = px + (b.px + qw * tx + (qy * tz - qz * ty));
    py = py + (b.py + qw * ty + (qz * tx - qx * tz));
    pz = pz + (b.pz + qw * tz + (qx * ty - qy * tx));
    const Two x = (qw * b.qx + qx * b.qw) + (qy * b.qz - qz * b.qy);
    const Two y = (qw * b.qy - qx * b.qz) + (qy * b.qw + qz * b.qx);
    const Two z = (qw * b.qz + qx * b.qy) + (qz * b.qw - qy * b.qx);
    qw = (qw * b.qw - qx * b.qx) - (qy * b.qy + qz * b.qz);
    qx = x;
    qy = y;
    qz = z;
  }

  void get(Transform& a, Transform& b) const {
    const auto put = [](Two from, double& first, double& second) {
      double numbers[2];
      std::memcpy(numbers, &from, sizeof numbers);
      first = numbers[0];
      second = numbers[1];
    };
    put(px, a.translation.x, b.translation.x);
    put(py, a.translation.y, b.translation.y);
    put(pz, a.translation.z, b.translation.z);
    put(qx, a.rotation.x, b.rotation.x);
    put(qy, a.rotation.y, b.rotation.y);
    put(qz, a.rotation.z, b.rotation.z);
    put(qw, a.rotation.w, b.rotation.w);
  }
};

}  // namespace

void ChainProduct::fold() {
  // The product of a long row of links is computed as two halves at once, one in each lane, and then those two. The
  // links are in order from the bottom up, so each product grows from its upper end. An odd link remains for the top.
  Transform* const all = links();
  Transform product;
  if (count_ < 4) {
    product = all[count_ - 1];
    for (std::size_t i = count_ - 1; i-- > 0;) product = product * all[i];
  } else {
    const std::size_t half = count_ / 2;
    Pair pair(all[half - 1], all[2 * half - 1]);
    for (std::size_t i = half - 1; i-- > 0;) pair.append({all[i], all[half + i]});
    Transform lower, upper;
    pair.get(lower, upper);
    product = upper * lower;
    if (count_ % 2 == 1) product = all[count_ - 1] * product;
  }
  *all = product;
  count_ = 1;
}

}  // namespace tfloom::tf2
