#include "support/program.h"

#include <foredraw/report/batch_join.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <set>
#include <thread>

namespace foredraw::batch_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Json = nlohmann::ordered_json;

Report report(const std::string& path, double misses_before, double misses_after) {
  Report report;
  report.command = "optimize";
  report.optimized = true;
  report.input = {path, 100};
  report.output = {"out/" + path, 90};
  report.before.metrics.set("cache", "acmr", {misses_before, 10, 0, "per triangle", true});
  report.after.metrics.set("cache", "acmr", {misses_after, 10, 0, "per triangle", true});
  report.after.metrics.set("cache", "worst", {misses_after, 1, 0.5, "per triangle", true, true});
  report.after.triangles = 10;
  return report;
}

Registry cards() {
  Plugin cache;
  cache.kind = Kind::evaluator;
  cache.card = {.name = "cache", .metrics = {{"acmr", "per triangle", ""}, {"worst", "per triangle", "", true, true}}};
  cache.create = [](const Settings&) -> Technique { return std::unique_ptr<Evaluator>(); };
  Registry registry;
  registry.add(cache);
  return registry;
}

class Batches : public ::testing::Test {
 protected:
  void add_three(Batch& batch) {
    batch.add(2, to_json(report("c.glb", 1000, 1000)), Outcome::lost);  // as they come
    batch.add(0, to_json(report("a.glb", 20, 10)), Outcome::done, true);
    batch.add(1, to_json(report("b.glb", 30, 20)), Outcome::in_part);
  }
  static std::string json(const Batch& batch, const std::optional<Shard>& shard = {}, double seconds = 1.5) {
    std::string text;
    batch.write_json(seconds, shard, [&](std::string_view piece) { text += piece; });
    return text;
  }

  const Registry registry_ = cards();
  Spool spool_;
  Diagnostics diagnostics_;
};

TEST_F(Batches, TotalsAreSumsOfWhatWasNotLost) {
  Batch batch("optimize", registry_, spool_);
  add_three(batch);
  EXPECT_EQ(batch.after().triangles, 20u);
  EXPECT_DOUBLE_EQ(batch.after().metrics.find("cache", "acmr")->value(), 1.5);
  EXPECT_DOUBLE_EQ(batch.before().metrics.find("cache", "acmr")->value(), 2.5);
  EXPECT_DOUBLE_EQ(batch.after().metrics.find("cache", "worst")->value(), 20) << "the card says that the worst stands";
}

TEST_F(Batches, ALineForEachFileAndOneForAll) {
  Batch batch("optimize", registry_, spool_);
  add_three(batch);
  const std::string text = batch.to_text(1.5);
  EXPECT_THAT(text, HasSubstr("file   cache acmr        bytes"));
  EXPECT_THAT(text, HasSubstr("a.glb  2.0000 -> 1.0000  100 -> 90   done\n"));
  EXPECT_THAT(text, HasSubstr("b.glb  3.0000 -> 2.0000  100 -> 90   in part: a stage failed\n"));
  EXPECT_THAT(text, HasSubstr("c.glb" + std::string(32, ' ') + "failed: see above\n"));
  EXPECT_THAT(text, HasSubstr("all    2.5000 -> 1.5000  200 -> 180  without 1 failed file\n"));
  EXPECT_THAT(text, HasSubstr("3 files in 1.50 s, 1 of them from the cache\n"));
}

TEST_F(Batches, TheRecordHoldsEveryReport) {
  Batch batch("optimize", registry_, spool_);
  add_three(batch);
  const std::string text = json(batch, Shard{2, 5});
  const auto record = Json::parse(text);
  EXPECT_EQ(text, record.dump(2) + '\n') << "laid out as one";
  EXPECT_EQ(record["batch"], 1);
  EXPECT_EQ(record["shard"]["number"], 2);
  ASSERT_EQ(record["files"].size(), 3u);
  EXPECT_EQ(record["files"][0]["cached"], true);
  EXPECT_FALSE(record["files"][1].contains("cached"));
  EXPECT_EQ(record["files"][1]["outcome"], "in-part");
  EXPECT_EQ(record["files"][0]["report"].dump(2) + '\n', to_json(report("a.glb", 20, 10)));
  EXPECT_DOUBLE_EQ(record["totals"]["metrics"]["cache"]["acmr"]["value"], 1.5);

  Batch empty("optimize", registry_, spool_);
  EXPECT_EQ(json(empty), Json::parse(json(empty)).dump(2) + '\n');
  EXPECT_THAT(empty.to_text(0), HasSubstr("0 files"));
}

/// In whichever sequence threads bring them, each is told once, in the sequence of the files.
TEST_F(Batches, FilesAreToldInTheirSequence) {
  std::vector<std::string> told;
  Batch batch("optimize", registry_, spool_,
              [&](const StoredReport& report, Outcome) { told.push_back(report.input.path); });
  constexpr std::size_t count = 200;
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (std::size_t i = count; i-- > 0;) {
        if (i % 4 == t)
          batch.add(i, to_json(report(std::to_string(i), 0.1 * static_cast<double>(i), 0.3)), Outcome::done);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  ASSERT_EQ(told.size(), count);
  for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(told[i], std::to_string(i));
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += 0.1 * static_cast<double>(i);
  EXPECT_EQ(batch.before().metrics.find("cache", "acmr")->numerator, sum) << "to the last bit";
}

TEST_F(Batches, WhatIsNoReportIsRefused) {
  EXPECT_THROW(stored_report("{}", registry_), std::invalid_argument);
  EXPECT_THROW(stored_report("no JSON", registry_), std::invalid_argument);
}

TEST_F(Batches, FiguresThatAreNoNumbersComeBackAsNone) {
  Report odd = report("a \"b\"\n\xC3\xA4.glb", 20, std::numeric_limits<double>::infinity());
  odd.after.metrics.set("cache", "poses.Walk@0.1.acmr", {3, 2.0, 0.25, "per triangle", true});
  odd.after.metrics.set("cache", "acmr.part", {7, std::nullopt, 0, "", true});
  odd.diagnostics = {{Severity::warning, {"f", 1, 2, "x[0]"}, "code", "message", "hint", 3}};
  const StoredReport stored = stored_report(to_json(odd), registry_);
  EXPECT_TRUE(std::isnan(stored.after.metrics.find("cache", "acmr")->value()));
  EXPECT_EQ(stored.after.metrics.find("cache", "acmr.part")->value(), 7);
  const Figure* posed = stored.after.metrics.find("cache", "poses.Walk@0.1.acmr");
  ASSERT_NE(posed, nullptr);
  EXPECT_EQ(posed->value(), 1.5);
  EXPECT_EQ(posed->error, 0.25);
  EXPECT_EQ(stored.input.path, odd.input.path);
  ASSERT_EQ(stored.diagnostics.size(), 1u);
  EXPECT_EQ(to_text(stored.diagnostics[0]), to_text(odd.diagnostics[0]));
  EXPECT_EQ(stored.diagnostics[0].places, 3u);
}

class Joins : public Batches {
 protected:
  /// Reports of `count` files, in so many parts.
  std::vector<std::string> parts(std::size_t count, std::uint32_t of) {
    std::vector<std::string> texts;
    for (std::uint32_t number = 1; number <= of; ++number) {
      Batch batch("optimize", registry_, spool_);
      std::size_t held = 0;
      for (std::size_t i = 0; i < count; ++i) {
        if (holds({number, of}, name(i))) batch.add(held++, of_file(i), Outcome::done);
      }
      texts.push_back(json(batch, of > 1 ? std::optional(Shard{number, of}) : std::nullopt, 0.5));
    }
    return texts;
  }
  static std::string name(std::size_t i) { return (i < 10 ? "dir/file0" : "dir/file") + std::to_string(i) + ".glb"; }
  static std::string of_file(std::size_t i) {
    return to_json(report(name(i), 0.1 * static_cast<double>(i), 0.7 / static_cast<double>(i + 1)));
  }
  std::string joined(const std::vector<std::string>& texts) {
    BatchJoin join(spool_);
    for (const std::string& text : texts) {
      if (!join.add(text, "part", diagnostics_)) return "refused";
    }
    if (!join.is_whole(diagnostics_)) return "not whole";
    Batch batch(join.command(), registry_, spool_);
    join.put_into(batch);
    return json(batch, {}, 0.5);
  }
};

TEST_F(Joins, GiveTheRecordOfOneRun) {
  const std::string whole = parts(40, 1)[0];
  for (const std::uint32_t of : {1u, 2u, 3u, 16u, 257u}) {
    auto texts = parts(40, of);
    std::reverse(texts.begin(), texts.end());
    EXPECT_EQ(joined(texts), whole) << of;
  }
}

TEST_F(Joins, TellWhatIsMissingOrTwice) {
  auto texts = parts(20, 3);
  EXPECT_EQ(joined({texts[0], texts[2]}), "not whole");
  EXPECT_THAT(to_text(diagnostics_), HasSubstr("of 3 parts these are missing: 2"));
  EXPECT_EQ(joined({texts[0], texts[1], texts[1]}), "refused");
  EXPECT_EQ(joined({texts[0], parts(20, 2)[1]}), "refused");
  EXPECT_EQ(joined({to_json(report("a", 1, 2))}), "refused") << "one file's";
  EXPECT_EQ(joined({texts[0].substr(0, texts[0].size() / 2)}), "refused");
  EXPECT_EQ(joined({"{\"batch\": 2}"}), "refused");
}

TEST_F(Joins, TakeJsonHoweverItIsLaidOut) {
  const auto texts = parts(7, 2);
  EXPECT_EQ(joined({Json::parse(texts[0]).dump(), Json::parse(texts[1]).dump(7)}), parts(7, 1)[0]);
}

TEST(Shards, HoldEachFileOnce) {
  for (const std::uint32_t of : {1u, 2u, 3u, 16u, 257u}) {
    std::vector<int> held(of);
    for (int file = 0; file < 1000; ++file) {
      int times = 0;
      for (std::uint32_t number = 1; number <= of; ++number) {
        if (!holds({number, of}, "props/file" + std::to_string(file) + ".glb")) continue;
        ++times;
        ++held[number - 1];
      }
      EXPECT_EQ(times, 1);
    }
    EXPECT_LT(*std::max_element(held.begin(), held.end()), 1000 / static_cast<int>(of) + 60) << "about as many each";
  }
}

TEST(Shards, AreNumbersFromOneOn) {
  EXPECT_EQ(shard_in("3/16")->number, 3u);
  EXPECT_EQ(shard_in("3/16")->of, 16u);
  for (const char* text : {"", "3", "0/3", "4/3", "1/0", "-1/3", "1/3x", "a/b", "1/", "/3"})
    EXPECT_FALSE(shard_in(text)) << text;
}

}  // namespace
}  // namespace foredraw::batch_test
