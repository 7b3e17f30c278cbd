#include "support/program.h"

#include <foredraw/cache/result_about.h>
#include <foredraw/cache/results.h>
#include <foredraw/platform/files.h>

namespace foredraw::results_test {
namespace {

namespace fs = std::filesystem;

/// Work that reads a file, and the files that it names, a name on each line.
class Results : public testing::InFolder {
 protected:
  Results() : cache_(*Cache::in(folder_ / "cache", diagnostics_)) {
    fs::create_directories(folder_ / "in");
    testing::put(folder_ / "in/main", "beside\nmissing\n");
    testing::put(folder_ / "in/beside", "one");
  }

  WorkRead read(const fs::path& input) {
    FilesRead files;
    const auto bytes = read_file(input, diagnostics_, FileRead::all_of_it, &files);
    std::istringstream names(std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size()));
    Diagnostics ignored;
    for (std::string name; names >> name;) read_file(input.parent_path() / name, ignored, 100, &files);
    return {files.all(), {}};
  }
  Work work(const std::string& input = "in/main", const std::string& how = "how", const std::string& place = "here") {
    return {content_hash(std::as_bytes(std::span(how))), folder_ / input, place};
  }
  void keep(const Work& work, const std::string& result, bool depends_on_place = false) {
    const auto content = std::as_bytes(std::span(result));
    EXPECT_EQ(keep_result(cache_, work, read(work.input), depends_on_place, "about", std::span(&content, 1)), "");
  }
  std::string found(const Work& work) {
    const auto result = find_result(cache_, work, diagnostics_);
    if (!result) return "none";
    const auto bytes = result->entry.read(0);
    return {reinterpret_cast<const char*>(bytes->data()), bytes->size()};
  }

  Diagnostics diagnostics_;
  Cache cache_;
};

TEST_F(Results, AreFoundByAllThatWasRead) {
  EXPECT_EQ(found(work()), "none");
  keep(work(), "first");
  EXPECT_EQ(found(work()), "first");
  EXPECT_EQ(find_result(cache_, work(), diagnostics_)->read,
            (std::vector<fs::path>{folder_ / "in/main", folder_ / "in/beside"}));
  EXPECT_EQ(found(work("in/main", "another how")), "none");

  testing::put(folder_ / "in/beside", "two");
  EXPECT_EQ(found(work()), "none");
  keep(work(), "second");
  EXPECT_EQ(found(work()), "second");
  testing::put(folder_ / "in/beside", "one");
  EXPECT_EQ(found(work()), "first") << "both are there";

  testing::put(folder_ / "in/missing", "");
  EXPECT_EQ(found(work()), "none") << "what was missing counts too";
  fs::remove(folder_ / "in/missing");
  fs::remove(folder_ / "in/beside");
  EXPECT_EQ(found(work()), "none");
  testing::put(folder_ / "in/beside", "one");
  testing::put(folder_ / "in/main", "beside\nmissing \n");
  EXPECT_EQ(found(work()), "none");
}

TEST_F(Results, GoWithTheFilesWhereverTheseGo) {
  keep(work(), "first");
  fs::rename(folder_ / "in", folder_ / "moved");
  EXPECT_EQ(found(work("moved/main")), "first");
  fs::rename(folder_ / "moved/main", folder_ / "moved/renamed");
  EXPECT_EQ(found(work("moved/renamed", "how", "there")), "first");
}

TEST_F(Results, CountTheirPlaceWhereTheyHoldNames) {
  keep(work("in/main", "how", "here"), "first", true);
  EXPECT_EQ(found(work("in/main", "how", "there")), "none");
  keep(work("in/main", "how", "there"), "second", true);
  EXPECT_EQ(found(work("in/main", "how", "there")), "second");
  EXPECT_EQ(found(work("in/main", "how", "here")), "first");
}

TEST_F(Results, OfFilesThatChangedMeanwhileAreNotKept) {
  WorkRead seen = read(folder_ / "in/main");
  testing::put(folder_ / "in/beside", "two");
  const WorkRead again = read(folder_ / "in/main");
  FilesRead both;
  Diagnostics ignored;
  testing::put(folder_ / "in/beside", "one");
  read_file(folder_ / "in/main", ignored, FileRead::all_of_it, &both);
  read_file(folder_ / "in/beside", ignored, 100, &both);
  testing::put(folder_ / "in/beside", "two");
  read_file(folder_ / "in/beside", ignored, 100, &both);
  EXPECT_EQ(keep_result(cache_, work(), {both.all(), {}}, false, "", {}), "");
  EXPECT_EQ(found(work()), "none");
  const std::string result = "of the old";
  const auto content = std::as_bytes(std::span(result));
  keep_result(cache_, work(), seen, false, "", std::span(&content, 1));
  EXPECT_EQ(found(work()), "none") << "it is what was read that counts, and not what lies there afterwards";
  testing::put(folder_ / "in/beside", "one");
  EXPECT_EQ(found(work()), result);
}

TEST_F(Results, FilesOfOptionsCountByTheirPaths) {
  testing::put(folder_ / "proxy", "one");
  FilesRead lent;
  read_file(folder_ / "proxy", diagnostics_, FileRead::all_of_it, &lent);
  WorkRead files = read(folder_ / "in/main");
  files.lent = lent.all();
  const std::string result = "first";
  const auto content = std::as_bytes(std::span(result));
  keep_result(cache_, work(), files, false, "", std::span(&content, 1));
  fs::rename(folder_ / "in", folder_ / "moved");
  EXPECT_EQ(found(work("moved/main")), "first");
  testing::put(folder_ / "proxy", "two");
  EXPECT_EQ(found(work("moved/main")), "none");
}

TEST_F(Results, AListThatIsDamagedIsTold) {
  keep(work(), "first");
  std::size_t told = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / "cache/entries")) {
    if (!entry.is_regular_file()) continue;
    const std::string sound = testing::content(entry.path());
    testing::put(entry.path(), sound.substr(0, sound.size() - 1));
    diagnostics_ = {};
    EXPECT_EQ(found(work()), "none");
    told += diagnostics_.all().size();
    testing::put(entry.path(), sound);
  }
  EXPECT_EQ(told, 2u) << "of the list and of the result";
  EXPECT_EQ(found(work()), "first");
}

TEST_F(Results, OfAFileThatIsReadAloneAreOneEntry) {
  testing::put(folder_ / "in/main", "");
  const auto entries = [&] {
    std::size_t count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "cache/entries")) {
      count += entry.is_regular_file() ? 1 : 0;
    }
    return count;
  };
  keep(work(), "alone");
  EXPECT_EQ(found(work()), "alone");
  EXPECT_EQ(entries(), 1u);
  testing::put(folder_ / "in/main", "beside\n");
  EXPECT_EQ(found(work()), "none");
  keep(work(), "with another");
  EXPECT_EQ(found(work()), "with another");
  EXPECT_EQ(entries(), 3u) << "and a list";
}

TEST(ResultAbout, IsReadBack) {
  const ResultAbout about{"in/\"a\".gltf", {"out/a.gltf", "b.json"}, "stages = []\n", {{0, ""}, {0, "a.bin"}, {1, ""}}};
  const auto read = result_about(to_text(about));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->input, about.input);
  EXPECT_EQ(read->outputs, about.outputs);
  EXPECT_EQ(read->pipeline, about.pipeline);
  ASSERT_EQ(read->files.size(), 3u);
  EXPECT_EQ(read->files[1].name, "a.bin");
  EXPECT_EQ(read->files[2].output, 1u);
  EXPECT_FALSE(result_about("{}"));
  EXPECT_FALSE(result_about("no JSON"));
}

}  // namespace
}  // namespace foredraw::results_test
