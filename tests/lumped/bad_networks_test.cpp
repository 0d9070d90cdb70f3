// Every network that cannot be solved, and every wrong parameter, is answered by the promised sentence.
#include <gtest/gtest.h>

#include "lumped/network/element_types.hpp"
#include "lumped/refusal.hpp"
#include "lumped/specs.hpp"

namespace valsalva::lumped::testing {

namespace {

void expect_said(const NetworkSpec& spec, const std::vector<std::string>& parts)
{
  const std::string text = refusal(spec);
  for (const std::string& part : parts)
    EXPECT_NE(text.find(part), std::string::npos) << part << "\nnot in\n" << text;
}

}  // namespace

TEST(BadNetwork, ADanglingValveIsNamedWithItsNode)
{
  expect_said(
      {{pressure_source("veins", "la", 10.0), valve("mitral", "la", "lv", 0.01), windkessel("w", "ao")},
       {},
       0.0},
      {"node \"lv\": is joined to \"mitral\" alone", "the nodes are \"la\", \"lv\", \"ao\""});
}

TEST(BadNetwork, TwoElementsThatFixOnePressureAreBothNamed)
{
  expect_said({{pressure_source("veins", "lv", 10.0), chamber("ventricle", "lv")}, {}, 0.0},
              {"node \"lv\": has its pressure fixed by \"veins\", \"ventricle\" at once"});
  ElementSpec arteries = windkessel("arteries", "ao");
  arteries.numbers["pressurise_s"] = 0.05;
  expect_said({{pressure_source("s", "ao", 10.0), arteries}, {}, 0.0}, {"fixed by \"s\", \"arteries\""});
}

TEST(BadNetwork, AWindkesselWithCharacteristicResistanceMayMeetASource)
{
  EXPECT_EQ(refusal({{pressure_source("s", "ao", 10.0), windkessel("arteries", "ao")}, {}, 0.0}), "");
}

TEST(BadNetwork, ANodeBetweenValvesHasNoPressure)
{
  expect_said(
      {{chamber("lv", "a"), valve("v", "a", "m", 0.01), valve("w", "m", "b", 0.01), windkessel("k", "b")},
       {},
       0.0},
      {"node \"m\": joins only \"v\", \"w\", none of which settles its pressure"});
  expect_said({{chamber("lv", "a"), valve("v", "a", "out", 0.01)}, {"out"}, 0.0},
              {"node \"out\": joins only \"v\"", "windkessel3, a chamber or a pressure_source"});
}

TEST(BadNetwork, AMissingPortListsTheNodes)
{
  NetworkSpec spec = aortic_root();
  spec.ports = {"lv", "aoo"};
  expect_said(spec, {"port \"aoo\": is not a node of the network", "did you mean", "\"lv\", \"ao\""});
}

TEST(BadNetwork, AllProblemsAreReportedAtOnce)
{
  ElementSpec arteries = windkessel("arteries", "ao", 0.033, -0.79, 0.0);
  ElementSpec mitral = valve("mitral", "la", "lv", 0.01);
  mitral.numbers["R_mmHg_s_m"] = 3.0;
  mitral.numbers.erase("R_mmHg_s_ml");
  ElementSpec heart = chamber("heart", "lv");
  heart.type = "chambre";
  ElementSpec twin = chamber("arteries", "lv");
  twin.words["activation"] = "half_cosin";
  expect_said(
      {{arteries, mitral, heart, twin}, {}, 0.8},
      {"element \"arteries\": Rp_mmHg_s_ml: is -0.79 mmHg s/ml; a peripheral resistance must be above 0. A "
       "usual adult value is 0.79.",
       "C_ml_mmHg: is 0 ml/mmHg; a compliance must be above 0",
       "element \"mitral\": R_mmHg_s_m: is not a parameter of a valve; did you mean",
       "element \"mitral\": R_mmHg_s_ml: is missing", "element \"heart\": type: is \"chambre\"; did you mean",
       "element \"arteries\": is there twice", "activation: is \"half_cosin\""});
}

TEST(BadNetwork, TablesMustFitTogether)
{
  expect_said({{pressure_table("s", "a", {0.0, 0.1}, {1.0})}, {}, 0.0},
              {"time_s: has 2 entries, pressure_mmHg has 1"});
  expect_said({{pressure_table("s", "a", {0.0, 0.2, 0.2}, {1.0, 2.0, 3.0})}, {}, 0.0},
              {"time_s: goes from 0.2 s to 0.2 s at entry 3; times must increase"});
  ElementSpec source = pressure_table("s", "a", {0.0, 0.8}, {1.0, 2.0});
  source.words["beyond_table"] = "repeat";
  expect_said({{source}, {}, 0.0}, {"beyond_table: is \"repeat\", but the case names no heart period"});
  expect_said({{source}, {}, 0.8}, {"must end as it begins"});
  expect_said({{source}, {}, 0.7}, {"more than the heart period of 0.7 s"});
}

TEST(BadNetwork, AFlowlessValveNeedsAResistance)
{
  expect_said({{chamber("c", "a"), valve("v", "a", "b", 0.0), windkessel("w", "b")}, {}, 0.0},
              {"element \"v\": R_mmHg_s_ml: is 0 in a valve without inertance"});
  expect_said({{chamber("c", "a"), valve("v", "a", "a", 0.1)}, {}, 0.0},
              {"to: is the node \"a\", as is from"});
}

TEST(ElementTypes, TheTableIsCompleteAndKeysEndInTheirUnits)
{
  for (const ElementType& type : element_types()) {
    EXPECT_NE(type.factory, nullptr) << type.name;
    EXPECT_FALSE(type.meaning.empty());
    for (const ElementParameter& p : type.parameters) {
      EXPECT_FALSE(p.meaning.empty()) << p.name;
      EXPECT_FALSE(p.quantity.empty()) << p.name;
      EXPECT_TRUE(p.kind == ParameterKind::word || p.choices.empty()) << p.name;
      std::string suffix;
      for (char c : p.unit)
        if (c != '^') suffix += c == ' ' || c == '/' ? '_' : c;
      EXPECT_TRUE(p.name.ends_with(suffix)) << p.name << " in " << p.unit;
    }
  }
}

}  // namespace valsalva::lumped::testing
