// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace portolan {

/// How often this thread has asked for memory with `new` so far.
std::size_t allocations();

}  // namespace portolan
