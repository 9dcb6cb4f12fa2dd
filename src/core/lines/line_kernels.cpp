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

inline void convert(const Floats& from, Doubles& to) { to = __builtin_convertvector(from, Doubles); }
inline void convert(float from, double& to) { to = static_cast<double>(from); }

template <typename Numbers>
inline void store(const Numbers& numbers, double* to) {
  std::memcpy(to, &numbers, sizeof numbers);
}

// Sums as many windows, from `first` on, as there are numbers in `Single`. Distances from a window's first
// ray and from the inverse depth of its first valid pixel are small, so that single precision is finer than
// any sensor's steps.
template <typename Single, typename Double>
inline void sumBlock(const float* z, const float* t, int pixels, int windows, int first,
                     const LineSumLanes& sums) {
  const Single none = {}, one = none + 1.0F;
  Single n = none, t_0 = none, rho_0 = none;
  Single dt = none, dt_dt = none, dr = none, dt_dr = none, dr_dr = none;
  std::memcpy(&t_0, t + first, sizeof t_0);
  for (std::ptrdiff_t k = 0; k < pixels; ++k) {
    Single depth, ray;
    std::memcpy(&depth, z + k * windows + first, sizeof depth);
    std::memcpy(&ray, t + k * windows + first, sizeof ray);
    const auto valid = depth > none;
    const Single rho = one / depth;
    rho_0 = valid & (n == none) ? rho : rho_0;
    n += valid ? one : none;
    const Single t_from = valid ? ray - t_0 : none, rho_from = valid ? rho - rho_0 : none;
    dt += t_from;
    dt_dt += t_from * t_from;
    dr += rho_from;
    dt_dr += t_from * rho_from;
    dr_dr += rho_from * rho_from;
  }
  Double count, t0, rho0, t1, tt, rho1, t_rho, rho_rho;
  convert(n, count);
  convert(t_0, t0);
  convert(rho_0, rho0);
  convert(dt, t1);
  convert(dt_dt, tt);
  convert(dr, rho1);
  convert(dt_dr, t_rho);
  convert(dr_dr, rho_rho);
  const Double sum_t = t1 + count * t0, sum_rho = rho1 + count * rho0;
  store(count, sums.n + first);
  store(sum_t, sums.t + first);
  store(tt + t0 * (t1 + sum_t), sums.tt + first);
  store(sum_rho, sums.rho + first);
  store(t_rho + t0 * rho1 + rho0 * sum_t, sums.t_rho + first);
  store(rho_rho + rho0 * (rho1 + sum_rho), sums.rho_rho + first);
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
