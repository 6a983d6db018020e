// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <locale>
#include <string>

namespace portolan {

/// While it lives, C++ streams write "1.234,5" as they do in much of Europe.
class CommaLocale {
 public:
  CommaLocale() : before_(std::locale::global({std::locale::classic(), new Punctuation})) {}
  ~CommaLocale() { std::locale::global(before_); }
  CommaLocale(const CommaLocale&) = delete;
  CommaLocale& operator=(const CommaLocale&) = delete;

 private:
  struct Punctuation : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };

  std::locale before_;
};

}  // namespace portolan
