// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/report.hpp"

#include <cstdlib>
#include <iostream>

namespace portolan {

int report(const std::exception& error) {
  std::cerr << "portolan: " << error.what() << std::endl;
  return EXIT_FAILURE;
}

}  // namespace portolan
