#include <foredraw/platform/files.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace foredraw {

namespace {

namespace fs = std::filesystem;

std::string reason() { return std::strerror(errno); }

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return number_; }

 private:
  int number_;
};

bool read_all(int descriptor, std::vector<std::byte>& bytes) {
  constexpr std::size_t step = std::size_t{1} << 20;
  for (;;) {
    const std::size_t old = bytes.size();
    bytes.resize(old + step);
    const ssize_t got = ::read(descriptor, bytes.data() + old, step);
    bytes.resize(old + (got > 0 ? static_cast<std::size_t>(got) : 0));
    if (got == 0) return true;
    if (got < 0 && errno != EINTR) return false;
  }
}

bool write_all(int descriptor, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t put = ::write(descriptor, bytes.data(), bytes.size());
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(put));
  }
  return true;
}

/// A name in the same folder, so that the rename stays within one file system.
fs::path beside(const fs::path& path) {
  fs::path result = path;
  result += ".part" + std::to_string(::getpid());
  return result;
}

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

bool write_to(const fs::path& path, const OutputFile& file, Diagnostics& diagnostics) {
  const bool stream = is_stream(path);
  const Descriptor out(::open(path.c_str(), O_WRONLY | O_CLOEXEC | (stream ? 0 : O_CREAT | O_TRUNC), 0666));
  if (out.get() < 0) {
    diagnostics.error({.file = file.path.string()}, "cannot-write", "can not be written: " + reason(),
                      "check that the folder exists and that you may write to it");
    return false;
  }
  if (write_all(out.get(), file.bytes) && (stream || ::fsync(out.get()) == 0)) return true;
  diagnostics.error({.file = file.path.string()}, "cannot-write", "could not be written whole: " + reason(),
                    "is there room on the disk?");
  return false;
}

}  // namespace

std::optional<std::vector<std::byte>> read_file(const fs::path& path, Diagnostics& diagnostics) {
  const Descriptor in(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status {};
  if (in.get() < 0 || ::fstat(in.get(), &status) != 0) {
    const bool missing = errno == ENOENT;
    diagnostics.error({.file = path.string()}, missing ? "no-such-file" : "cannot-read",
                      missing ? "there is no such file" : "can not be read: " + reason());
    return std::nullopt;
  }
  if (S_ISDIR(status.st_mode)) {
    diagnostics.error({.file = path.string()}, "is-a-folder", "is a folder; a file was expected");
    return std::nullopt;
  }
  std::vector<std::byte> bytes;
  if (S_ISREG(status.st_mode)) bytes.reserve(static_cast<std::size_t>(status.st_size) + (std::size_t{1} << 20));
  if (!read_all(in.get(), bytes)) {
    diagnostics.error({.file = path.string()}, "cannot-read", "can not be read: " + reason());
    return std::nullopt;
  }
  return bytes;
}

std::optional<std::vector<std::byte>> read_standard_input(Diagnostics& diagnostics) {
  std::vector<std::byte> bytes;
  if (!read_all(STDIN_FILENO, bytes)) {
    diagnostics.error({.file = "standard input"}, "cannot-read", "can not be read: " + reason());
    return std::nullopt;
  }
  return bytes;
}

bool write_standard_output(std::span<const std::byte> bytes, Diagnostics& diagnostics) {
  if (write_all(STDOUT_FILENO, bytes)) return true;
  diagnostics.error({.file = "standard output"}, "cannot-write", "can not be written: " + reason());
  return false;
}

bool write_files(std::span<const OutputFile> files, Diagnostics& diagnostics) {
  std::vector<fs::path> places;
  for (const OutputFile& file : files) places.push_back(end_of_links(file.path));
  bool written = true;
  for (std::size_t i = 0; i < files.size() && written; ++i) {
    if (is_folder(places[i])) {
      diagnostics.error({.file = files[i].path.string()}, "is-a-folder", "is a folder; a file was expected");
      written = false;
    } else if (!is_stream(places[i])) {
      written = write_to(beside(places[i]), files[i], diagnostics);
    }
  }
  for (std::size_t i = 0; i < files.size() && written; ++i) {
    if (is_stream(places[i])) {
      written = write_to(places[i], files[i], diagnostics);
      continue;
    }
    std::error_code error;
    fs::rename(beside(places[i]), places[i], error);
    if (!error) continue;
    diagnostics.error({.file = files[i].path.string()}, "cannot-write", "can not be put in its place: " + error.message());
    written = false;
  }
  for (std::size_t i = 0; i < files.size() && !written; ++i) {
    std::error_code ignored;
    fs::remove(beside(places[i]), ignored);
  }
  return written;
}

}  // namespace foredraw
