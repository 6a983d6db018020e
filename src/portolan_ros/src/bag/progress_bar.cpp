// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/bag/progress_bar.hpp"

#include <algorithm>
#include <ostream>
#include <utility>

namespace portolan {

ProgressBar::ProgressBar(std::ostream& out, bool is_terminal, std::string label)
    : out_(out), is_terminal_(is_terminal), label_(std::move(label)) {}

void ProgressBar::show(double done) {
  constexpr int kWidth = 40;
  const int percent = done > 0.0 ? static_cast<int>(100.0 * std::min(done, 1.0)) : 0;
  const int step = is_terminal_ ? 1 : 10;
  if (percent / step == shown_ / step && shown_ >= 0) return;
  shown_ = percent;
  if (is_terminal_) {
    const auto filled = static_cast<std::size_t>(kWidth * percent / 100);
    out_ << '\r' << label_ << " [" << std::string(filled, '#') << std::string(kWidth - filled, ' ')
         << "] " << percent << " %" << std::flush;
  } else {
    out_ << label_ << ' ' << percent << " %" << std::endl;
  }
}

void ProgressBar::finish() {
  show(1.0);
  if (is_terminal_) out_ << std::endl;
}

}  // namespace portolan
