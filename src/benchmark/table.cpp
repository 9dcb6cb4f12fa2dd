// SPDX-License-Identifier: BSD-3-Clause
#include "table.h"

#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

namespace line_plane_segmentation {
namespace {

std::string markdownRow(const Table::Row& row) { return "| " + boost::algorithm::join(row, " | ") + " |\n"; }

}  // namespace

std::string Table::markdown() const {
  std::string text = markdownRow(heading_) + "|---|";
  for (std::size_t i = 1; i < heading_.size(); ++i) text += "--:|";
  text += '\n';
  for (const Row& row : rows_) text += markdownRow(row);
  return text;
}

std::string Table::csv() const {
  std::string text = boost::algorithm::join(heading_, ",") + '\n';
  for (const Row& row : rows_) text += boost::algorithm::join(row, ",") + '\n';
  return text;
}

std::string threeDigits(double number) {
  const int digits_before = number >= 1.0 ? static_cast<int>(std::floor(std::log10(number))) + 1 : 0;
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::fixed << std::setprecision(std::max(0, 3 - digits_before)) << number;
  return text.str();
}

}  // namespace line_plane_segmentation
