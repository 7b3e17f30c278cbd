#include <foredraw/pipeline/module_demand.h>
#include <foredraw/pipeline/parse.h>

#include <gtest/gtest.h>

namespace foredraw::module_demand_test {
namespace {

TEST(ModuleDemand, IsAVendorAndAVersion) {
  EXPECT_EQ(module_demand("acme"), (ModuleDemand{"acme", ""}));
  EXPECT_EQ(module_demand(" acme >= 1.2.10 "), (ModuleDemand{"acme", "1.2.10"}));
  EXPECT_EQ(module_demand("acme>=2"), (ModuleDemand{"acme", "2"}));
  for (const char* wrong : {"", ">= 1", "Acme", "acme >=", "acme >= ", "acme > 1", "acme = 1", "acme >= 1.",
                            "acme >= .1", "acme >= 1..2", "acme >= x", "acme >= 1 beta", "../acme.so", "acme 1"}) {
    EXPECT_FALSE(module_demand(wrong)) << wrong;
  }
}

Registry registry_with(const std::string& version) {
  Registry registry;
  registry.add({.card = {.name = "acme-one"}},
               std::make_shared<ModuleFile>(ModuleFile{"acme.so", 0, "", "acme", version}));
  return registry;
}

bool meets(const std::string& version, const std::string& demand) {
  Diagnostics diagnostics;
  check_demands({*module_demand(demand)}, registry_with(version), diagnostics);
  return diagnostics.empty();
}

TEST(ModuleDemand, IsMetByTheSameOrANewerVersion) {
  EXPECT_TRUE(meets("1.2", "acme"));
  EXPECT_TRUE(meets("1.2", "acme >= 1.2"));
  EXPECT_TRUE(meets("1.2.0", "acme >= 1.2"));
  EXPECT_TRUE(meets("1.2", "acme >= 1.2.0"));
  EXPECT_TRUE(meets("1.10", "acme >= 1.9"));
  EXPECT_TRUE(meets("2.0-beta", "acme >= 1.9.9"));
  EXPECT_FALSE(meets("1.2", "acme >= 1.2.1"));
  EXPECT_FALSE(meets("1.9", "acme >= 1.10"));
  EXPECT_FALSE(meets("unknown", "acme >= 0.1"));
  EXPECT_FALSE(meets("99999999999999999999999", "acme >= 1"));
  EXPECT_FALSE(meets("1.2", "other"));
}

TEST(ModuleDemand, StandsInAFileAndIsPrintedAgain) {
  Diagnostics diagnostics;
  const auto pipeline =
      parse_file("pipeline = 1\nmodules = [\"acme\", \"beta >=1.2\"]\nstages = []\n", "a.toml", diagnostics);
  ASSERT_TRUE(pipeline) << to_text(diagnostics);
  EXPECT_EQ(pipeline->modules, (std::vector<ModuleDemand>{{"acme", ""}, {"beta", "1.2"}}));
  const auto again = parse_file(print_file(*pipeline), "b.toml", diagnostics);
  ASSERT_TRUE(again) << to_text(diagnostics);
  EXPECT_TRUE(same_pipeline(*pipeline, *again));
  EXPECT_FALSE(print_line(*pipeline)) << "a line has no modules";
}

TEST(ModuleDemand, ThatIsNoneIsTold) {
  const auto said = [](const std::string& modules) {
    Diagnostics diagnostics;
    EXPECT_FALSE(parse_file("pipeline = 1\nmodules = " + modules + "\n", "a.toml", diagnostics));
    return to_text(diagnostics);
  };
  EXPECT_NE(said("\"acme\"").find("'modules' must be a list"), std::string::npos);
  EXPECT_NE(said("[1]").find("a.toml:2:12: error: modules[0]: a module must be a vendor"), std::string::npos);
  EXPECT_NE(said("[\"radial.so\"]").find("such as modules"), std::string::npos);
}

}  // namespace
}  // namespace foredraw::module_demand_test
