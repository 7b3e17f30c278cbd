// Whatever is done to a tree of JSON, where memory runs out it throws, is still whole, and leaves nothing behind.
#include <foredraw/io/text/private/json_tree.h>

#include <gtest/gtest.h>

#include <functional>
#include <new>
#include <vector>

#include "c/counted_memory.h"

namespace foredraw::json_tree_test {
namespace {

using testing::held;
using testing::left;

const char* const text = "a text that no small string holds";

/// Each allocation fails once.
void expect_survives(const std::function<void()>& work) {
  work();
  int failed = 0;
  for (bool is_done = false; !is_done;) {
    const long before = held;
    left = failed;
    try {
      work();
      is_done = true;
    } catch (const std::bad_alloc&) {
      ++failed;
    }
    left = -1;
    ASSERT_EQ(held, before) << failed;
  }
  EXPECT_GT(failed, 0);
}

TEST(JsonTree, NullBecomesAnObject) {
  expect_survives([] {
    Json json;
    json["asset"]["version"] = text;
    json["extras"].update(JsonObject{{"a", 1}});
  });
}

TEST(JsonTree, NullBecomesAList) {
  expect_survives([] {
    Json json;
    json["pushed"].push_back(text);
    json["made"].emplace_back(1);
    json["named"][3] = text;
    json["braced"].push_back({1, 2, text});
  });
}

TEST(JsonTree, BracesBecomeAnObject) {
  expect_survives([] {
    const Json json =
        JsonObject{{"extensions", JsonObject{{text, JsonObject{{"fallback", true}}}}}, {"offset", {1, 2}}};
    Json copy = json;
    copy["offset"] = json;
  });
}

TEST(JsonTree, ListsOfOthersBecomeOne) {
  expect_survives([] {
    Json json = std::vector<float>{1, 2, 3};
    json = Json::array_t{1, 2, text};
    json.insert(json.begin(), json);
  });
}

TEST(JsonTree, IsEmptied) {
  expect_survives([] {
    Json json = Json::object();
    json.erase("nothing");
    json["one"] = text, json["two"] = Json::array(), json["three"] = Json::object();
    json.erase("one");
    json["two"].clear(), json["three"].clear();
    json.clear();
  });
}

}  // namespace
}  // namespace foredraw::json_tree_test
