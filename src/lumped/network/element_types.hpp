// The declarative table of element types: terminals and parameters with unit, range, default and meaning. The
// case file's key table, its validation and the documentation of keys come from here. Each type's entry
// stands in the element's own file, beside its equations; a new element is added to the list in
// element_types.cpp.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/error.hpp"
#include "lumped/network/element.hpp"
#include "lumped/network/network_spec.hpp"

namespace valsalva::lumped {

enum class ParameterKind { number, list, word };

struct ElementParameter {
  std::string name = {};                       ///< the case file's key, unit as its ending
  std::string unit = {};                       ///< human-readable, "mmHg s/ml"; empty if it has none
  ParameterKind kind = ParameterKind::number;  ///< a list may be given as one number: a constant
  std::string quantity = {};                   ///< with its article, for messages: "a resistance"
  bool required = true;                        ///< false: may be absent; with a default it is filled in
  std::optional<double> default_number = {};
  std::string default_word = {};
  double lowest = -std::numeric_limits<double>::infinity();  ///< for lists, of every entry
  double highest = std::numeric_limits<double>::infinity();
  bool lowest_excluded = false;           ///< the value must lie above `lowest`
  std::vector<std::string> choices = {};  ///< of a word
  std::optional<double> usual = {};       ///< an adult value, offered in messages and in the template of keys
  std::string meaning = {};               ///< one line
};

/// Builds the element of a checked and completed spec.
template <class Scalar>
using ElementFactory = std::unique_ptr<Element<Scalar>> (*)(const ElementInput<Scalar>&);

template <template <class> class Type, class Scalar>
std::unique_ptr<Element<Scalar>> make_element(const ElementInput<Scalar>& input)
{
  return std::make_unique<Type<Scalar>>(input);
}

/// A type's entry in the table.
struct ElementType {
  std::string name = {};
  std::vector<std::string> terminals = {};  ///< "node", or "from" and "to"
  std::vector<ElementParameter> parameters = {};
  std::string meaning = {};
  ElementFactory<double> factory = nullptr;
  ElementFactory<Dual> dual_factory = nullptr;
  /// Adds what the ranges cannot express (two keys that must fit together); may be null.
  void (*check)(const ElementSpec&, double period_s, std::vector<CaseProblem>&) = nullptr;
};

/// In the order of the documentation.
const std::vector<ElementType>& element_types();

/// The type of this name, or nullptr.
const ElementType* find_element_type(const std::string& name);

/// The element of a type that exists.
template <class Scalar>
std::unique_ptr<Element<Scalar>> build_element(const ElementInput<Scalar>& input, const std::string& type)
{
  const ElementType* found = find_element_type(type);
  if constexpr (std::is_same_v<Scalar, double>)
    return found->factory(input);
  else
    return found->dual_factory(input);
}

/// `element "arteries"`, or `element "arteries": Rp_mmHg_s_ml`: how problems name the place.
std::string element_key(const ElementSpec& element, const std::string& parameter = "");

}  // namespace valsalva::lumped
