// SPDX-License-Identifier: BSD-3-Clause
#include "portolan_ros/report.hpp"

#include <cstdlib>
#include <iostream>
#include <string>

namespace portolan {

int report(const std::exception& error) {
  std::cerr << "portolan: " << error.what() << std::endl;
  return EXIT_FAILURE;
}

std::optional<int> exit_with_usage(int argc, char** argv, int least, int most, const char* usage) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--help" || word == "-h") {
      std::cout << usage;
      return EXIT_SUCCESS;
    }
  }
  if (argc - 1 >= least && argc - 1 <= most) return std::nullopt;
  std::cerr << usage;
  return EXIT_FAILURE;
}

}  // namespace portolan
