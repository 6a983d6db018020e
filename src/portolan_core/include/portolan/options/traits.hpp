// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>
#include <utility>
#include <vector>

namespace portolan::options_detail {

struct ProbeVisitor {
  template <class... Arguments>
  void operator()(Arguments&&...) {}
  void require(bool, const char*) {}
};

template <class T, class = void>
struct IsDescribed : std::false_type {};
template <class T>
struct IsDescribed<
    T, std::void_t<decltype(T::describe(std::declval<T&>(), std::declval<ProbeVisitor&>()))>>
    : std::true_type {};

template <class T>
struct IsList : std::false_type {};
template <class T>
struct IsList<std::vector<T>> : std::true_type {};

/// A struct of options: it has `describe`.
template <class T>
inline constexpr bool kIsGroup = IsDescribed<std::remove_const_t<T>>::value;
/// A std::vector of options or of groups of them.
template <class T>
inline constexpr bool kIsList = IsList<std::remove_const_t<T>>::value;
/// A number; bool is none.
template <class T>
inline constexpr bool kIsNumber =
    std::is_arithmetic_v<T> && !std::is_same_v<std::remove_const_t<T>, bool>;

}  // namespace portolan::options_detail
