// SPDX-License-Identifier: BSD-3-Clause
#include "lines/line_kernels.h"

#include <cstddef>
#include <cstring>

#include "kernels/multiversion.h"

namespace line_plane_segmentation {
namespace {

// Vectors by name: the compiler does not vectorise a loop whose sums stay in registers across an inner loop.
constexpr int kBlock = 8;
using Floats = float __attribute__((vector_size(kBlock * sizeof(float))));
using Doubles = double __attribute__((vector_size(kBlock * sizeof(double))));

inline void load(const float* from, Doubles& numbers) {
  Floats floats;
  std::memcpy(&floats, from, sizeof floats);
  numbers = __builtin_convertvector(floats, Doubles);
}
inline void load(const float* from, double& number) { number = static_cast<double>(*from); }

template <typename Numbers>
inline void store(const Numbers& numbers, double* to) {
  std::memcpy(to, &numbers, sizeof numbers);
}

// Sums as many windows, from `first` on, as there are Numbers.
template <typename Numbers>
inline void sumBlock(const float* z, const float* t, int pixels, int windows, int first,
                     const LineSumLanes& sums) {
  const Numbers zero = {}, one = zero + 1.0;
  Numbers n = zero, sum_t = zero, sum_tt = zero, sum_rho = zero, sum_t_rho = zero, sum_rho_rho = zero;
  for (std::ptrdiff_t k = 0; k < pixels; ++k) {
    Numbers depth, ray;
    load(z + k * windows + first, depth);
    load(t + k * windows + first, ray);
    const auto valid = depth > zero;
    ray = valid ? ray : zero;
    const Numbers rho = valid ? one / depth : zero;
    n += valid ? one : zero;
    sum_t += ray;
    sum_tt += ray * ray;
    sum_rho += rho;
    sum_t_rho += ray * rho;
    sum_rho_rho += rho * rho;
  }
  store(n, sums.n + first);
  store(sum_t, sums.t + first);
  store(sum_tt, sums.tt + first);
  store(sum_rho, sums.rho + first);
  store(sum_t_rho, sums.t_rho + first);
  store(sum_rho_rho, sums.rho_rho + first);
}

}  // namespace

LPS_MULTIVERSION
void sumWindows(const float* z, const float* t, int pixels, int windows, const LineSumLanes& sums) {
  int first = 0;
  for (; first + kBlock <= windows; first += kBlock) sumBlock<Doubles>(z, t, pixels, windows, first, sums);
  if (first == windows) return;
  // The last block overlaps the one before, whose windows receive the same sums again.
  if (windows >= kBlock) return sumBlock<Doubles>(z, t, pixels, windows, windows - kBlock, sums);
  for (; first < windows; ++first) sumBlock<double>(z, t, pixels, windows, first, sums);
}

}  // namespace line_plane_segmentation
