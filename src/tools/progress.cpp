// SPDX-License-Identifier: BSD-3-Clause
#include "progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace line_plane_segmentation {
namespace {

std::string clockText(double seconds) {
  const auto total = static_cast<long>(std::lround(seconds));
  char text[32];
  if (total >= 3600) {
    std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", total / 3600, total / 60 % 60, total % 60);
  } else {
    std::snprintf(text, sizeof text, "%ld:%02ld", total / 60, total % 60);
  }
  return text;
}

}  // namespace

std::string progressText(std::size_t done, double fraction, double seconds) {
  constexpr int kWidth = 28;
  fraction = std::min(std::max(fraction, 0.0), 1.0);
  const auto filled = static_cast<std::size_t>(fraction * kWidth);
  std::string bar(kWidth, ' ');
  std::fill_n(bar.begin(), filled, '=');
  if (filled < bar.size()) bar[filled] = '>';

  const double rate = seconds > 0.0 ? static_cast<double>(done) / seconds : 0.0;
  char figures[96];
  std::snprintf(figures, sizeof figures, "] %3.0f %%  %zu frames  %.*f/s", std::floor(100.0 * fraction), done,
                rate < 10.0 ? 1 : 0, rate);
  std::string text = "[" + bar + figures;
  if (fraction > 0.0 && fraction < 1.0)
    text += "  " + clockText(seconds * (1.0 - fraction) / fraction) + " left";
  return text;
}

Progress::Progress() : on_terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() { clear(); }

void Progress::update(std::size_t done, double fraction) {
  constexpr std::chrono::milliseconds kRedraw(100);
  constexpr std::chrono::seconds kLine(30);
  const Clock::time_point now = Clock::now();
  const bool due = on_terminal_ ? !visible_ || now - shown_ >= kRedraw : now - shown_ >= kLine;
  if (!due) return;
  shown_ = now;
  visible_ = on_terminal_;
  const std::string text = progressText(done, fraction, std::chrono::duration<double>(now - start_).count());
  std::fprintf(stderr, on_terminal_ ? "\r%s\x1b[K" : "%s\n", text.c_str());
}

void Progress::clear() {
  if (visible_) std::fputs("\r\x1b[K", stderr);
  visible_ = false;
}

}  // namespace line_plane_segmentation
