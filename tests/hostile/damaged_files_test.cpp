// Damaged files of other projects: each is read or refused as gltf/expected.tsv says.
#include "support/meshes.h"
#include "support/program.h"

#include <foredraw/io/gltf/gltf.h>

namespace foredraw::damaged_files_test {
namespace {

namespace fs = std::filesystem;
using testing::content;

struct Expected {
  std::string file, verdict, line;
};

void PrintTo(const Expected& expected, std::ostream* out) { *out << expected.file; }

fs::path folder() { return testing::project_file("tests/hostile/gltf"); }

std::vector<Expected> expectations() {
  std::vector<Expected> all;
  std::istringstream table(content(folder() / "expected.tsv"));
  std::string row;
  std::getline(table, row);  // the heading
  while (std::getline(table, row)) {
    std::istringstream cells(row);
    Expected expected;
    std::getline(cells, expected.file, '\t');
    std::getline(cells, expected.verdict, '\t');
    std::getline(cells, expected.line, '\t');
    all.push_back(expected);
  }
  return all;
}

TEST(DamagedFiles, every_file_is_in_the_table) {
  std::vector<std::string> listed, there;
  for (const Expected& expected : expectations()) {
    listed.push_back(expected.file);
    EXPECT_TRUE(expected.verdict == "read" || expected.verdict == "refused") << expected.file;
  }
  for (const auto& entry : fs::recursive_directory_iterator(folder())) {
    const std::string kind = entry.path().extension().string();
    if (kind == ".gltf" || kind == ".glb") there.push_back(fs::relative(entry.path(), folder()).generic_string());
  }
  std::sort(there.begin(), there.end());
  std::sort(listed.begin(), listed.end());
  EXPECT_EQ(listed, there);
}

class DamagedFile : public testing::InFolder, public ::testing::WithParamInterface<Expected> {};

TEST_P(DamagedFile, is_read_or_refused_by_the_reader) {
  Diagnostics diagnostics;
  const auto scene = read_gltf(folder() / GetParam().file, diagnostics);
  EXPECT_EQ(scene.has_value(), GetParam().verdict == "read") << to_text(diagnostics);
  EXPECT_NE(to_text(diagnostics).find(GetParam().line), std::string::npos) << to_text(diagnostics);
  if (scene) {
    EXPECT_TRUE(encode_gltf(*scene, "out.glb", diagnostics));
  }
}

#ifdef FOREDRAW_PROGRAM
TEST_P(DamagedFile, is_read_or_refused_by_the_program) {
  const bool is_read = GetParam().verdict == "read";
  testing::put(folder_ / "out.glb", "mine");
  const auto path = (folder() / GetParam().file).string();
  const testing::Ended ended = testing::run_program(folder_, "optimize '" + path + "' -o out.glb");
  EXPECT_EQ(ended.code, is_read ? 0 : 2) << ended.err;
  EXPECT_EQ(content(folder_ / "out.glb").substr(0, 4), is_read ? "glTF" : "mine");
  EXPECT_EQ(files(), std::vector<std::string>{"out.glb"}) << "nothing else is left";
  if (!GetParam().line.empty()) {
    std::istringstream lines(ended.err);
    std::string line;
    while (std::getline(lines, line) && line.find(GetParam().line) == std::string::npos) {
    }
    EXPECT_EQ(line.find(path), 0u) << "the line names the file\n" << ended.err;
  }
}
#endif

INSTANTIATE_TEST_SUITE_P(Gltf, DamagedFile, ::testing::ValuesIn(expectations()), [](const auto& info) {
  std::string name = info.param.file;
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
});

}  // namespace
}  // namespace foredraw::damaged_files_test
