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

bool write_beside(const OutputFile& file, Diagnostics& diagnostics) {
  const fs::path part = beside(file.path);
  const Descriptor out(::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (out.get() < 0) {
    diagnostics.error({.file = file.path.string()}, "cannot-write", "can not be written: " + reason(),
                      "check that the folder exists and that you may write to it");
    return false;
  }
  if (write_all(out.get(), file.bytes) && ::fsync(out.get()) == 0) return true;
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
  bool written = true;
  for (const OutputFile& file : files) written = written && write_beside(file, diagnostics);
  for (const OutputFile& file : files) {
    if (!written) break;
    std::error_code error;
    fs::rename(beside(file.path), file.path, error);
    if (error) {
      diagnostics.error({.file = file.path.string()}, "cannot-write", "can not be put in its place: " + error.message());
      written = false;
    }
  }
  if (!written) {
    for (const OutputFile& file : files) {
      std::error_code ignored;
      fs::remove(beside(file.path), ignored);
    }
  }
  return written;
}

}  // namespace foredraw
