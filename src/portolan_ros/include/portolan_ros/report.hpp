// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <optional>

namespace portolan {

/// Says on stderr why the program ends, and gives its exit code. rosconsole may be down by then.
int report(const std::exception& error);

/// The exit code of a program that somebody asks for --help, or gives too few or too many
/// arguments: it has then said how it is called. None where it may go on. `usage`: lines, ended.
std::optional<int> exit_with_usage(int argc, char** argv, int least, int most, const char* usage);

}  // namespace portolan
