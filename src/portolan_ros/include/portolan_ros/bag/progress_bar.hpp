// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <string>

namespace portolan {

/// Shows how far long work has come: a bar that moves on a terminal, a line each tenth elsewhere.
class ProgressBar {
 public:
  ProgressBar(std::ostream& out, bool is_terminal, std::string label);

  /// `done` in [0, 1]. Writes only where the picture changes.
  void show(double done);

  /// Fills the bar and ends the line.
  void finish();

 private:
  std::ostream& out_;
  bool is_terminal_;
  std::string label_;
  int shown_ = -1;  // [%], the last that was written
};

}  // namespace portolan
