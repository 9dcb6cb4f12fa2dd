// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>

#include "planes/crossing_candidates.h"

namespace line_plane_segmentation {

/// A grid of candidates that are made of numbers. The ray of a candidate is its column and its row.
struct MadeCandidates : CandidateGrid {
  MadeCandidates(int column_count, int row_count) {
    spacing = 10;
    columns = column_count;
    rows = row_count;
    candidate_at.assign(static_cast<std::size_t>(crossings()), -1);
  }

  /// Adds a candidate with twelve pixels of inverse depth `rho`, close to its crossing, and a tolerance of 1.
  void add(int column, int row, double rho) {
    CrossingCandidate candidate;
    for (const auto& [right, down] : {std::pair(-1, 0), std::pair(1, 0), std::pair(0, -1), std::pair(0, 1)}) {
      const double x = column + 1e-4 * right, y = row + 1e-4 * down, n = 3.0;
      candidate.moments += {n * x * x,   n * x * y,   n * y * y, n * x,         n * y, n,
                            n * x * rho, n * y * rho, n * rho,   n * rho * rho, n};
    }
    candidate.x = column;
    candidate.y = row;
    candidate.rho = rho;
    candidate.inv_tolerance = 1.0;
    candidate.cell = indexOf(column, row);
    candidate_at[static_cast<std::size_t>(candidate.cell)] = static_cast<int>(candidates.size());
    candidates.push_back(candidate);
  }

  void link(int column, int row, int other_column, int other_row) {
    const auto candidate = [this](int at_column, int at_row) {
      return candidate_at[static_cast<std::size_t>(indexOf(at_column, at_row))];
    };
    links.push_back({candidate(column, row), candidate(other_column, other_row)});
  }

  /// Links neighbours in some columns, all rows of them.
  void linkColumns(int first, int end) {
    for (int row = 0; row < rows; ++row) {
      for (int column = first; column < end; ++column) {
        if (column + 1 < end) link(column, row, column + 1, row);
        if (row + 1 < rows) link(column, row, column, row + 1);
      }
    }
  }
};

}  // namespace line_plane_segmentation
