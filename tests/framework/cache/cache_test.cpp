#include "support/program.h"

#include <foredraw/base/files_read.h>
#include <foredraw/cache/cache.h>
#include <foredraw/cache/names.h>
#include <foredraw/cache/upkeep.h>

#include <map>
#include <thread>

namespace foredraw::cache_test {
namespace {

namespace fs = std::filesystem;

class CacheIn : public testing::InFolder {
 protected:
  CacheIn() : cache_(*Cache::in(folder_ / "cache", diagnostics_)) {}

  static Stamp key(const std::string& text) { return content_hash(std::as_bytes(std::span(text))); }
  std::string keep(const std::string& name, const std::string& about, const std::vector<std::string>& contents) const {
    std::vector<std::span<const std::byte>> pieces;
    for (const std::string& content : contents) pieces.push_back(std::as_bytes(std::span(content)));
    return cache_.keep(key(name), about, pieces);
  }
  static std::string text(const std::optional<std::vector<std::byte>>& bytes) {
    return bytes ? std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size()) : "damaged";
  }
  auto find(const std::string& name) { return cache_.find(key(name), diagnostics_); }
  static void set_age(const fs::path& file, std::chrono::hours age) {
    fs::last_write_time(file, fs::file_time_type::clock::now() - age);
  }

  Diagnostics diagnostics_;
  Cache cache_;
};

TEST_F(CacheIn, GivesBackWhatIsKept) {
  const std::string large(300'000, 'x');
  ASSERT_EQ(keep("a", "about\nit", {"one", "", large}), "");
  ASSERT_EQ(keep("nothing", "", {}), "");
  const auto entry = find("a");
  ASSERT_TRUE(entry);
  EXPECT_EQ(entry->about(), "about\nit");
  ASSERT_EQ(entry->size(), 3u);
  EXPECT_EQ(text(entry->read(0)) + text(entry->read(1)) + text(entry->read(2)), "one" + large);
  ASSERT_TRUE(find("nothing"));
  EXPECT_EQ(find("nothing")->about(), "");
  EXPECT_FALSE(find("b"));
  EXPECT_TRUE(diagnostics_.empty()) << "what is not there is no damage";
}

/// Wherever a byte is turned, and wherever it is cut off, either nothing is found or what is read says so.
TEST_F(CacheIn, NoDamageGoesUnseen) {
  ASSERT_EQ(keep("a", "what", {"content one", "content two"}), "");
  const fs::path place = cache_.place_of(key("a"));
  const std::string sound = testing::content(place);
  const auto is_seen = [&] {
    Diagnostics told;
    const auto entry = cache_.find(key("a"), told);
    if (!entry) return told.all().size() == 1 && told.all()[0].code == "cache-entry-damaged";
    return !entry->read(0) || !entry->read(1);
  };
  EXPECT_FALSE(is_seen());
  for (std::size_t at = 0; at < sound.size(); ++at) {
    std::string damaged = sound;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    testing::put(place, damaged);
    EXPECT_TRUE(is_seen()) << "byte " << at;
    testing::put(place, sound.substr(0, at));
    EXPECT_TRUE(is_seen()) << "cut off at " << at;
  }
  testing::put(place, sound + "more");
  EXPECT_TRUE(is_seen());
}

/// An entry that was copied under another's name.
TEST_F(CacheIn, EachEntryKnowsItsKey) {
  ASSERT_EQ(keep("a", "", {"one"}), "");
  fs::create_directories(cache_.place_of(key("b")).parent_path());
  fs::copy_file(cache_.place_of(key("a")), cache_.place_of(key("b")));
  EXPECT_FALSE(find("b"));
}

TEST_F(CacheIn, AFolderWithOtherThingsIsNone) {
  EXPECT_TRUE(Cache::in(folder_ / "cache", diagnostics_)) << "again";
  fs::create_directories(folder_ / "other");
  testing::put(folder_ / "other/thesis.txt", "");
  EXPECT_FALSE(Cache::in(folder_ / "other", diagnostics_));
  EXPECT_FALSE(Cache::in(folder_ / "other/thesis.txt", diagnostics_));
  fs::create_directories(folder_ / "empty");
  EXPECT_TRUE(Cache::in(folder_ / "empty", diagnostics_));
}

TEST_F(CacheIn, ManyKeepTheSameAtOnce) {
  std::vector<std::thread> writers;
  for (int w = 0; w < 4; ++w) {
    writers.emplace_back([&] {
      for (int i = 0; i < 50; ++i) {
        keep("same", "about", {"content"});
        Diagnostics told;
        const auto entry = cache_.find(key("same"), told);
        EXPECT_TRUE(entry && text(entry->read(0)) == "content" && told.empty());
      }
    });
  }
  for (std::thread& writer : writers) writer.join();
  EXPECT_EQ(contents_of_cache(folder_ / "cache").entries, 1u);
}

TEST_F(CacheIn, TrimRemovesWhatWasNotUsedForLongest) {
  for (const char* name : {"a", "b", "c", "d"}) ASSERT_EQ(keep(name, "", {std::string(1000, 'x')}), "");
  const fs::path cache = folder_ / "cache";
  set_age(cache_.place_of(key("a")), std::chrono::hours(3));
  set_age(cache_.place_of(key("b")), std::chrono::hours(9));
  set_age(cache_.place_of(key("c")), std::chrono::hours(5));
  ASSERT_TRUE(find("b")) << "and with that it was used";
  testing::put(cache / "entries/mine.txt", "of somebody else");
  testing::put(cache_.place_of(key("a")).string() + ".part-1-2-0", "begun");
  testing::put(cache_.place_of(key("d")).string() + ".part-1-2-0", "being written");
  set_age(cache_.place_of(key("a")).string() + ".part-1-2-0", std::chrono::hours(2));

  const CacheContents before = contents_of_cache(cache);
  EXPECT_EQ(before.entries, 4u);
  EXPECT_EQ(trim_cache(cache, before.bytes), 0u);
  EXPECT_EQ(trim_cache(cache, 2500), 2u);
  EXPECT_FALSE(find("a") || find("c"));
  EXPECT_TRUE(find("b") && find("d"));
  EXPECT_TRUE(fs::exists(cache / "entries/mine.txt"));
  EXPECT_FALSE(fs::exists(cache_.place_of(key("a")).string() + ".part-1-2-0"));
  EXPECT_TRUE(fs::exists(cache_.place_of(key("d")).string() + ".part-1-2-0"));
  EXPECT_EQ(trim_cache(cache, 0), 2u);
  EXPECT_TRUE(Cache::in(cache, diagnostics_)) << "it is a cache still";
}

TEST_F(CacheIn, VerifyRemovesWhatIsDamaged) {
  const std::string large(200'000, 'x');
  for (const char* name : {"a", "b", "c"}) ASSERT_EQ(keep(name, "", {large}), "");
  set_age(cache_.place_of(key("a")), std::chrono::hours(9));
  const auto time = fs::last_write_time(cache_.place_of(key("a")));
  std::string damaged = testing::content(cache_.place_of(key("b")));
  damaged.back() = 'y';
  testing::put(cache_.place_of(key("b")), damaged);
  EXPECT_EQ(verify_cache(folder_ / "cache", cache_, diagnostics_), 1u);
  EXPECT_EQ(diagnostics_.all().size(), 1u);
  EXPECT_EQ(fs::last_write_time(cache_.place_of(key("a"))), time) << "to be looked at is no use";
  EXPECT_TRUE(find("a") && find("c"));
  EXPECT_FALSE(find("b"));
  EXPECT_EQ(verify_cache(folder_ / "cache", cache_, diagnostics_), 0u);
}

class HashesIn : public testing::InFolder {
 protected:
  Stamp now(const char* name) { return stamp_of(hashes_, name); }
  Stamp later(const char* name) { return stamp_of(hashes_later_, name); }
  Stamp stamp_of(const FileHashes& hashes, const char* name) const {
    return hashes.of(folder_ / name, FileRead::all_of_it).value_or(HashedContent{}).stamp;
  }
  std::size_t notes() const {
    std::error_code error;
    std::size_t count = 0;
    for (fs::recursive_directory_iterator at(folder_ / "memory", error), end; !error && at != end; ++at)
      count += at->is_regular_file() ? 1 : 0;
    return count;
  }

  FileHashes hashes_{folder_ / "memory"};
  FileHashes hashes_later_{folder_ / "memory", [] { return file_clock() + 60'000'000'000; }};
};

TEST_F(HashesIn, LargeFilesAreRememberedOnceTheirTimesTell) {
  const std::string large(400'000, 'x');
  testing::put(folder_ / "large", large);
  testing::put(folder_ / "small", "x");
  const Stamp stamp = content_hash(std::as_bytes(std::span(large)));
  fs::last_write_time(folder_ / "large", fs::file_time_type::clock::now() + std::chrono::hours(1));
  EXPECT_EQ(now("large"), stamp);
  EXPECT_EQ(notes(), 0u) << "a change within the same tick would go unseen";
  fs::last_write_time(folder_ / "large", fs::file_time_type::clock::now() - std::chrono::hours(1));
  EXPECT_EQ(later("large"), stamp);
  later("small");
  EXPECT_EQ(notes(), 1u);
  EXPECT_EQ(later("large"), stamp);
  testing::put(folder_ / "large", large.substr(1) + "y");
  EXPECT_NE(now("large"), stamp);
  EXPECT_FALSE(hashes_.of(folder_ / "none", 10));
  EXPECT_EQ(hashes_.of(folder_ / "large", 10)->stamp, content_hash(std::as_bytes(std::span(large).first(10))));
}

/// Whoever turns a byte of a note makes no file another one.
TEST_F(HashesIn, ANoteThatIsDamagedCountsAsNone) {
  testing::put(folder_ / "large", std::string(400'000, 'x'));
  const Stamp stamp = later("large");
  fs::path note;
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / "memory"))
    if (entry.is_regular_file()) note = entry.path();
  const std::string sound = testing::content(note);
  for (const std::string& damaged :
       {std::string(), sound.substr(0, 20), sound.substr(0, sound.size() - 4), "1" + sound}) {
    testing::put(note, damaged);
    EXPECT_EQ(now("large"), stamp) << damaged;
  }
}

TEST(TellChanges, NotOfWhatIsFreshOrOfTomorrow) {
  constexpr std::int64_t second = 1'000'000'000, now = 1000 * second;
  EXPECT_TRUE(tell_changes({1, 1, 1, now - 60 * second, now - 60 * second}, now));
  EXPECT_FALSE(tell_changes({1, 1, 1, now - 60 * second, now - second}, now));
  EXPECT_FALSE(tell_changes({1, 1, 1, now + 60 * second, now - 60 * second}, now));
}

}  // namespace
}  // namespace foredraw::cache_test
