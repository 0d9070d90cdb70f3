// What a case is refused with.
#pragma once

#include <string>
#include <utility>

#include "common/error.hpp"

namespace valsalva {

/// The whole text of the CaseError that `action` throws; empty if it throws none.
template <class Action>
std::string complaint(Action&& action)
{
  try {
    std::forward<Action>(action)();
  } catch (const CaseError& error) {
    return error.what();
  }
  return "";
}

}  // namespace valsalva
