// The code that README.md, docs/guides/embedding.md and the pages of C show is code that the tests build and run.

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace foredraw::quotes_test {
namespace {

std::string text_of(const std::string& file) {
  std::ifstream stream(testing::project_file(file), std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// How many pieces of code in that language the page shows; each has to be found in the sources.
int quotes(const std::string& page, const std::string& sources, const std::string& language = "cpp") {
  const std::string begin = "```" + language + "\n";
  int quotes = 0;
  for (std::size_t at = page.find(begin); at != std::string::npos; at = page.find(begin, at)) {
    at += begin.size();
    const std::string quote = page.substr(at, page.find("```", at) - at);
    EXPECT_NE(sources.find(quote), std::string::npos) << "not in the sources:\n" << quote;
    ++quotes;
  }
  return quotes;
}

TEST(Embedding, DocumentationQuotesWhatIsCompiled) {
  const std::string sources = text_of("tests/embedding/functions/main.cpp") +
                              text_of("tests/embedding/pipeline/main.cpp") +
                              text_of("hosts/embed/examples/displaced_shaders.cpp");
  EXPECT_GE(quotes(text_of("docs/guides/embedding.md"), sources), 5);
}

TEST(Embedding, ThePagesOfCQuoteWhatIsCompiled) {
  EXPECT_EQ(quotes(text_of("docs/reference/c-functions.md"), text_of("tests/c/functions_test.c"), "c"), 3);
  const std::string tools = text_of("tests/embedding/c/tool.c") + text_of("tests/embedding/c/orders.c") +
                            text_of("tests/embedding/c/radial.c");
  EXPECT_EQ(quotes(text_of("docs/reference/c-library.md"), tools, "c"), 3);
}

TEST(Embedding, TheReadmeQuotesWhatIsCompiled) {
  EXPECT_EQ(quotes(text_of("README.md"), text_of("tests/embedding/readme.cpp")), 1);
}

}  // namespace
}  // namespace foredraw::quotes_test
