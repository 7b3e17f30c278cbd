// Files that are no modules, and modules whose tables are wrong, are told each; the others load.
#include "left_behind.h"
#include "support/program.h"

#include <nlohmann/json.hpp>

#include <gmock/gmock.h>

#include <sys/stat.h>

namespace foredraw::testing::loading_test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const std::string modules = FOREDRAW_MODULES_FOLDER "/";

struct Refused {
  std::string name;
  std::string says;
};
void PrintTo(const Refused& module, std::ostream* out) { *out << module.name; }

class Loading : public InFolder, public ::testing::WithParamInterface<Refused> {};

TEST_P(Loading, TellsWhatIsWrongAndLoadsTheOthers) {
  for (const std::string how : {" --modules apart", " --modules inside"}) {
    const bool ends = GetParam().name.starts_with("begin-");
    if (ends && (how.ends_with("inside") || is_sanitized)) continue;  // of who is trusted, or what has its own words
    const Ended ended = run_program(folder_, "list --json --module '" + module_in(folder_, GetParam().name) +
                                                 "' --module '" + modules + "radial.so'" + how);
    EXPECT_EQ(ended.code, 2) << ended.err;
    EXPECT_THAT(ended.err, HasSubstr(GetParam().name + ".so: error: "));
    EXPECT_THAT(ended.err, HasSubstr(GetParam().says));
    EXPECT_TRUE(nlohmann::json::accept(ended.out));
    EXPECT_THAT(ended.out, HasSubstr("acme-radial"));
    EXPECT_THAT(ended.out, Not(HasSubstr("hostile-")));
    EXPECT_THAT(workers_left(folder_), IsEmpty());
  }
}

INSTANTIATE_TEST_SUITE_P(
    Tables, Loading,
    ::testing::Values(Refused{"tables-minor_9", "it needs version 1.9 of modules, but this program speaks 1.1"},
                      Refused{"tables-small", "size is 8, but must be sizeof(foredraw_module)"},
                      Refused{"tables-small_plugin", "size is 8, but must be sizeof(foredraw_plugin)"},
                      Refused{"tables-many_plugins", "it has 2147483648 plugins"},
                      Refused{"tables-many_options", "it has 2147483648 options"},
                      Refused{"tables-null_plugins", "plugins is NULL"},
                      Refused{"tables-null_plugin", "one of its plugins is NULL"},
                      Refused{"tables-null_module", "foredraw_module_v1() returned NULL"},
                      Refused{"tables-no_vendor", "vendor is NULL"},
                      Refused{"tables-odd_vendor", "vendor is 'Hostile Inc.', but must be"},
                      Refused{"tables-other_vendor", "plugin 'tipsify': its name must begin with the vendor"},
                      Refused{"tables-default_beyond", "'power' is 9.0, but must be 0 to 4"},
                      Refused{"tables-no_choices", "option 'power': it has no choices"},
                      Refused{"tables-null_option_name", "option name ''"}, Refused{"tables-no_kind", "kind is 77"},
                      Refused{"tables-null_run", "run is NULL"}, Refused{"tables-odd_flags", "flags are 64"},
                      Refused{"tables-lossless_order", "of remeshers alone"},
                      Refused{"tables-overdraw_vertices", "of orderers of triangles and evaluators alone"},
                      Refused{"remesher-clustered", "a remesher can not provide 'clustered'"},
                      Refused{"no-module", "exports no function"}));

INSTANTIATE_TEST_SUITE_P(Begins, Loading, ::testing::Values(Refused{"begin-crashes", "SIGSEGV"}));

TEST_F(Loading, EndsWhoNeverBegins) {
  const Ended ended =
      run_program(folder_, "list --module '" + module_in(folder_, "begin-waits") + "' --module-seconds 5");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("it gave no answer within 5 seconds"));
  EXPECT_THAT(workers_left(folder_), IsEmpty());
}

TEST_F(Loading, SaysForWhichVersionAModuleIs) {
  const Ended ended = run_program(folder_, "list --module '" + modules + "major-2.so'");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("it is for version 2 of modules, but this program speaks 1.1"));
}

TEST_F(Loading, KeepsWhatAConstructorPrintsFromTheOutput) {
  const Ended ended = run_program(folder_, "list --json --module '" + modules + "begin-prints.so'");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_TRUE(nlohmann::json::accept(ended.out));
  EXPECT_THAT(ended.out, HasSubstr("hostile-begin-prints"));
}

TEST_F(Loading, RefusesWhatIsNoLibraryOrOfAnotherMachine) {
  put(folder_ / "text.so", "no library\n");
  std::string other = content(modules + "radial.so");
  other[18] = '\xF3', other[19] = 0;  // e_machine: EM_RISCV
  put(folder_ / "other.so", other);
  put(folder_ / "empty.so", "");
  put(folder_ / "notes.txt", "no library\n");
  ASSERT_EQ(::mkfifo((folder_ / "pipe.so").c_str(), 0600), 0);  // which nobody writes to
  for (const std::string name : {"text.so", "other.so", "empty.so", "none.so", "notes.txt", "pipe.so"}) {
    const Ended ended = run_program(folder_, "list --module " + name);
    EXPECT_EQ(ended.code, 2) << name;
    EXPECT_THAT(ended.err, HasSubstr(name + ": error: "));
    EXPECT_EQ(ended.err.find("or a Python file, .py") != std::string::npos, name == "notes.txt") << ended.err;
    EXPECT_THAT(ended.out, HasSubstr("tipsify"));
  }
}

TEST_F(Loading, TakesFoldersAndTellsOfEach) {
  std::filesystem::create_directories(folder_ / "many");
  for (int i = 0; i < 30; ++i) put(folder_ / "many" / ("bad" + std::to_string(i) + ".so"), "no library\n");
  std::filesystem::copy_file(modules + "radial.so", folder_ / "many" / "good.so");
  put(folder_ / "many" / "README", "no module, and not asked\n");
  const Ended ended = run_program(folder_, "list --module many");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.out, HasSubstr("acme-radial"));
  std::size_t told = 0;
  for (std::size_t at = 0; (at = ended.err.find(".so: error: ", at)) != std::string::npos; ++at) ++told;
  EXPECT_EQ(told, 30u);
  std::filesystem::create_directories(folder_ / "none");
  EXPECT_THAT(run_program(folder_, "list --module none").err, HasSubstr("holds no module"));
}

TEST_F(Loading, RefusesASecondModuleWithTheSameNames) {
  std::filesystem::copy_file(modules + "radial.so", folder_ / "again.so");
  const std::string twice = " --module '" + modules + "radial.so'";
  EXPECT_EQ(run_program(folder_, "list" + twice + twice).code, 0) << "the same file named twice is one module";
  const Ended ended = run_program(folder_, "list --module again.so" + twice);
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("there is already a plugin 'acme-radial'"));
}

TEST_F(Loading, SaysWhereTheWorkerIsLookedFor) {
  const Ended ended =
      run_program(folder_, "list --module '" + modules + "radial.so'", "FOREDRAW_MODULE_WORKER=/no/such");
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("/no/such can not be run"));
}

}  // namespace
}  // namespace foredraw::testing::loading_test
