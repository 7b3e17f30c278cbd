// The source tree keeps its rules. Each test lists all offenders at once.

#include <gtest/gtest.h>

#include <iostream>
#include <set>

#include "clock_rules.h"
#include "family_rules.h"
#include "include_rules.h"
#include "name_rules.h"
#include "product_rules.h"
#include "room_rules.h"
#include "shape_rules.h"
#include "source_tree.h"
#include "text_rules.h"
#include "type_rules.h"

namespace foredraw::architecture::architecture_test {
namespace {

const std::filesystem::path root = FOREDRAW_SOURCE_DIR;

struct TextFile {
  std::string path, text;
};

class Architecture : public ::testing::Test {
 protected:
  /// The texts of the project. Models and their licences are as others made them.
  static std::vector<TextFile> texts() {
    std::vector<TextFile> texts;
    for (const SourceFile& file : source_files(root)) {
      if (file.is_link || file.path.starts_with("benchmarks/corpus/")) continue;
      std::string text = text_of(root / file.path);
      if (is_text(text)) texts.push_back({file.path, std::move(text)});
    }
    return texts;
  }

  static void add(Breaches& all, Breaches some) { all.insert(all.end(), some.begin(), some.end()); }

  static std::string listed(const Breaches& breaches) {
    std::string text;
    for (const std::string& breach : breaches) text += breach + '\n';
    return text;
  }
};

TEST_F(Architecture, the_tree_is_found) { EXPECT_GT(texts().size(), 50u) << "in " << root; }

TEST_F(Architecture, includes_point_leftwards) {
  Breaches breaches;
  for (const TextFile& file : texts()) add(breaches, include_breaches(file.path, file.text));
  EXPECT_TRUE(breaches.empty()) << listed(breaches);
}

TEST_F(Architecture, hosts_work_by_jobs) {
  Breaches breaches;
  for (const TextFile& file : texts()) add(breaches, host_breaches(file.path, file.text));
  EXPECT_TRUE(breaches.empty()) << listed(breaches);
}

TEST_F(Architecture, who_is_handed_rows_names_no_product) {
  Breaches breaches;
  for (const TextFile& file : texts()) add(breaches, product_breaches(file.path, file.text));
  EXPECT_TRUE(breaches.empty()) << listed(breaches);
}

TEST_F(Architecture, families_are_named_at_home) {
  const std::vector<Family> families = families_in(text_of(root / "tests/architecture/families.md"));
  EXPECT_GT(families.size(), 5u);
  const std::vector<TextFile> all = texts();
  Breaches breaches;
  for (const Family& family : families) {
    std::vector<std::string> files;
    for (const TextFile& file : all) {
      if (names_from_elsewhere(family, file.path, file.text)) files.push_back(file.path);
    }
    add(breaches, family_breaches(family, files));
  }
  EXPECT_TRUE(breaches.empty()) << listed(breaches);
}

TEST_F(Architecture, the_page_shows_the_rooms) {
  const Breaches breaches = room_breaches(text_of(root / "docs/guides/concepts.md"), rooms());
  EXPECT_TRUE(breaches.empty()) << listed(breaches);
}

TEST_F(Architecture, plugins_are_whole_folders) {
  std::set<std::string> paths;
  for (const SourceFile& file : source_files(root)) paths.insert(file.path);
  const Breaches breaches = plugin_shape_breaches(paths);
  EXPECT_TRUE(breaches.empty()) << listed(breaches);
}

TEST_F(Architecture, plugins_have_a_function_for_c_or_a_reason) {
  std::set<std::string> paths;
  for (const SourceFile& file : source_files(root)) paths.insert(file.path);
  const Breaches breaches = c_function_breaches(paths, text_of(root / "docs/reference/c-functions.md"));
  EXPECT_TRUE(breaches.empty()) << listed(breaches);
}

TEST_F(Architecture, names_say_something) {
  Breaches breaches;
  for (const SourceFile& file : source_files(root)) add(breaches, name_breaches(file.path));
  EXPECT_TRUE(breaches.empty()) << listed(breaches);
}

TEST_F(Architecture, plugins_carry_their_folders_name) {
  Breaches breaches;
  for (const TextFile& file : texts()) add(breaches, plugin_name_breaches(file.path, file.text));
  EXPECT_TRUE(breaches.empty()) << listed(breaches);
}

TEST_F(Architecture, tests_have_the_namespaces_of_their_files) {
  Breaches breaches;
  std::map<std::string, std::string> files;
  for (const TextFile& file : texts()) add(breaches, test_namespace_breaches(file.path, file.text, files));
  EXPECT_GT(files.size(), 400u);
  EXPECT_TRUE(breaches.empty()) << listed(breaches);
}

TEST_F(Architecture, types_are_defined_once) {
  TypeFiles types;
  for (const TextFile& file : texts()) {
    const std::string top = parts_of(file.path).front();
    if (is_cpp(file.path) && top != "tests" && top != "benchmarks") add_types(file.path, file.text, types);
  }
  EXPECT_GT(types.size(), 500u);
  const Breaches breaches = type_breaches(types);
  EXPECT_TRUE(breaches.empty()) << listed(breaches);
}

TEST_F(Architecture, files_hold_one_idea) {
  Breaches long_ones, too_long_ones;
  for (const TextFile& file : texts()) {
    add(long_ones, length_breaches(file.path, file.text, long_file));
    add(too_long_ones, length_breaches(file.path, file.text, too_long_file));
  }
  if (!long_ones.empty()) std::cout << "warning: worth a look:\n" << listed(long_ones);
  EXPECT_TRUE(too_long_ones.empty()) << listed(too_long_ones);
}

TEST_F(Architecture, texts_are_finished_and_belong_to_no_machine) {
  Breaches breaches;
  for (const TextFile& file : texts()) add(breaches, text_breaches(file.path, file.text));
  EXPECT_TRUE(breaches.empty()) << listed(breaches);
}

TEST_F(Architecture, no_test_asserts_time) {
  Breaches breaches;
  for (const TextFile& file : texts()) add(breaches, clock_breaches(file.path, file.text));
  EXPECT_TRUE(breaches.empty()) << listed(breaches);
}

TEST_F(Architecture, the_corpus_is_small_and_credited) {
  const Breaches breaches = corpus_breaches(source_files(root), text_of(root / "benchmarks/corpus/CREDITS.md"));
  EXPECT_TRUE(breaches.empty()) << listed(breaches);
}

}  // namespace
}  // namespace foredraw::architecture::architecture_test
