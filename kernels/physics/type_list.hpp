// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

/// Lists of laws, repulsions and schemes, std::tuple<A, B, ...>, each type with a `name`.
namespace bagnold {

namespace detail {

template <class... T, class Use>
void each_of(std::tuple<T...> const*, Use const& use) {
  (use(std::type_identity<T>{}), ...);
}

}  // namespace detail

/// Calls use(std::type_identity<T>) for each type of a list.
template <class List, class Use>
void for_each_type(Use const& use) {
  detail::each_of(static_cast<List const*>(nullptr), use);
}

/// Names of a list, in its order.
template <class List>
std::vector<std::string_view> names_of() {
  std::vector<std::string_view> names;
  for_each_type<List>([&]<class T>(std::type_identity<T>) { names.push_back(T::name); });
  return names;
}

/// Calls use(std::type_identity<T>) with the type of that name in a list; a value-initialised
/// result if there is none.
template <class List, class Use>
auto with_named(std::string_view name, Use const& use) {
  using Result = decltype(use(std::type_identity<std::tuple_element_t<0, List>>{}));
  if constexpr (std::is_void_v<Result>) {
    for_each_type<List>([&]<class T>(std::type_identity<T> type) {
      if (name == T::name) use(type);
    });
  } else {
    Result result{};
    for_each_type<List>([&]<class T>(std::type_identity<T> type) {
      if (name == T::name) result = use(type);
    });
    return result;
  }
}

}  // namespace bagnold
