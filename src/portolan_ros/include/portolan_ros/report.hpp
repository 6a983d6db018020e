// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>

namespace portolan {

/// Says on stderr why the program ends, and gives its exit code. rosconsole may be down by then.
int report(const std::exception& error);

}  // namespace portolan
