#include "support/program.h"

#include <foredraw/platform/file_facts.h>
#include <foredraw/platform/files.h>
#include <foredraw/platform/program_stamp.h>
#include <foredraw/platform/spool.h>

#include <thread>

namespace foredraw::file_facts_test {
namespace {

namespace fs = std::filesystem;

class FileFactsOf : public testing::InFolder {};
class SpoolIn : public testing::InFolder {};

TEST_F(FileFactsOf, ChangeWithTheFile) {
  const fs::path file = folder_ / "a";
  EXPECT_FALSE(file_facts(file));
  testing::put(file, "old");
  const auto before = file_facts(file);
  ASSERT_TRUE(before);
  EXPECT_EQ(before->size, 3u);
  EXPECT_EQ(file_facts(file), before);
  EXPECT_LE(before->written, file_clock());
  const fs::file_time_type time = fs::last_write_time(file);
  const auto changed_once_more = [&] {
    testing::put(file, "new");
    fs::last_write_time(file, time);  // as who copies with times does
    return file_facts(file);
  };
  auto after = changed_once_more();
  while (after->changed == before->changed) after = changed_once_more();  // until the file system's clock ticks
  EXPECT_EQ(after->written, before->written);
  EXPECT_NE(after, before) << "the time of the change can not be set back";
  EXPECT_FALSE(file_facts(folder_)) << "a folder is no file";
}

TEST_F(FileFactsOf, ContentIsHashedAsItIsRead) {
  testing::put(folder_ / "a", std::string(700'000, 'x').append("y"));
  Diagnostics diagnostics;
  const auto whole = read_file(folder_ / "a", diagnostics);
  const auto content = hashed_content(folder_ / "a", FileRead::all_of_it);
  ASSERT_TRUE(content);
  EXPECT_EQ(content->bytes, 700'001u);
  EXPECT_EQ(content->stamp, content_hash(*whole));
  const auto beginning = hashed_content(folder_ / "a", 5);
  EXPECT_EQ(beginning->bytes, 5u);
  EXPECT_EQ(beginning->stamp, content_hash(std::span(*whole).first(5)));
  EXPECT_FALSE(hashed_content(folder_ / "none", 5));
}

TEST_F(FileFactsOf, PiecesAreWholeOrNothing) {
  testing::put(folder_ / "a", "0123456789");
  const auto piece = read_piece(folder_ / "a", 3, 4);
  ASSERT_TRUE(piece);
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(piece->data()), piece->size()), "3456");
  EXPECT_TRUE(read_piece(folder_ / "a", 10, 0));
  EXPECT_FALSE(read_piece(folder_ / "a", 8, 3));
  EXPECT_FALSE(read_piece(folder_ / "a", 11, 0));
}

TEST_F(FileFactsOf, WhatIsPlacedComesWholeAndLeavesNothingBeside) {
  const std::string a = "first, ", b = "second";
  const std::vector<std::span<const std::byte>> pieces{std::as_bytes(std::span(a)), std::as_bytes(std::span(b))};
  EXPECT_EQ(place_file(folder_ / "a", pieces), "");
  EXPECT_EQ(testing::content(folder_ / "a"), "first, second");
  EXPECT_NE(place_file(folder_ / "no folder" / "a", pieces), "");
  fs::create_directory(folder_ / "in the way");
  testing::put(folder_ / "in the way" / "a", "");
  EXPECT_NE(place_file(folder_ / "in the way", pieces), "");
  EXPECT_EQ(files(), (std::vector<std::string>{"a", "in the way"}));
  EXPECT_TRUE(is_begun_file("x/name.part-12-13-0"));
  EXPECT_FALSE(is_begun_file("x/name.part"));
}

TEST_F(SpoolIn, GivesBackWhatManyPutAside) {
  Spool spool(folder_);
  EXPECT_TRUE(files().empty()) << "nobody sees it, and nobody has to remove it";
  std::vector<std::thread> writers;
  std::vector<std::vector<Spool::Place>> places(4, std::vector<Spool::Place>(100));
  const auto text = [](std::size_t writer, std::size_t i) {
    return std::string(writer * 100 + i, static_cast<char>('a' + writer)) + std::to_string(i);
  };
  for (std::size_t w = 0; w < places.size(); ++w) {
    writers.emplace_back([&, w] {
      for (std::size_t i = 0; i < 100; ++i) places[w][i] = spool.put(text(w, i));
    });
  }
  for (std::thread& writer : writers) writer.join();
  for (std::size_t w = 0; w < places.size(); ++w) {
    for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(spool.get(places[w][i]), text(w, i));
  }
  EXPECT_THROW(Spool(folder_ / "none"), std::runtime_error);
}

TEST(ProgramStamp, IsTheSameWithinAProgram) {
  EXPECT_EQ(program_stamp(), program_stamp());
  EXPECT_NE(program_stamp(), Stamp{});
}

}  // namespace
}  // namespace foredraw::file_facts_test
