// SPDX-License-Identifier: BSD-3-Clause
#include "lines/line_kernels.h"

#include <cstddef>
#include <cstring>

#include "kernels/multiversion.h"

namespace line_plane_segmentation {
namespace {

// Vectors by name: the compiler does not vectorise a loop whose sums stay in registers across an inner loop.
constexpr int kBlock = 4;  // doubles of AVX2: GCC passes longer vectors through memory
using Floats = float __attribute__((vector_size(kBlock * sizeof(float))));
using Doubles = double __attribute__((vector_size(kBlock * sizeof(double))));

inline void convert(const Floats& from, Doubles& to) { to = __builtin_convertvector(from, Doubles); }
inline void convert(float from, double& to) { to = static_cast<double>(from); }

template <typename Numbers>
inline void store(const Numbers& numbers, double* to) {
  std::memcpy(to, &numbers, sizeof numbers);
}

// Sums as many windows, from `first` on, as there are numbers in `Single`. Inverse depths are divided in
// single precision, which is finer than any sensor's steps, and summed in double precision.
template <typename Single, typename Double>
inline void sumBlock(const float* z, const float* t, int pixels, int windows, int first,
                     const LineSumLanes& sums) {
  const Single none = {}, one = none + 1.0F;
  const Double zero = {};
  Single n = none;
  Double sum_t = zero, sum_tt = zero, sum_rho = zero, sum_t_rho = zero, sum_rho_rho = zero;
  for (std::ptrdiff_t k = 0; k < pixels; ++k) {
    Single depth, single_ray;
    std::memcpy(&depth, z + k * windows + first, sizeof depth);
    std::memcpy(&single_ray, t + k * windows + first, sizeof single_ray);
    const auto valid = depth > none;
    n += valid ? one : none;
    const Single valid_ray = valid ? single_ray : none, single_rho = valid ? one / depth : none;
    Double ray, rho;
    convert(valid_ray, ray);
    convert(single_rho, rho);
    sum_t += ray;
    sum_tt += ray * ray;
    sum_rho += rho;
    sum_t_rho += ray * rho;
    sum_rho_rho += rho * rho;
  }
  Double count;
  convert(n, count);
  store(count, sums.n + first);
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
  for (; first + kBlock <= windows; first += kBlock)
    sumBlock<Floats, Doubles>(z, t, pixels, windows, first, sums);
  if (first == windows) return;
  // The last block overlaps the one before, whose windows receive the same sums again.
  if (windows >= kBlock) return sumBlock<Floats, Doubles>(z, t, pixels, windows, windows - kBlock, sums);
  for (; first < windows; ++first) sumBlock<float, double>(z, t, pixels, windows, first, sums);
}

}  // namespace line_plane_segmentation
