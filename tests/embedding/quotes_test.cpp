// The code that docs/embedding.md shows is code that the tests build and run.

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace foredraw {
namespace {

std::string text_of(const std::string& file) {
  std::ifstream stream(testing::project_file(file), std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(Embedding, DocumentationQuotesWhatIsCompiled) {
  const std::string page = text_of("docs/embedding.md");
  const std::string sources =
      text_of("tests/embedding/functions/main.cpp") + text_of("tests/embedding/pipeline/main.cpp");
  const std::string begin = "```cpp\n";
  int quotes = 0;
  for (std::size_t at = page.find(begin); at != std::string::npos; at = page.find(begin, at)) {
    at += begin.size();
    const std::string quote = page.substr(at, page.find("```", at) - at);
    EXPECT_NE(sources.find(quote), std::string::npos) << "not in the sources:\n" << quote;
    ++quotes;
  }
  EXPECT_GE(quotes, 5);
}

}  // namespace
}  // namespace foredraw
