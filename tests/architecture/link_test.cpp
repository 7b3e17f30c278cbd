// Links between pages lead somewhere; and the rules that check it can fail.

#include <gtest/gtest.h>

#include "link_rules.h"

namespace foredraw::architecture::link_test {
namespace {

TEST(Links, lead_somewhere) {
  const std::filesystem::path root = FOREDRAW_SOURCE_DIR;
  std::set<std::string> paths;
  Pages pages;
  for (const SourceFile& file : source_files(root)) {
    paths.insert(file.path);
    if (file.path.ends_with(".md")) pages[file.path] = text_of(root / file.path);
  }
  EXPECT_GT(pages.size(), 150u);
  Breaches breaches = link_breaches(pages, paths);
  for (std::string& breach : unreached_breaches(pages, "docs/README.md", "docs/")) breaches.push_back(breach);
  std::string listed;
  for (const std::string& breach : breaches) listed += breach + '\n';
  EXPECT_TRUE(breaches.empty()) << listed;
}

TEST(LinkRules, links_to_nothing_are_found) {
  const auto found = [](const std::string& text) {
    const Pages pages = {{"docs/a.md", text},
                         {"docs/to/b.md", "# One\n## Two, `three` words\n## One\n```\n# no\n```\n"}};
    return link_breaches(pages, {"docs/a.md", "docs/to/b.md", "plugins/x.cpp"}).size();
  };
  for (const char* text :
       {"[](to/b.md)", "[](../plugins/x.cpp) [](../plugins) [](to/)", "[](to/b.md#two-three-words)",
        "[](to/b.md#one-1)", "# It\n[](#it)", "[](https://example.org/b.md)", "```\n[](b.md)\n```"}) {
    EXPECT_EQ(found(text), 0u) << text;
  }
  for (const char* text : {"[](b.md)", "[](../plugins/y.cpp)", "[](to/b.md#no)", "[](to/b.md#one-2)", "[](#it)"}) {
    EXPECT_EQ(found(text), 1u) << text;
  }
  EXPECT_EQ(link_breaches({{"a.md", "\n[](b.md)"}}, {"a.md"}),
            Breaches{"a.md:2: b.md: there is no such file or folder"});
}

TEST(LinkRules, pages_without_a_link_to_them_are_found) {
  const Pages pages = {{"docs/README.md", "[](a.md)"},
                       {"docs/a.md", "[](b/c.md)"},
                       {"docs/b/c.md", ""},
                       {"docs/b/d.md", "[](c.md)"},
                       {"e.md", ""}};
  const Breaches breaches = unreached_breaches(pages, "docs/README.md", "docs/");
  ASSERT_EQ(breaches.size(), 1u);
  EXPECT_EQ(breaches.front().find("docs/b/d.md: "), 0u);
}

}  // namespace
}  // namespace foredraw::architecture::link_test
