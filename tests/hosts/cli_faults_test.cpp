// What users and files do wrong: each is told in a clear line, and what was there stays.

#include "support/mistake.h"
#include "support/on_corpus.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace foredraw {
namespace {

namespace fs = std::filesystem;
using testing::content;
using testing::Ended;
using testing::Mistake;

class CliFaults : public testing::OnCorpus {};

TEST_F(CliFaults, SaysWhereHeatMapsCanNotBeDrawn) {
  const Ended no_view = run("optimize " + spot() + " -o out.glb --heatmap maps --heatmap-view best");
  EXPECT_EQ(no_view.code, 1);
  EXPECT_EQ(no_view.err,
            "foredraw: error: there is no view 'best'\n    hint: give worst, all, or a number from 0 to 99\n");
  EXPECT_TRUE(files().empty());
  std::ofstream(folder_ / "maps") << "a file";
  const Ended no_folder = run("measure " + spot() + " --heatmap maps");
  EXPECT_EQ(no_folder.code, 2);
  EXPECT_NE(no_folder.err.find("maps: error: cannot be created"), std::string::npos) << no_folder.err;
}

TEST_F(CliFaults, SaysWhichLevelIsNotThere) {
  const Ended none = run("optimize " + spot() + " -o level1:out.obj -p weld");
  EXPECT_EQ(none.code, 2);
  EXPECT_NE(none.err.find("out.obj: error: no draw has a level 1"), std::string::npos) << none.err;
  EXPECT_NE(none.err.find("@levels"), std::string::npos) << none.err;
  const Ended few = run("optimize " + spot() + " -o level9:out.obj -p @levels");
  EXPECT_EQ(few.code, 2);
  EXPECT_NE(few.err.find("the coarsest is level 3"), std::string::npos) << few.err;
  EXPECT_EQ(run("optimize " + spot() + " -o level1:out.png -p @levels").code, 1);
  EXPECT_TRUE(files().empty());
}

class Mistakes : public CliFaults, public ::testing::WithParamInterface<Mistake> {};

TEST_P(Mistakes, AreToldInOneClearLineAndNothingIsWritten) {
  std::ofstream(folder_ / "bad.glb") << "glTF but not really";
  std::ofstream(folder_ / "typo.toml")
      << "pipeline = 1\nstages = [\n  \"weld\",\n  { use = \"tipsify\", cache = 16 },\n]\n";
  std::ofstream(folder_ / "empty.glb");
  std::ofstream(folder_ / "service.toml")
      << "pipeline = 1\n[services]\noverdraw = { use = \"overdraw-raster\", views = 162 }\n";
  const auto before = files();
  std::string arguments = GetParam().arguments;
  if (const auto at = arguments.find("SPOT"); at != std::string::npos) arguments.replace(at, 4, spot());
  const Ended ended = run(arguments);
  EXPECT_EQ(ended.code, GetParam().code) << ended.err;
  EXPECT_NE(ended.err.find(GetParam().says), std::string::npos) << ended.err;
  EXPECT_TRUE(ended.out.empty()) << ended.out;
  EXPECT_EQ(files(), before);
}

INSTANTIATE_TEST_SUITE_P(
    Every, Mistakes,
    ::testing::Values(
        Mistake{"missing_file", "optimize nowhere.glb -o out.glb", 1, "nowhere.glb: error: there is no such file"},
        Mistake{"damaged_file", "optimize bad.glb -o out.glb", 2, "bad.glb: error:"},
        Mistake{"unknown_stage", "optimize SPOT -o out.glb -p tipsfy", 1, "did you mean 'tipsify'?"},
        Mistake{"unknown_option", "optimize SPOT -o out.glb -p typo.toml", 1, "typo.toml:4:"},
        Mistake{"option_out_of_range", "optimize SPOT -o out.glb -p 'tipsify(cache-size=2)'", 1, "3 to 1024 entries"},
        Mistake{"unmet_need", "optimize SPOT -o out.glb -p dot-rule", 1,
                "then 'linear-clusters' before it, and 'vertex-fetch' after it"},
        Mistake{"unknown_preset", "optimize SPOT -o out.glb -p @defualt", 1, "@default"},
        Mistake{"unknown_set", "optimize SPOT -o out.glb --set lookahead.cach-size=3", 1, "cache-size"},
        Mistake{"unknown_kind_of_output", "optimize SPOT -o out.xyz", 1, ".glb or .gltf"},
        Mistake{"missing_folder", "optimize SPOT -o no/such/folder/out.glb", 2, "no folder 'no/such/folder'"},
        Mistake{"no_output", "optimize SPOT", 1, "--output"},
        Mistake{"no_command", "", 1, "hint: there are optimize, plan"},
        Mistake{"misspelled_option", "optimize SPOT -o out.glb --levls keep", 1,
                "'--levls'\n    hint: did you mean '--levels'?"},
        Mistake{"option_like_no_other", "plan SPOT --quite-else=3", 1,
                "'--quite-else'\n    hint: foredraw plan --help"},
        Mistake{"option_of_a_letter", "measure SPOT -p weld", 1, "'-p'\n    hint: foredraw measure --help"},
        Mistake{"two_inputs", "optimize SPOT more.glb -o out.glb", 1, "one input too many: 'more.glb'"},
        Mistake{"hidden_from_where", "optimize SPOT -o out.glb -p hidden", 1, "say where cameras may be"},
        Mistake{"hidden_from_half_a_box", "optimize SPOT -o out.glb -p 'hidden(seen-from=box, box=\"0 0 0\")'", 1,
                "two corners"},
        Mistake{"unknown_subject", "optimize SPOT -o out.glb --set subjects.subject=car", 1, "mesh, character, scene"},
        Mistake{"unknown_sequence", "measure SPOT --with 'overdraw-raster(sequence=depth)'", 1,
                "table, file, material"},
        Mistake{"unknown_kind_before_a_colon", "optimize SPOT -o tangents:out.json", 1, "no kind of output 'tangents'"},
        Mistake{"unknown_product", "schema draw-order", 1, "did you mean 'draw-orders'?"},
        Mistake{"empty_file", "inspect empty.glb", 2, "empty.glb: error: the file is empty"},
        Mistake{"unknown_plugin_shown", "show tipsfy", 1, "did you mean 'tipsify'?"},
        Mistake{"unknown_kind_listed", "list --kind things", 1, "orderer"},
        Mistake{"bad_views", "measure SPOT --with 'overdraw-raster(views=100)'", 1, "162"},
        Mistake{"unknown_command", "optimise SPOT -o out.glb", 1, "did you mean 'optimize'?"},
        Mistake{"two_pipelines", "optimize SPOT -o out.glb -p weld -p tipsify", 1, "foredraw compare"},
        Mistake{"two_outputs_in_one_file", "optimize SPOT -o out.glb --report out.glb", 1, "two outputs"},
        Mistake{"report_in_no_folder", "optimize SPOT -o out.glb --report no/r.json", 2, "no folder 'no'"},
        Mistake{"empty_name", "measure ''", 1, "empty"},
        Mistake{"full_disk", "schema >/dev/full", 2, "cannot be written"},
        Mistake{"option_of_no_service", "plan SPOT -p service.toml", 1, "no option 'views'"},
        Mistake{"json_and_scene_on_one_stream", "optimize SPOT -o - --json", 1, "--report"}),
    testing::by_what);

TEST_F(CliFaults, KeepsWhatWasThereWhereAnOutputCanNotBePutInItsPlace) {
  std::ofstream(folder_ / "out.gltf") << "mine";
  fs::create_directories(folder_ / "out.bin");
  EXPECT_EQ(run("optimize " + spot() + " -o out.gltf -p weld,tipsify --with vertex-cache").code, 2);
  EXPECT_EQ(content(folder_ / "out.gltf"), "mine");
}

TEST_F(CliFaults, TellsEveryMistakeOfAPipelineAtOnce) {
  const Ended ended = run("plan " + spot() + " -p 'weld(x=1), tipsfy, lookahead(y=2)'");
  EXPECT_EQ(ended.code, 1);
  for (const char* part : {"no option 'x'", "'tipsfy'", "no option 'y'"})
    EXPECT_NE(ended.err.find(part), std::string::npos) << ended.err;
}

}  // namespace
}  // namespace foredraw
