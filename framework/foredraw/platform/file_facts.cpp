#include <foredraw/base/streamed_hash.h>
#include <foredraw/platform/file_facts.h>
#include <foredraw/platform/private/descriptor.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <ctime>

namespace foredraw {

namespace {

constexpr std::string_view begun = ".part-";
constexpr std::size_t hashed_at_once = std::size_t{1} << 18;

std::int64_t nanoseconds(const struct timespec& time) {
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

}  // namespace

std::optional<FileFacts> file_facts(const std::filesystem::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return FileFacts{static_cast<std::uint64_t>(status.st_size), status.st_ino, status.st_dev,
                   nanoseconds(status.st_mtim), nanoseconds(status.st_ctim)};
}

/// Linux lends a file to be read only where nobody has it open to write. The loan is given back at once; who asks for
/// the file in between waits that long, and the signal that asks for it back is one that does nothing.
std::optional<bool> is_open_for_writing(const std::filesystem::path& path) {
#ifdef F_SETLEASE
  const Descriptor opened(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (opened.get() < 0 || ::fcntl(opened.get(), F_SETSIG, SIGURG) != 0) return std::nullopt;
  if (::fcntl(opened.get(), F_SETLEASE, F_RDLCK) == 0) {
    ::fcntl(opened.get(), F_SETLEASE, F_UNLCK);
    return false;
  }
  if (errno == EAGAIN) return true;
#endif
  return std::nullopt;
}

std::int64_t file_clock() {
  struct timespec now {};
  ::clock_gettime(CLOCK_REALTIME, &now);
  return nanoseconds(now);
}

void mark_as_used(const std::filesystem::path& path) { ::utimensat(AT_FDCWD, path.c_str(), nullptr, 0); }

std::optional<HashedContent> hashed_content(const std::filesystem::path& path, std::uint64_t at_most) {
  const Descriptor in(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (in.get() < 0) return std::nullopt;
  StreamedHash hash;
  HashedContent content;
  std::vector<std::byte> piece(hashed_at_once);
  while (content.bytes < at_most) {
    const std::uint64_t wanted = std::min<std::uint64_t>(piece.size(), at_most - content.bytes);
    const ssize_t got = ::read(in.get(), piece.data(), wanted);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return std::nullopt;
    if (got == 0) break;
    hash.add(std::span(piece).first(static_cast<std::size_t>(got)));
    content.bytes += static_cast<std::uint64_t>(got);
  }
  content.stamp = hash.stamp();
  return content;
}

std::optional<std::vector<std::byte>> read_piece(const std::filesystem::path& path, std::uint64_t offset,
                                                 std::uint64_t length) {
  const Descriptor in(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status {};
  if (in.get() < 0 || ::fstat(in.get(), &status) != 0) return std::nullopt;
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (offset > size || length > size - offset) return std::nullopt;
  std::vector<std::byte> bytes(length);
  for (std::size_t there = 0; there < bytes.size();) {
    const ssize_t got =
        ::pread(in.get(), bytes.data() + there, bytes.size() - there, static_cast<off_t>(offset + there));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return std::nullopt;
    there += static_cast<std::size_t>(got);
  }
  return bytes;
}

std::string place_file(const std::filesystem::path& path, std::span<const std::span<const std::byte>> pieces) {
  std::string part;
  int number = -1;
  for (int n = 0; number < 0; ++n) {
    part = path.string() + std::string(begun) + std::to_string(::getpid()) + '-' + std::to_string(::gettid()) + '-' +
           std::to_string(n);
    number = ::open(part.c_str(), O_WRONLY | O_CLOEXEC | O_CREAT | O_EXCL, 0666);
    if (number < 0 && errno != EEXIST) return std::strerror(errno);
  }
  std::string why;
  {
    const Descriptor out(number);
    for (std::span<const std::byte> piece : pieces) {
      if (why.empty() && !write_all(out.get(), piece)) why = std::strerror(errno);
    }
  }
  if (why.empty() && ::rename(part.c_str(), path.c_str()) != 0) why = std::strerror(errno);
  if (!why.empty()) ::unlink(part.c_str());
  return why;
}

bool is_begun_file(const std::filesystem::path& path) {
  return path.filename().native().find(begun) != std::string::npos;
}

}  // namespace foredraw
