#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "casefile/case_file.hpp"

namespace valsalva::casefile {

namespace {

template <class Wanted>
const Wanted& wanted_kind(const CaseTable& table, std::string_view key)
{
  const auto* value = std::get_if<Wanted>(&table.value(key));
  if (!value)
    throw std::logic_error(fmt::format("key '{}.{}' is absent or of another kind", table.path(), key));
  return *value;
}

}  // namespace

CaseTable::CaseTable(std::string path, std::vector<Key> keys, CasePlace place)
    : path_(std::move(path)),
      keys_(std::move(keys)),
      place_(std::move(place)),
      places_(keys_.size()),
      given_(keys_.size(), false)
{
  for (const Key& key : keys_) values_.push_back(key.otherwise);
}

std::size_t CaseTable::index(std::string_view key) const
{
  for (std::size_t i = 0; i < keys_.size(); ++i)
    if (keys_[i].name == key) return i;
  throw std::logic_error(fmt::format("no key '{}' in the key table of '{}'", key, path_));
}

double CaseTable::real(std::string_view key) const
{
  return wanted_kind<double>(*this, key);
}
int CaseTable::integer(std::string_view key) const
{
  return static_cast<int>(wanted_kind<long>(*this, key));
}
bool CaseTable::flag(std::string_view key) const
{
  return wanted_kind<bool>(*this, key);
}

const std::string& CaseTable::text(std::string_view key) const
{
  return wanted_kind<std::string>(*this, key);
}

const std::vector<double>& CaseTable::reals(std::string_view key) const
{
  return wanted_kind<std::vector<double>>(*this, key);
}

bool CaseTable::knows(std::string_view key) const
{
  return std::any_of(keys_.begin(), keys_.end(), [&](const Key& k) { return k.name == key; });
}

bool CaseTable::has(std::string_view key) const
{
  return !std::holds_alternative<std::monostate>(value(key));
}
bool CaseTable::is_given(std::string_view key) const
{
  return given_[index(key)];
}
const CaseValue& CaseTable::value(std::string_view key) const
{
  return values_[index(key)];
}

CasePlace CaseTable::place(std::string_view key) const
{
  for (std::size_t i = 0; i < keys_.size(); ++i)
    if (keys_[i].name == key && given_[i]) return places_[i];
  return place_;
}

CaseProblem CaseTable::problem(std::string_view key, const std::string& message) const
{
  const CasePlace at = place(key);
  std::string full = path_;
  if (!key.empty() && !full.empty()) full += '.';
  full += key;
  return {at.file, at.line, at.column, full, message};
}

void CaseTable::set(std::string_view key, CaseValue value, CasePlace place, bool given)
{
  const std::size_t i = index(key);
  values_[i] = std::move(value);
  places_[i] = std::move(place);
  given_[i] = given;
}

}  // namespace valsalva::casefile
