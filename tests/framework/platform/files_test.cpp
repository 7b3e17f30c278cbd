#include <foredraw/platform/files.h>

#include "support/test_folder.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cstring>
#include <fstream>
#include <new>
#include <thread>
#include <tuple>

namespace foredraw::files_test {
namespace {

namespace fs = std::filesystem;

std::vector<std::byte> bytes_of(const std::string& text) {
  std::vector<std::byte> bytes(text.size());
  std::memcpy(bytes.data(), text.data(), text.size());
  return bytes;
}

std::string text_of(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

class Files : public ::testing::Test {
 protected:
  Files() { fs::create_directory(folder_); }

  static void put(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }
  static std::string get(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  bool write(const std::vector<OutputFile>& files) { return write_files(files, diagnostics_); }
  std::size_t files_in_folder() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  std::string only_code() const { return diagnostics_.all().size() == 1 ? diagnostics_.all()[0].code : "not one"; }
  std::string only_file() const { return diagnostics_.all().at(0).where.file; }

  const testing::TestFolder own_;
  const fs::path folder_ = own_.path() / "with blanks";
  Diagnostics diagnostics_;
};

TEST_F(Files, ReadWhole) {
  std::string content(3'000'001, 'x');  // more than one step of reading
  content[0] = '\0';
  content.back() = '\xff';
  put(folder_ / "big", content);
  put(folder_ / "empty", "");
  const auto big = read_file(folder_ / "big", diagnostics_);
  ASSERT_TRUE(big);
  EXPECT_TRUE(text_of(*big) == content);
  const auto empty = read_file(folder_ / "empty", diagnostics_);
  ASSERT_TRUE(empty);
  EXPECT_TRUE(empty->empty());
  EXPECT_TRUE(diagnostics_.empty());
}

TEST_F(Files, ReadMissing) {
  EXPECT_FALSE(read_file(folder_ / "nowhere.glb", diagnostics_));
  EXPECT_EQ(only_code(), "no-such-file");
  EXPECT_EQ(only_file(), (folder_ / "nowhere.glb").string());
}

TEST_F(Files, ReadFolder) {
  EXPECT_FALSE(read_file(folder_, diagnostics_));
  EXPECT_EQ(only_code(), "is-a-folder");
}

TEST_F(Files, ReadBelowAFile) {
  put(folder_ / "file", "x");
  EXPECT_FALSE(read_file(folder_ / "file" / "below", diagnostics_));
  EXPECT_EQ(only_code(), "cannot-read");
}

TEST_F(Files, ReadUnreadable) {
  put(folder_ / "locked", "x");
  fs::permissions(folder_ / "locked", fs::perms::none);
  if (std::ifstream(folder_ / "locked").good()) GTEST_SKIP() << "this user may read everything";
  EXPECT_FALSE(read_file(folder_ / "locked", diagnostics_));
  EXPECT_EQ(only_code(), "cannot-read");
}

TEST_F(Files, ReadThatFailsAfterItBegan) {
  const fs::path memory = "/proc/self/mem";  // opens, but nobody may read what lies at 0
  if (!fs::exists(memory)) GTEST_SKIP() << "this system has no such file";
  EXPECT_FALSE(read_file(memory, diagnostics_));
  EXPECT_EQ(only_code(), "cannot-read");
}

TEST_F(Files, WriteAndReadBack) {
  ASSERT_TRUE(write({{folder_ / "a.gltf", bytes_of("{}")},
                     {folder_ / "a.bin", bytes_of(std::string("\0\1", 2))},
                     {folder_ / "Größe ü.bin", {}}}));
  EXPECT_EQ(text_of(*read_file(folder_ / "a.gltf", diagnostics_)), "{}");
  EXPECT_EQ(get(folder_ / "a.bin"), std::string("\0\1", 2));
  EXPECT_EQ(get(folder_ / "Größe ü.bin"), "");
  EXPECT_EQ(files_in_folder(), 3u) << "nothing else is left";
  EXPECT_TRUE(diagnostics_.empty());
}

TEST_F(Files, TheRestIsMadeWhileItIsWritten) {
  const OutputFile file{folder_ / "a", bytes_of("first, "), [](const OutputFile::Put& put) {
                          put("second, ");
                          put("third");
                        }};
  ASSERT_TRUE(write({file}));
  EXPECT_EQ(get(folder_ / "a"), "first, second, third");
}

TEST_F(Files, WhoseRestThrowsStaysAsItWas) {
  put(folder_ / "a", "old");
  const OutputFile file{folder_ / "a", {}, [](const OutputFile::Put& put) {
                          put("new");
                          throw std::bad_alloc();
                        }};
  EXPECT_THROW(write({file}), std::bad_alloc);
  EXPECT_EQ(get(folder_ / "a"), "old");
  EXPECT_EQ(files_in_folder(), 1u);
}

TEST_F(Files, WriteNothing) { EXPECT_TRUE(write({})); }

TEST_F(Files, OverwritingReplacesTheWhole) {
  put(folder_ / "a", "a long text that was there before");
  ASSERT_TRUE(write({{folder_ / "a", bytes_of("short")}}));
  EXPECT_EQ(get(folder_ / "a"), "short");
}

/// Its inode and its time, which a file keeps as long as nobody replaces or changes it.
class Untouched {
 public:
  explicit Untouched(fs::path path) : path_(std::move(path)), facts_(facts()) {}
  bool is_so() const { return facts_ == facts(); }

 private:
  using Facts = std::tuple<ino_t, time_t, long, time_t, long>;
  Facts facts() const {
    struct stat status {};
    EXPECT_EQ(::stat(path_.c_str(), &status), 0);
    return {status.st_ino, status.st_mtim.tv_sec, status.st_mtim.tv_nsec, status.st_ctim.tv_sec,
            status.st_ctim.tv_nsec};
  }

  fs::path path_;
  Facts facts_;
};

TEST_F(Files, WhatIsThereAlreadyIsNotTouched) {
  const std::string big(2'500'000, 'x');  // more than one step of reading
  put(folder_ / "a", "same");
  put(folder_ / "big", big);
  put(folder_ / "empty", "");
  put(folder_ / "other", "sane");
  put(folder_ / "longer", "same and more");
  put(folder_ / "rest", "made while it is written");
  put(folder_ / "a.foredraw-part0", "of a writer that was killed");
  const Untouched a(folder_ / "a"), large(folder_ / "big"), empty(folder_ / "empty"), rest(folder_ / "rest");
  const Untouched other(folder_ / "other"), longer(folder_ / "longer");
  ASSERT_TRUE(write({{folder_ / "a", bytes_of("same")},
                     {folder_ / "big", bytes_of(big)},
                     {folder_ / "empty", {}},
                     {folder_ / "rest", bytes_of("made "), [](const auto& put) { put("while it is written"); }},
                     {folder_ / "other", bytes_of("same")},
                     {folder_ / "longer", bytes_of("same")}}));
  EXPECT_TRUE(a.is_so() && large.is_so() && empty.is_so() && rest.is_so());
  EXPECT_FALSE(other.is_so() || longer.is_so());
  EXPECT_EQ(get(folder_ / "other") + get(folder_ / "longer"), "samesame");
  EXPECT_EQ(files_in_folder(), 6u) << "no part is left, of those before neither";
}

TEST_F(Files, WhatOnlyBeginsAlikeIsReplaced) {
  const std::string big(2'500'000, 'x');
  put(folder_ / "a", big + "y");
  put(folder_ / "b", big.substr(1) + "y");
  put(folder_ / "c", big);
  ASSERT_TRUE(write({{folder_ / "a", bytes_of(big)},
                     {folder_ / "b", bytes_of(big)},
                     {folder_ / "c", {}, [&](const auto& put) { put(big + "z"); }}}));
  EXPECT_TRUE(get(folder_ / "a") == big && get(folder_ / "b") == big && get(folder_ / "c") == big + "z");
}

TEST_F(Files, WhoMightReadTheOldMayReadTheNew) {
  put(folder_ / "secret", "old");
  fs::permissions(folder_ / "secret", fs::perms::owner_read | fs::perms::owner_write);
  put(folder_ / "usual", "x");
  ASSERT_TRUE(write({{folder_ / "secret", bytes_of("new")}, {folder_ / "made", bytes_of("new")}}));
  const auto permissions = [&](const char* name) { return fs::status(folder_ / name).permissions(); };
  EXPECT_EQ(permissions("secret"), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(permissions("made"), permissions("usual")) << "as any program makes them";
}

TEST_F(Files, WhoReadsWhileItIsOverwrittenReadsOneOrTheOther) {
  put(folder_ / "a", std::string(1 << 20, 'o'));
  std::ifstream reader(folder_ / "a", std::ios::binary);
  ASSERT_EQ(reader.get(), 'o');
  ASSERT_TRUE(write({{folder_ / "a", bytes_of(std::string(1 << 20, 'n'))}}));
  const std::string rest(std::istreambuf_iterator<char>(reader), {});
  EXPECT_EQ(rest.find('n'), std::string::npos);
  EXPECT_EQ(rest.size(), (1u << 20) - 1);
  EXPECT_EQ(get(folder_ / "a"), std::string(1 << 20, 'n'));
}

TEST_F(Files, AllOrNoneWhereAFolderIsMissing) {
  put(folder_ / "first", "old");
  EXPECT_FALSE(write({{folder_ / "first", bytes_of("new")},
                      {folder_ / "missing" / "second", bytes_of("new")},
                      {folder_ / "third", bytes_of("new")}}));
  EXPECT_EQ(get(folder_ / "first"), "old");
  EXPECT_EQ(files_in_folder(), 1u) << "nothing half done is left";
  EXPECT_EQ(only_code(), "cannot-write");
  EXPECT_EQ(only_file(), (folder_ / "missing" / "second").string());
  EXPECT_FALSE(diagnostics_.all()[0].hint.empty());
}

TEST_F(Files, AllOrNoneWhereAFolderIsInTheWay) {
  put(folder_ / "first", "old");
  fs::create_directory(folder_ / "second");
  EXPECT_FALSE(write({{folder_ / "first", bytes_of("new")}, {folder_ / "second", bytes_of("new")}}));
  EXPECT_EQ(get(folder_ / "first"), "old");
  EXPECT_EQ(files_in_folder(), 2u);
  EXPECT_EQ(only_code(), "is-a-folder");
}

TEST_F(Files, LinksStayAndWhatTheyPointAtIsReplaced) {
  put(folder_ / "file", "old");
  fs::create_symlink("file", folder_ / "link");
  ASSERT_TRUE(write({{folder_ / "link", bytes_of("new")}}));
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(get(folder_ / "file"), "new");
  EXPECT_EQ(files_in_folder(), 2u);
}

TEST_F(Files, NamesMayBeAsLongAsFileSystemsAllow) {
  std::string umlauts = "x";
  for (int i = 0; i < 127; ++i) umlauts += "\xC3\xBC";
  ASSERT_EQ(umlauts.size(), 255u);
  for (const std::string& name : {std::string(255, 'a'), std::string(251, 'a') + ".bin", umlauts}) {
    ASSERT_TRUE(write({{folder_ / name, bytes_of("whole")}})) << to_text(diagnostics_);
    EXPECT_EQ(get(folder_ / name), "whole");
  }
  EXPECT_EQ(files_in_folder(), 3u);
  const std::string stem(251, 'b');
  EXPECT_FALSE(write({{folder_ / (stem + ".gltf"), bytes_of("{}")}, {folder_ / (stem + ".bin"), bytes_of("new")}}));
  EXPECT_EQ(files_in_folder(), 3u) << "nothing is in its place before all can be";
  EXPECT_EQ(only_file(), (folder_ / (stem + ".gltf")).string());
  EXPECT_EQ(diagnostics_.all()[0].hint, "give it a shorter name");
}

TEST_F(Files, LeftoversGoAndLivingWritersStay) {
  for (const char* name :
       {"a.foredraw-part0", "a.foredraw-part1", "a.foredraw-part3", "a.foredraw-parts", "b.foredraw-part0"}) {
    put(folder_ / name, "begun");
  }
  const int living = ::open((folder_ / "a.foredraw-part1").c_str(), O_RDONLY);
  ASSERT_EQ(::flock(living, LOCK_EX | LOCK_NB), 0);
  ASSERT_TRUE(write({{folder_ / "a", bytes_of("new")}}));
  ::close(living);
  EXPECT_EQ(get(folder_ / "a"), "new");
  EXPECT_FALSE(fs::exists(folder_ / "a.foredraw-part0"));
  EXPECT_TRUE(fs::exists(folder_ / "a.foredraw-part1"));
  EXPECT_FALSE(fs::exists(folder_ / "a.foredraw-part3"));
  EXPECT_TRUE(fs::exists(folder_ / "a.foredraw-parts")) << "is no name of ours";
  EXPECT_TRUE(fs::exists(folder_ / "b.foredraw-part0")) << "is what another file left";
}

/// Parts of one name change hands all the time: whoever removes leftovers must not take a living writer's.
TEST_F(Files, ManyMayWriteToOnePlace) {
  std::vector<std::thread> writers;
  std::atomic<int> failed = 0;
  for (int w = 0; w < 12; ++w) {
    writers.emplace_back([&, w] {
      Diagnostics own;
      const OutputFile file{folder_ / "a", bytes_of(std::string(1000, static_cast<char>('a' + w)))};
      for (int i = 0; i < 100; ++i) failed += write_files(std::span(&file, 1), own) ? 0 : 1;
    });
  }
  for (std::thread& writer : writers) writer.join();
  EXPECT_EQ(failed, 0);
  const std::string last = get(folder_ / "a");
  EXPECT_EQ(last, std::string(1000, last.front()));
  EXPECT_EQ(files_in_folder(), 1u);
}

// Whoever writes to /dev/null or to a pipe must not find a plain file in its place afterwards.
TEST_F(Files, PipesAreWrittenToAsTheyStand) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::string got;
  std::thread reader([&] { got = get(pipe); });
  EXPECT_TRUE(write({{pipe, bytes_of("through")}}));
  if (!fs::is_fifo(pipe)) std::ofstream(pipe).put('x');  // or the reader would wait for ever
  reader.join();
  EXPECT_EQ(got, "through");
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_EQ(files_in_folder(), 1u);
}

}  // namespace
}  // namespace foredraw::files_test
