#include <foredraw/platform/files.h>
#include <foredraw/platform/private/descriptor.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace foredraw {

namespace {

namespace fs = std::filesystem;

std::string reason() { return std::strerror(errno); }

constexpr std::size_t step = std::size_t{1} << 20;

/// How many bytes a regular file has at the moment; 0 of what is none, such as a pipe.
std::size_t size_now(int descriptor) {
  struct stat facts {};
  const bool is_file = ::fstat(descriptor, &facts) == 0 && S_ISREG(facts.st_mode);
  return is_file ? static_cast<std::size_t>(facts.st_size) : 0;
}

bool read_all(int descriptor, std::vector<std::byte>& bytes, std::size_t at_most) {
  bytes.reserve(std::min(size_now(descriptor) + 1, at_most));  // one more, to see the end without growing
  while (bytes.size() < at_most) {
    const std::size_t old = bytes.size();
    const std::size_t room = bytes.capacity() > old ? bytes.capacity() - old : step;
    const std::size_t wanted = std::min({step, room, at_most - old});
    bytes.resize(old + wanted);
    const ssize_t got = ::read(descriptor, bytes.data() + old, wanted);
    bytes.resize(old + (got > 0 ? static_cast<std::size_t>(got) : 0));
    if (got == 0) return true;
    if (got < 0 && errno != EINTR) return false;
  }
  return true;
}

bool write_whole(int descriptor, const OutputFile& file) {
  bool is_whole = write_all(descriptor, file.bytes);
  const OutputFile::Put put = [&](std::string_view text) {
    is_whole = is_whole && write_all(descriptor, std::as_bytes(std::span(text)));
  };
  if (file.rest) file.rest(put);
  return is_whole;
}

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

/// A file that is being written, under a name of its own in the folder of its place, so that the rename stays within
/// one file system. It is locked as long as its writer lives: whoever finds one that nobody locks may remove it. Names
/// are counted from 0, so that leftovers are found by their names: a look through the folder for each file would take
/// the square of a large folder.
class Part {
 public:
  explicit Part(const fs::path& place) {
    remove_leftovers(place);
    for (int n = 0;; ++n) {
      path_ = named(place, n);
      descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC | O_CREAT | O_EXCL, 0666);
      if (descriptor_ < 0 && errno == EEXIST) continue;  // of a living writer
      if (descriptor_ < 0) return;
      const bool is_taken = ::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
      struct stat status {};
      if (::stat(place.c_str(), &status) == 0) ::fchmod(descriptor_, status.st_mode & 07777);  // who might read the old
      if (!is_taken && ::fstat(descriptor_, &status) == 0 && status.st_nlink > 0) return;
      ::close(descriptor_);  // between creation and lock somebody took it for a leftover
    }
  }
  Part(Part&& other) noexcept
      : path_(std::exchange(other.path_, {})), descriptor_(std::exchange(other.descriptor_, -1)) {}
  ~Part() {
    if (descriptor_ < 0) return;
    if (!path_.empty()) ::unlink(path_.c_str());
    ::close(descriptor_);
  }

  /// What writers that were killed had begun.
  static void remove_leftovers(const fs::path& place) {
    for (int n = 0; remove_leftover(named(place, n)) || n < usual_writers; ++n) {
    }
  }

  int descriptor() const { return descriptor_; }
  const fs::path& path() const { return path_; }

  bool move_to(const fs::path& place) {
    if (::rename(path_.c_str(), place.c_str()) != 0) return false;
    path_.clear();
    return true;
  }

 private:
  static constexpr int usual_writers = 8;             ///< to one place at once: so many names are looked at
  static constexpr std::size_t most_of_a_name = 100;  ///< a name as long as file systems allow has no room for more

  static fs::path named(const fs::path& place, int number) {
    std::string name = place.filename().string();
    std::size_t length = std::min(name.size(), most_of_a_name);
    while (length > 0 && length < name.size() && (name[length] & 0xC0) == 0x80) --length;  // no half letters
    // replace_filename() of libstdc++ 12 leaves a path that can not be freed where memory runs out in it.
    return place.parent_path() / (name.substr(0, length) + ".foredraw-part" + std::to_string(number));
  }

  /// Whether there was such a file. One that is locked here nobody else removes, so that the name stays its name from
  /// where it is seen to be.
  static bool remove_leftover(const fs::path& part) {
    const Descriptor left(::open(part.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
    if (left.get() < 0) return false;
    struct stat opened {};
    struct stat named {};
    const bool is_ours = ::flock(left.get(), LOCK_EX | LOCK_NB) == 0 && ::fstat(left.get(), &opened) == 0 &&
                         ::lstat(part.c_str(), &named) == 0;
    if (is_ours && opened.st_ino == named.st_ino && opened.st_dev == named.st_dev) ::unlink(part.c_str());
    return true;
  }

  fs::path path_;
  int descriptor_ = -1;
};

/// The end of a symbolic link, so that what is replaced is the file and not the link.
fs::path end_of_links(const fs::path& path) {
  std::error_code error;
  fs::path end = fs::canonical(path, error);
  return error ? path : end;
}

bool is_folder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

/// A device or a pipe has no content that could be replaced: it is written to as it stands.
bool is_stream(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

void cannot_open(const OutputFile& file, Diagnostics& diagnostics) {
  const std::string hint =
      errno == ENAMETOOLONG ? "give it a shorter name" : "check that the folder exists and that you may write to it";
  diagnostics.error({.file = file.path.string()}, "cannot-write", "cannot be written: " + reason(), hint);
}

/// Its part has another name, so that nobody else would say so before the others are in their places.
bool is_too_long(const fs::path& place) {
  struct stat ignored {};
  return ::lstat(place.c_str(), &ignored) != 0 && errno == ENAMETOOLONG;
}

void cannot_finish(const OutputFile& file, Diagnostics& diagnostics) {
  diagnostics.error({.file = file.path.string()}, "cannot-write", "could not be written completely: " + reason(),
                    "check that the disk has room");
}

/// On the disk whole before it takes another's place: a power cut may come at any moment too.
std::optional<Part> part_of(const fs::path& place, const OutputFile& file, Diagnostics& diagnostics) {
  Part part(place);
  if (part.descriptor() < 0) {
    cannot_open(file, diagnostics);
  } else if (!write_whole(part.descriptor(), file) || ::fsync(part.descriptor()) != 0) {
    cannot_finish(file, diagnostics);
  } else {
    return part;
  }
  return std::nullopt;
}

/// Whether the file holds exactly these bytes. It is read in steps: it may be as large as any.
bool holds(int descriptor, std::span<const std::byte> bytes) {
  std::vector<std::byte> read(std::min(bytes.size() + 1, step));
  while (true) {
    const ssize_t got = ::read(descriptor, read.data(), std::min(read.size(), bytes.size() + 1));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return got == 0 && bytes.empty();
    const auto length = static_cast<std::size_t>(got);
    if (length > bytes.size() || std::memcmp(read.data(), bytes.data(), length) != 0) return false;
    bytes = bytes.subspan(length);
  }
}

bool hold_the_same(int a, int b) {
  std::vector<std::byte> read;
  read.reserve(step);
  while (read_all(a, read, step)) {
    if (read.empty()) return true;
    std::vector<std::byte> other;
    other.reserve(read.size());
    if (!read_all(b, other, read.size()) || other != read) return false;
    read.clear();
  }
  return false;
}

/// A regular file with these bytes already. What is made while it is written is known only afterwards.
bool is_there_already(const fs::path& place, const OutputFile& file) {
  const Descriptor old(::open(place.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat status {};
  return old.get() >= 0 && !file.rest && ::fstat(old.get(), &status) == 0 && S_ISREG(status.st_mode) &&
         static_cast<std::size_t>(status.st_size) == file.bytes.size() && holds(old.get(), file.bytes);
}

bool is_there_already(const fs::path& place, const Part& part) {
  const Descriptor old(::open(place.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  const Descriptor made(::open(part.path().c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status {};
  return old.get() >= 0 && made.get() >= 0 && ::fstat(old.get(), &status) == 0 && S_ISREG(status.st_mode) &&
         static_cast<std::size_t>(status.st_size) == size_now(made.get()) && hold_the_same(old.get(), made.get());
}

bool write_stream(const OutputFile& file, Diagnostics& diagnostics) {
  const Descriptor out(::open(file.path.c_str(), O_WRONLY | O_CLOEXEC));
  if (out.get() < 0) {
    cannot_open(file, diagnostics);
    return false;
  }
  if (write_whole(out.get(), file)) return true;
  cannot_finish(file, diagnostics);
  return false;
}

/// Renames reach the disk with the folder. Where that can not be asked for, they come in time.
void settle(const fs::path& folder) {
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_CLOEXEC | O_DIRECTORY));
  if (opened.get() >= 0) ::fsync(opened.get());
}

}  // namespace

std::optional<std::vector<std::byte>> read_file(const fs::path& path, Diagnostics& diagnostics, std::size_t at_most,
                                                FilesRead* files) {
  const Descriptor in(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status {};
  if (in.get() < 0 || ::fstat(in.get(), &status) != 0) {
    const bool missing = errno == ENOENT;
    if (files != nullptr && missing) files->missing(path);
    diagnostics.error({.file = path.string()}, missing ? "no-such-file" : "cannot-read",
                      missing ? "there is no such file" : "cannot be read: " + reason());
    return std::nullopt;
  }
  if (S_ISDIR(status.st_mode)) {
    diagnostics.error({.file = path.string()}, "is-a-folder", "is a folder; a file was expected");
    return std::nullopt;
  }
  std::vector<std::byte> bytes;
  if (S_ISREG(status.st_mode)) bytes.reserve(std::min(at_most, static_cast<std::size_t>(status.st_size) + step));
  if (!read_all(in.get(), bytes, at_most)) {
    diagnostics.error({.file = path.string()}, "cannot-read", "cannot be read: " + reason());
    return std::nullopt;
  }
  if (files != nullptr) files->read(path, at_most, bytes);
  return bytes;
}

std::optional<std::vector<std::byte>> read_standard_input(Diagnostics& diagnostics) {
  std::vector<std::byte> bytes;
  if (!read_all(STDIN_FILENO, bytes, std::numeric_limits<std::size_t>::max())) {
    diagnostics.error({.file = "standard input"}, "cannot-read", "cannot be read: " + reason());
    return std::nullopt;
  }
  return bytes;
}

bool write_standard_output(std::span<const std::byte> bytes, Diagnostics& diagnostics) {
  if (write_all(STDOUT_FILENO, bytes)) return true;
  diagnostics.error({.file = "standard output"}, "cannot-write", "cannot be written: " + reason());
  return false;
}

bool write_files(std::span<const OutputFile> files, Diagnostics& diagnostics) {
  struct Pending {
    const OutputFile* file;
    fs::path place, folder;
    std::optional<Part> part;  ///< none: a stream, or there already
    bool is_stream;
  };
  std::vector<Pending> pending;
  for (const OutputFile& file : files) {
    fs::path place = end_of_links(file.path);
    if (is_folder(place)) {
      diagnostics.error({.file = file.path.string()}, "is-a-folder", "is a folder; a file was expected");
      return false;
    }
    const auto is_named_before = [&](const Pending& other) {
      return other.place.lexically_normal() == place.lexically_normal();
    };
    if (std::ranges::any_of(pending, is_named_before)) {
      diagnostics.error({.file = file.path.string()}, "outputs-meet", "is named for two outputs",
                        "give each a file of its own; a .gltf has its bytes in the .bin beside it");
      return false;
    }
    if (is_too_long(place)) {
      cannot_open(file, diagnostics);
      return false;
    }
    const bool stream = is_stream(place);
    const bool is_there = !stream && is_there_already(place, file);
    std::optional<Part> part = stream || is_there ? std::nullopt : part_of(place, file, diagnostics);
    if (!stream && !is_there && !part) return false;
    if (is_there) Part::remove_leftovers(place);
    if (part && file.rest && is_there_already(place, *part)) part.reset();
    fs::path folder = folder_of(place);
    pending.push_back({&file, std::move(place), std::move(folder), std::move(part), stream});
  }
  // The first last, and when the others are there for good. Nothing takes memory between them.
  for (std::size_t i = pending.size(); i-- > 0;) {
    auto& [file, place, folder, part, is_stream] = pending[i];
    if (!part && !is_stream) continue;
    if (is_stream) {
      if (!write_stream(*file, diagnostics)) return false;
    } else if (!part->move_to(place)) {
      diagnostics.error({.file = file->path.string()}, "cannot-write", "cannot be moved into place: " + reason());
      return false;
    } else {
      settle(folder);
    }
  }
  return true;
}

}  // namespace foredraw
