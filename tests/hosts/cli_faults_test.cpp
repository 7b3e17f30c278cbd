// What users and files do wrong: each is told in a clear line, and what was there stays.

#include "support/mistake.h"
#include "support/on_corpus.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace foredraw::cli_faults_test {
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
  expect_told(GetParam(), run(arguments));
  EXPECT_EQ(files(), before);
}

/// Of `optimize SPOT -o out.glb`, with more arguments.
Mistake of_optimize(const char* what, const std::string& more, const std::string& says) {
  return {what, "optimize SPOT -o out.glb " + more, 1, says};
}

INSTANTIATE_TEST_SUITE_P(
    Every, Mistakes,
    ::testing::Values(
        Mistake{"missing_file", "optimize nowhere.glb -o out.glb", 1, "nowhere.glb: error: there is no such file"},
        Mistake{"damaged_file", "optimize bad.glb -o out.glb", 2, "bad.glb: error:"},
        of_optimize("unknown_stage", "-p tipsfy", "did you mean 'tipsify'?"),
        of_optimize("unknown_option", "-p typo.toml", "typo.toml:4:"),
        of_optimize("option_out_of_range", "-p 'tipsify(cache-size=2)'", "3 to 1024 entries"),
        of_optimize("unmet_need", "-p dot-rule", "then 'linear-clusters' before it, and 'vertex-fetch' after it"),
        of_optimize("unknown_preset", "-p @defualt", "@default"),
        of_optimize("unknown_set", "--set lookahead.cach-size=3", "cache-size"),
        Mistake{"unknown_kind_of_output", "optimize SPOT -o out.xyz", 1, "extensions .glb, .gltf, .obj"},
        Mistake{"missing_folder", "optimize SPOT -o no/such/folder/out.glb", 2, "no folder 'no/such/folder'"},
        Mistake{"no_output", "optimize SPOT", 1, "--output"},
        Mistake{"no_command", "", 1, "hint: there are optimize, plan"},
        of_optimize("misspelled_option", "--levls keep", "'--levls'\n    hint: did you mean '--levels'?"),
        Mistake{"option_like_no_other", "plan SPOT --quite-else=3", 1,
                "'--quite-else'\n    hint: foredraw plan --help"},
        Mistake{"option_of_a_letter", "measure SPOT -p weld", 1, "'-p'\n    hint: foredraw measure --help"},
        Mistake{"two_inputs", "optimize SPOT more.glb -o out.glb", 1, "one input too many: 'more.glb'"},
        of_optimize("hidden_from_where", "-p hidden", "say where cameras may be"),
        of_optimize("hidden_from_half_a_box", "-p 'hidden(seen-from=box, box=\"0 0 0\")'", "two corners"),
        of_optimize("unknown_subject", "--set subjects.subject=car", "mesh, character, scene"),
        Mistake{"unknown_sequence", "measure SPOT --with 'overdraw-raster(sequence=depth)'", 1,
                "table, file, material"},
        Mistake{"unknown_kind_before_a_colon", "optimize SPOT -o tangents:out.json", 1, "no kind of output 'tangents'"},
        Mistake{"unknown_product", "schema draw-order", 1, "did you mean 'draw-orders'?"},
        Mistake{"empty_file", "inspect empty.glb", 2, "empty.glb: error: the file is empty"},
        Mistake{"unknown_plugin_shown", "show tipsfy", 1, "did you mean 'tipsify'?"},
        Mistake{"unknown_kind_listed", "list --kind things", 1, "orderer"},
        Mistake{"bad_views", "measure SPOT --with 'overdraw-raster(views=100)'", 1, "162"},
        Mistake{"unknown_command", "optimise SPOT -o out.glb", 1, "did you mean 'optimize'?"},
        of_optimize("two_pipelines", "-p weld -p tipsify", "foredraw compare"),
        of_optimize("two_outputs_in_one_file", "--report out.glb", "two outputs"),
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
}  // namespace foredraw::cli_faults_test
