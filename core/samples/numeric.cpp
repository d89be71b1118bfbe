#include "core/samples/numeric.h"

#include <cmath>

namespace aomd::sample {

glm::dvec2 on_circle(double turns) {
  const double quarters = std::floor(4 * turns + 0.5);
  const double angle = (4 * turns - quarters) * 1.5707963267948966;  // within an eighth of a turn
  double sine = 0, cosine = 0, term = 1;
  for (int power = 0; power <= 18; ++power) {
    const double signed_term = power % 4 < 2 ? term : -term;
    (power % 2 == 0 ? cosine : sine) += signed_term;
    term *= angle / (power + 1);
  }
  switch (static_cast<int>(quarters - 4 * std::floor(quarters / 4))) {
    case 1:
      return {-sine, cosine};
    case 2:
      return {-cosine, -sine};
    case 3:
      return {sine, -cosine};
    default:
      return {cosine, sine};
  }
}

double hashed(std::uint64_t index) {
  std::uint64_t x = index + 0x9e3779b97f4a7c15u;  // splitmix64
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  x ^= x >> 31;
  return static_cast<double>(x >> 11) * 0x1p-52 - 1;
}

double noise(const glm::dvec3& p) {
  const double cell[3] = {std::floor(p.x), std::floor(p.y), std::floor(p.z)};
  double blend[3];
  for (int i = 0; i < 3; ++i) {
    const double t = p[i] - cell[i];
    blend[i] = t * t * t * (t * (t * 6 - 15) + 10);
  }
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1;
    std::uint64_t key = 0;
    for (int i = 0; i < 3; ++i) {
      const int bit = corner >> i & 1;
      weight *= bit ? blend[i] : 1 - blend[i];
      key = key * 0x100000001b3u +
            static_cast<std::uint64_t>(static_cast<std::int64_t>(cell[i]) + bit);
    }
    sum += weight * hashed(key);
  }
  return sum;
}

}  // namespace aomd::sample
