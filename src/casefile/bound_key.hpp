// Keys bound to the members of a plain value: one line gives name, unit, meaning, range and member of a key.
//   {real("viscosity_g_cm_s", "g/(cm s)", "Dynamic viscosity").in(0.0, 100.0), &Fluid::viscosity}
// The member's initialiser is the key's default, and reading a case sets the member. Members may be numbers, flags,
// texts, lists, fixed arrays, std::optional of these (absent without a value), infinite numbers (absent), and any type
// that a list of values pairs with the choices of a key.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>

#include "casefile/case_file.hpp"

namespace valsalva::casefile {

template <class M>
inline constexpr bool is_optional = false;
template <class M>
inline constexpr bool is_optional<std::optional<M>> = true;
template <class M>
inline constexpr bool is_case_value =
    std::is_same_v<M, bool> || std::is_same_v<M, std::string> || std::is_same_v<M, std::vector<double>>;

/// The member as the value of a key.
template <class M>
CaseValue value_of(const M& member, const Key& key)
{
  if constexpr (is_case_value<M>) {
    return member;
  } else if constexpr (std::is_integral_v<M>) {
    return static_cast<long>(member);
  } else if constexpr (std::is_floating_point_v<M>) {
    return std::isfinite(member) ? CaseValue(member) : CaseValue();
  } else if constexpr (is_optional<M>) {
    return member ? value_of(*member, key) : CaseValue();
  } else {
    std::vector<double> list;
    for (std::size_t i = 0; i < key.count; ++i) list.push_back(member[static_cast<int>(i)]);
    return list;
  }
}

/// Sets the member; an absent value leaves it as it is.
template <class M>
void assign(M& member, const CaseValue& value)
{
  if (std::holds_alternative<std::monostate>(value)) return;
  if constexpr (is_case_value<M> || std::is_same_v<M, double>) {
    member = std::get<M>(value);
  } else if constexpr (std::is_integral_v<M>) {
    member = static_cast<M>(std::get<long>(value));
  } else if constexpr (is_optional<M>) {
    assign(member.emplace(), value);
  } else {
    const auto& list = std::get<std::vector<double>>(value);
    for (std::size_t i = 0; i < list.size(); ++i) member[static_cast<int>(i)] = list[i];
  }
}

/// A member of a member: at(&Case::time, &Time::steps, &StepControl::cfl).
template <class First, class... Rest>
auto at(First first, Rest... rest)
{
  return [=](auto& whole) -> auto&
  {
    if constexpr (sizeof...(rest) == 0)
      return std::invoke(first, whole);
    else
      return at(rest...)(std::invoke(first, whole));
  };
}

template <class T>
struct BoundKey {
  using Get = std::function<CaseValue(const T&)>;
  using Set = std::function<void(T&, const CaseValue&)>;

  /// A key that no member holds.
  explicit BoundKey(Key unbound)
      : key(std::move(unbound)), get([](const T&) { return CaseValue(); }), set([](T&, const CaseValue&) {})
  {
  }
  /// `member`: a pointer to a member of T, or `at(...)`.
  template <class Member>
  BoundKey(const Key& bound, Member member)
      : key(bound.optional()),
        get([=](const T& t) { return value_of(std::invoke(member, t), bound); }),
        set([=](T& t, const CaseValue& value) { assign(std::invoke(member, t), value); })
  {
  }
  /// A choice; `values` are the member's for each of the key's words.
  template <class Member, class Value>
  BoundKey(const Key& bound, Member member, std::vector<Value> values)
      : key(bound.optional()),
        get([=](const T& t) {
          const auto found = std::find(values.begin(), values.end(), std::invoke(member, t));
          return CaseValue(bound.choices[static_cast<std::size_t>(found - values.begin())]);
        }),
        set([=](T& t, const CaseValue& value) {
          const auto word =
              std::find(bound.choices.begin(), bound.choices.end(), std::get<std::string>(value));
          std::invoke(member, t) = values[static_cast<std::size_t>(word - bound.choices.begin())];
        })
  {
  }
  /// Anything else.
  BoundKey(const Key& bound, Get get_value, Set set_value)
      : key(bound.optional()), get(std::move(get_value)), set(std::move(set_value))
  {
  }
  /// The same key without a default: a case must give it.
  BoundKey needed() const
  {
    BoundKey k = *this;
    k.key.required = true;
    return k;
  }

  Key key;
  Get get;
  Set set;
};

template <class T>
using BoundKeys = std::vector<BoundKey<T>>;

/// The plain keys, the values of `initial` as their defaults.
template <class T>
std::vector<Key> plain_keys(const BoundKeys<T>& keys, const T& initial)
{
  std::vector<Key> plain;
  for (const BoundKey<T>& bound : keys) {
    plain.push_back(bound.key);
    if (!bound.key.required) plain.back().otherwise = bound.get(initial);
  }
  return plain;
}

/// Sets every bound member of `t` from a checked section or entry.
template <class T>
void read_keys(const BoundKeys<T>& keys, const CaseTable& table, T& t)
{
  for (const BoundKey<T>& bound : keys) bound.set(t, table.value(bound.key.name));
}

/// A section of a case of type C, and how it fills one.
template <class C>
struct BoundSection {
  KeySection keys;
  std::function<void(C&, const CaseTable&)> read;
};

/// A repeated section of a case of type C, and how it fills one.
template <class C>
struct BoundArray {
  KeyArray keys;
  std::function<void(C&, const std::vector<CaseTable>&)> read;
};

/// The section whose keys fill the part `part(c)` of a case; defaults are those of C{}.
template <class C, class T, class Part>
BoundSection<C> bound_section(const std::string& name, const std::string& meaning, Part part,
                              const BoundKeys<T>& keys)
{
  const C initial{};
  const T& initial_part = std::invoke(part, initial);
  return {{name, meaning, plain_keys(keys, initial_part)},
          [=](C& c, const CaseTable& table) { read_keys(keys, table, std::invoke(part, c)); }};
}

/// The repeated section each of whose entries becomes a T of the list `list(c)`; defaults are those of T{}.
template <class C, class T, class List>
BoundArray<C> bound_array(const std::string& name, const std::string& meaning, List list,
                          const BoundKeys<T>& keys)
{
  return {{name, meaning, plain_keys(keys, T{}), {}}, [=](C& c, const std::vector<CaseTable>& tables) {
            for (const CaseTable& table : tables) read_keys(keys, table, std::invoke(list, c).emplace_back());
          }};
}

}  // namespace valsalva::casefile
