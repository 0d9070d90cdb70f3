// What an element is built from: its checked spec, its node numbers and the case's heart period; numbers come
// as the element's scalar. For `Dual`, the i-th name of `seeded` ("arteries.Rp_mmHg_s_ml") is the parameter
// along which the i-th tangent is taken: it gets the derivative 1 there.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lumped/network/dual.hpp"
#include "lumped/network/network_spec.hpp"

namespace valsalva::lumped {

template <class Scalar>
class ElementInput {
 public:
  ElementInput(const ElementSpec& spec, std::vector<int> nodes, double case_period_s,
               std::span<const std::string> seeded)
      : spec_(spec), nodes_(std::move(nodes)), case_period_s_(case_period_s), seeded_(seeded)
  {
  }

  const std::string& name() const { return spec_.name; }
  const std::vector<int>& nodes() const { return nodes_; }
  double case_period_s() const { return case_period_s_; }

  bool has(const std::string& key) const { return spec_.numbers.count(key) > 0; }
  Scalar number(const std::string& key) const { return seeded(spec_.numbers.at(key), key); }
  /// A list; empty if it is absent. The one entry of a constant may be seeded.
  std::vector<Scalar> list(const std::string& key) const
  {
    std::vector<Scalar> values;
    if (const auto found = spec_.lists.find(key); found != spec_.lists.end())
      values.assign(found->second.begin(), found->second.end());
    if (values.size() == 1) values[0] = seeded(value_of(values[0]), key);
    return values;
  }
  const std::string& word(const std::string& key) const { return spec_.words.at(key); }

 private:
  Scalar seeded(double value, const std::string& key) const
  {
    Scalar result(value);
    if constexpr (!std::is_same_v<Scalar, double>)
      for (std::size_t lane = 0; lane < seeded_.size(); ++lane)
        if (seeded_[lane] == spec_.name + "." + key) result.tangent[static_cast<Eigen::Index>(lane)] = 1.0;
    return result;
  }

  const ElementSpec& spec_;
  std::vector<int> nodes_;
  double case_period_s_;
  std::span<const std::string> seeded_;
};

}  // namespace valsalva::lumped
