#include <foredraw/base/files_read.h>
#include <foredraw/base/streamed_hash.h>

#include <gtest/gtest.h>

namespace foredraw::files_read_test {
namespace {

std::span<const std::byte> bytes(std::string_view text) { return std::as_bytes(std::span(text)); }

TEST(FilesRead, TellsEachOnceSortedByPath) {
  FilesRead files;
  files.read("b", FileRead::all_of_it, bytes("beta"));
  files.there("b");
  files.missing("c");
  files.read("a", 3, bytes("alp"));
  files.read("b", FileRead::all_of_it, bytes("beta"));
  files.there("d");
  files.missing("c");
  const auto all = files.all();
  ASSERT_EQ(all.size(), 4u);
  EXPECT_EQ(all[0].path, "a");
  EXPECT_EQ(all[0].at_most, 3u);
  EXPECT_EQ(all[1].found, FileRead::Found::content);
  EXPECT_EQ(all[1].stamp, content_hash(bytes("beta")));
  EXPECT_EQ(all[1].bytes, 4u);
  EXPECT_EQ(all[2].found, FileRead::Found::missing);
  EXPECT_EQ(all[3].found, FileRead::Found::there);
}

TEST(FilesRead, OfOneThatChangedBothStand) {
  FilesRead files;
  files.read("a", FileRead::all_of_it, bytes("old"));
  files.read("a", FileRead::all_of_it, bytes("new"));
  EXPECT_EQ(files.all().size(), 2u);
}

TEST(StreamedHash, IsThatOfTheWhole) {
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += static_cast<char>(i * 7 + i / 256);
  for (const std::size_t piece : {1, 240, 241, 4096, 99'999}) {
    StreamedHash hash;
    for (std::size_t at = 0; at < text.size(); at += piece) hash.add(bytes(std::string_view(text).substr(at, piece)));
    EXPECT_EQ(hash.stamp(), content_hash(bytes(text))) << piece;
  }
  EXPECT_EQ(StreamedHash().stamp(), content_hash(bytes("")));
}

}  // namespace
}  // namespace foredraw::files_read_test
