// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace line_plane_segmentation {

/// Rows of text under a heading, as they stand in reports.
class Table {
 public:
  using Row = std::vector<std::string>;

  explicit Table(Row heading) : heading_(std::move(heading)) {}

  /// @param row  as many cells as the heading has
  void add(Row row) { rows_.push_back(std::move(row)); }

  /// The first column to the left, the others to the right.
  std::string markdown() const;

  /// Commas separate; no cell may hold one.
  std::string csv() const;

 private:
  Row heading_;
  std::vector<Row> rows_;
};

/// A time [ms] or a ratio with three significant digits, but no more than three after the point.
std::string threeDigits(double number);

}  // namespace line_plane_segmentation
