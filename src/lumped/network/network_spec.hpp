// A lumped network as the case file describes it: plain data, nothing checked yet.
// Names of parameters are the case file's keys and carry their unit ("Rp_mmHg_s_ml"). Inside the lumped layer
// everything is in mmHg, ml and s.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace valsalva::lumped {

struct ElementSpec {
  std::string name;
  std::string type;
  std::map<std::string, std::string> nodes;          ///< terminal ("node", or "from" and "to") -> node name
  std::map<std::string, double> numbers;             ///< one number per key
  std::map<std::string, std::vector<double>> lists;  ///< a constant may come as a list of one
  std::map<std::string, std::string> words;
};

struct NetworkSpec {
  std::vector<ElementSpec> elements;
  std::vector<std::string> ports;           ///< nodes that meet a 3D opening, in the order of the port flows
  double period_s = 0.0;                    ///< length of a heart beat; 0: the case names none
  std::vector<std::string> integrals = {};  ///< observables ("Q_aortic_ml_s") whose time integrals are states
  bool balance = false;                     ///< integrate what `Balance` counts (network.hpp) as well
};

}  // namespace valsalva::lumped
